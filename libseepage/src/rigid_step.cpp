#include "slope/seepage/rigid_step.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace slope::seepage {

namespace {

// Newton's method needs a first guess whose wetting fronts are about right. Lagged permeability mostly finds one; where
// it only makes things worse, Newton's method begins with the best state so far.
constexpr int lagged_iterations = 3;
constexpr double least_share = 1.0 / 64.0;  // of a step of Newton's method that makes the imbalance larger
// With lagged permeability small steps may be far from the end: they must fall so fast, or be nothing.
constexpr double lagged_reduction = 0.25;
constexpr double nothing = 1.0e-3;          // over the tolerance
constexpr int most_small_steps = 4;         // in a row, with which pressures count as found whatever is missing
constexpr double tolerable_share = 1.0e-8;  // of the stored water, that may be missing (root of the sum of squares)
constexpr double begun_to_fall = 0.97;      // share of the saturated conductivity
constexpr double least_onset = 1.0e-5;      // suction head of that (m)

// Where a step of the pressure goes that starts from one: drying soil stops where its conductivity begins to fall. For
// n < 2 that fall begins with an infinite slope, of which saturated soil knows nothing: from there Newton's method is
// thrown far beyond its aim and back, while from just inside it comes up to it.
double stepped(double pressure, double step, double onset) {
  return pressure > onset ? std::max(pressure + step, onset) : pressure + step;
}

}  // namespace

// The pattern of the matrix is that of the neighbours, with the diagonal.
void RigidStep::find_pattern(const Neighbours& neighbours) {
  const std::size_t n = neighbours.size();
  assembled_.matrix.resize(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  assembled_.matrix.resizeNonZeros(static_cast<Eigen::Index>(n + neighbours.index.size()));
  auto* outer = assembled_.matrix.outerIndexPtr();
  auto* inner = assembled_.matrix.innerIndexPtr();
  std::size_t k = 0;
  for (std::size_t p = 0; p < n; ++p) {
    outer[p] = static_cast<int>(k);
    bool placed = false;
    for (const std::uint32_t q : neighbours.of(p)) {
      if (!placed && q > p) {
        inner[k++] = static_cast<int>(p);
        placed = true;
      }
      inner[k++] = static_cast<int>(q);
    }
    if (!placed) inner[k++] = static_cast<int>(p);
  }
  outer[n] = static_cast<int>(k);
  assembled_.neighbours = neighbours;
}

// The matrix is storage + t L / gamma_w, and unless the permeability is lagged what changes with it, with the rows and
// columns of held particles taken out.
void RigidStep::assemble(const PoreFlow& flow, bool lagged) {
  const HeadOperator& operator_of_head = flow.head_operator();
  const Neighbours& neighbours = operator_of_head.neighbours();
  const std::span<const double> conductance = operator_of_head.conductance();
  double* value = assembled_.matrix.valuePtr();
  const auto* inner = assembled_.matrix.innerIndexPtr();
  std::size_t k = 0, s = 0;
  for (std::size_t p = 0; p < flow.size(); ++p) {
    const double slope = lagged || is_held_[p] != 0 ? 0.0 : flow.conductivity_slope(p);
    const std::size_t end = k + neighbours.of(p).size() + 1;
    double own = stiffness_[p] + flow_scale_ * operator_of_head.diagonal()[p];
    double* diagonal = nullptr;
    for (; k < end; ++k) {
      const auto q = static_cast<std::size_t>(inner[k]);
      if (q == p) {
        diagonal = &value[k];
        continue;
      }
      // what p's pressure changes in the flow from p to q
      const double more = lagged ? 0.0 : flow_scale_ * operator_of_head.flow_slope(p, s, slope, head_[p] - head_[q]);
      value[k] = is_held_[p] != 0 || is_held_[q] != 0 ? 0.0 : -flow_scale_ * conductance[s] - more;
      own += more;
      ++s;
    }
    *diagonal = own;
  }
}

// The water that each particle lacks at the present pressure, and the stiffness of the step's equations.
RigidStep::Imbalance RigidStep::find_imbalance(PoreFlow& flow, const Skeleton& skeleton, const Boundary& boundary) {
  const std::size_t n = flow.size();
  const std::span<const double> pressure = flow.pressure(), pressure_head = flow.pressure_head();
  const std::span<const double> saturation = flow.saturation(), capacity = flow.capacity();
  const PoreFlow::State& state = flow.state();
  const double bulk_modulus = flow.water().bulk_modulus;
  for (std::size_t p = 0; p < n; ++p) head_[p] = pressure_head[p] + skeleton.y[p];
  flow.find_conductances(0.0);
  flow.head_operator().apply(head_, flow_.outflow);
  for (std::size_t p = 0; p < n; ++p) {
    stiffness_[p] = skeleton.volume[p] * skeleton.porosity[p] *
                    (saturation[p] / bulk_modulus + capacity[p] * (1.0 + pressure[p] / bulk_modulus));
    lacking_[p] = state.content[p] + state.defect[p] - flow.water_of(p, skeleton) - time_step_ * flow_.outflow[p];
  }
  boundary_.find(boundary, flow, skeleton.y, head_);
  for (const BoundaryTerm& term : boundary_.terms()) {
    stiffness_[term.particle] += flow_scale_ * term.stiffness();
    lacking_[term.particle] += time_step_ * term.inflow(head_[term.particle]);
  }
  const std::span<const double> flow_diagonal = flow.head_operator().diagonal();
  double sum = 0.0, flows = 0.0;
  for (std::size_t p = 0; p < n; ++p) {
    sum += is_held_[p] != 0 ? 0.0 : lacking_[p] * lacking_[p];
    const double passing = time_step_ * flow_diagonal[p] * head_[p];
    flows += passing * passing;
  }
  return {std::sqrt(sum), std::numeric_limits<double>::epsilon() * std::sqrt(flows)};
}

// Goes a share of the step from a pressure.
RigidStep::Imbalance RigidStep::go_to(PoreFlow& flow, const std::vector<double>& pressure, double share,
                                      const Skeleton& skeleton, const Boundary& boundary) {
  for (std::size_t p = 0; p < pressure.size(); ++p) {
    pressure_[p] = stepped(pressure[p], share * step_[p], drying_onset_[p]);
  }
  flow.set_pressure(pressure_);
  return find_imbalance(flow, skeleton, boundary);
}

// Solves for the pressures' next step. @return whether there is one.
bool RigidStep::find_pressure_step(const PoreFlow& flow, bool lagged) {
  if (!lagged) {
    for (const BoundaryTerm& term : boundary_.terms()) {
      stiffness_[term.particle] -= flow_scale_ * term.conductance_slope();
    }
  }
  Eigen::VectorXd b(static_cast<Eigen::Index>(flow.size()));
  for (std::size_t p = 0; p < flow.size(); ++p) {
    b[static_cast<Eigen::Index>(p)] = is_held_[p] != 0 ? 0.0 : lacking_[p];
  }
  assemble(flow, lagged);
  Eigen::VectorXd solution;
  if (lagged) {
    assembled_.lagged_factorisation.factorize(assembled_.matrix);
    if (assembled_.lagged_factorisation.info() != Eigen::Success) return false;
    solution = assembled_.lagged_factorisation.solve(b);
  } else {
    if (!assembled_.ordering_known) assembled_.factorisation.analyzePattern(assembled_.matrix);
    assembled_.ordering_known = true;
    assembled_.factorisation.factorize(assembled_.matrix);
    if (assembled_.factorisation.info() != Eigen::Success) return false;
    solution = assembled_.factorisation.solve(b);
  }
  std::copy(solution.begin(), solution.end(), step_.begin());
  return solution.allFinite();
}

void RigidStep::find_drying_onsets(const PoreFlow& flow) {
  std::vector<double> of_soil;
  for (const ConductivityCurve& curve : flow.head_operator().curves()) {
    of_soil.push_back(-std::max(curve.suction_head_at(begun_to_fall), least_onset) * flow.water().unit_weight());
  }
  for (std::size_t p = 0; p < flow.size(); ++p) drying_onset_[p] = of_soil[flow.soil_index(p)];
}

SolveReport RigidStep::advance(PoreFlow& flow, double time_step, const Skeleton& skeleton, const Boundary& boundary,
                               double tolerance_pressure, int maximum_iterations) {
  const std::size_t n = flow.size();
  assert(time_step > 0.0 && skeleton.size() == n);
  time_step_ = time_step;
  flow_scale_ = time_step / flow.water().unit_weight();
  for (auto* field : {&drying_onset_, &head_, &stiffness_, &lacking_, &step_, &pressure_, &flow_.outflow}) {
    field->resize(n);
  }
  find_drying_onsets(flow);
  flow.follow(skeleton);
  if (!(assembled_.neighbours == flow.head_operator().neighbours())) {
    find_pattern(flow.head_operator().neighbours());
    assembled_.lagged_factorisation.analyzePattern(assembled_.matrix);
    assembled_.ordering_known = false;
  }
  const std::vector<double> start(flow.pressure().begin(), flow.pressure().end());
  std::vector<double> here = start;
  is_held_.assign(n, 0);
  for (const HeldPressure& held : boundary.held) {
    is_held_[held.particle] = 1;
    here[held.particle] = held.pressure;
  }
  flow.set_pressure(here);

  SolveReport report;
  report.converged = false;
  Imbalance imbalance = find_imbalance(flow, skeleton, boundary);
  std::vector<double> best = here;
  double least_imbalance = imbalance.norm, last_step = 0.0;  // (m2, Pa)
  int small_steps = 0;
  const double balanced = std::max(imbalance.rounding, tolerable_share * flow.stored_water());
  while (!report.converged && report.iterations < maximum_iterations) {
    const bool lagged = report.iterations < lagged_iterations;
    if (report.iterations == lagged_iterations && imbalance.norm > least_imbalance) {
      imbalance = go_to(flow, best, 0.0, skeleton, boundary);
    }
    if (!find_pressure_step(flow, lagged)) break;
    ++report.iterations;
    double largest = 0.0;
    for (std::size_t p = 0; p < n; ++p) largest = std::max(largest, std::abs(step_[p]));
    const bool settles = !lagged || largest <= lagged_reduction * last_step || largest <= nothing * tolerance_pressure;
    small_steps = largest <= tolerance_pressure && settles ? small_steps + 1 : 0;
    last_step = largest;
    here.assign(flow.pressure().begin(), flow.pressure().end());
    const double before = imbalance.norm;
    imbalance = go_to(flow, here, 1.0, skeleton, boundary);
    if (lagged && imbalance.norm < least_imbalance) {
      least_imbalance = imbalance.norm;
      best.assign(flow.pressure().begin(), flow.pressure().end());
    }
    for (double share = 0.5; !lagged && small_steps == 0 && imbalance.norm >= before &&
                             imbalance.norm > imbalance.rounding && share >= least_share;
         share *= 0.5) {
      imbalance = go_to(flow, here, share, skeleton, boundary);
    }
    // where a curve bends, small pressures may hold much water
    report.converged = small_steps >= most_small_steps || (small_steps > 0 && imbalance.norm <= balanced);
  }
  if (!report.converged) {
    flow.set_pressure(start);
    return report;
  }
  change_.resize(n);
  for (std::size_t p = 0; p < n; ++p) {
    change_[p] = flow.pressure()[p] - start[p];
    report.largest_change = std::max(report.largest_change, std::abs(change_[p]));
  }
  flow.head_operator().apply(head_, flow_.outflow);
  boundary_.take_in(head_, flow_);
  flow.book(time_step, skeleton, flow_, boundary_.held());
  return report;
}

}  // namespace slope::seepage
