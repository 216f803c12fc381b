// Implicit steps of pore water in a skeleton that does not move: Newton's method on an assembled matrix.

#include <algorithm>
#include <cmath>
#include <limits>

#include "slope/seepage/pore_flow.hpp"

namespace slope::seepage {

namespace {

// Newton's method needs a first guess whose wetting fronts are about right. Lagged permeability mostly finds one; where
// it only makes things worse, Newton's method begins with the best state so far.
constexpr int lagged_iterations = 3;
constexpr double least_share = 1.0 / 64.0;  // of a step of Newton's method that makes the imbalance larger
// With lagged permeability small steps may be far from the end: they must fall so fast, or be nothing.
constexpr double lagged_reduction = 0.25;
constexpr double nothing = 1.0e-3;  // over the tolerance

}  // namespace

// assembled_.matrix = storage + t L / gamma_w, and unless the permeability is lagged what changes with it, with the
// rows and columns of held particles taken out. The pattern is that of the neighbours, filled in place while they stay
// the same.
void PoreFlow::assemble(double time_step, bool lagged) {
  const double flow_scale = time_step / water_.unit_weight();
  const Neighbours& neighbours = operator_.neighbours();
  const std::size_t n = state_.pressure.size();
  if (!assembled_.pattern_known) {
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
  }
  const std::span<const double> conductance = operator_.conductance();
  double* value = assembled_.matrix.valuePtr();
  const auto* inner = assembled_.matrix.innerIndexPtr();
  std::size_t k = 0, s = 0;
  for (std::size_t p = 0; p < n; ++p) {
    const double slope = lagged || is_held_[p] != 0 ? 0.0 : conductivity_slope(p);
    const std::size_t end = k + neighbours.of(p).size() + 1;
    double own = storage_[p] + flow_scale * operator_.diagonal()[p];
    double* diagonal = nullptr;
    for (; k < end; ++k) {
      const auto q = static_cast<std::size_t>(inner[k]);
      if (q == p) {
        diagonal = &value[k];
        continue;
      }
      // what p's pressure changes in the flow from p to q
      const double more = lagged ? 0.0 : flow_scale * operator_.flow_slope(p, s, slope, head_[p] - head_[q]);
      value[k] = is_held_[p] != 0 || is_held_[q] != 0 ? 0.0 : -flow_scale * conductance[s] - more;
      own += more;
      ++s;
    }
    *diagonal = own;
  }
  assembled_.pattern_known = true;
}

// The water that each particle lacks at the present pressure, right_side_ (m2), and storage_ of the step's equations
// with the conductances of the faces; of the norm, what may be rounding of the flows, rounding_ (m2). @return the norm
// of what is lacking.
double PoreFlow::find_imbalance(double time_step, const Skeleton& skeleton, const Boundary& boundary) {
  const double flow_scale = time_step / water_.unit_weight();
  find_head(skeleton);
  operator_.set_conductivity(conductivity_, pressure_head_, potential_);
  operator_.apply(head_, outflow_);
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) {
    storage_[p] =
        skeleton.volume[p] * skeleton.porosity[p] *
        (saturation_[p] / water_.bulk_modulus + capacity_[p] * (1.0 + state_.pressure[p] / water_.bulk_modulus));
    right_side_[p] = state_.content[p] + state_.defect[p] - water_of(p, skeleton) - time_step * outflow_[p];
  }
  for (const FacePressure& face : boundary.faces) {
    storage_[face.particle] += flow_scale * face_law(face).conductance;
    right_side_[face.particle] += time_step * face_inflow(face, head_[face.particle]);
  }
  for (const Inflow& inflow : boundary.inflows) right_side_[inflow.particle] += time_step * inflow.rate;
  find_drain_laws(boundary);
  for (std::size_t k = 0; k < drain_laws_.size(); ++k) {
    storage_[boundary.drains[k].particle] += flow_scale * drain_laws_[k].slope;
    right_side_[boundary.drains[k].particle] -= time_step * drain_laws_[k].rate;
  }
  find_open_face_laws(boundary);
  for (std::size_t k = 0; k < open_laws_.size(); ++k) {
    const std::size_t p = boundary.open_faces[k].particle;
    storage_[p] += flow_scale * open_laws_[k].conductance(open_parts_[k]);
    right_side_[p] += time_step * open_laws_[k].inflow(open_parts_[k], head_[p]);
  }
  double sum = 0.0, flows = 0.0;
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) {
    sum += is_held_[p] != 0 ? 0.0 : right_side_[p] * right_side_[p];
    const double flow = time_step * operator_.diagonal()[p] * head_[p];
    flows += flow * flow;
  }
  rounding_ = std::numeric_limits<double>::epsilon() * std::sqrt(flows);
  return std::sqrt(sum);
}

// Adds to storage_ what the pressure of their particles changes in the conductances of faces.
void PoreFlow::add_face_slopes(double time_step, const Boundary& boundary) {
  const double flow_scale = time_step / water_.unit_weight();
  const auto add = [&](const FacePressure& face) {
    const FaceLaw law = face_law(face);
    storage_[face.particle] -= flow_scale * (law.slope + law.conductance);
  };
  for (const FacePressure& face : boundary.faces) add(face);
  for (std::size_t k = 0; k < open_laws_.size(); ++k) {
    const OpenFace& face = boundary.open_faces[k];
    if (open_parts_[k] == OpenFaceLaw::Part::wet) add(held_at(face, face.ponding_pressure));
    if (open_parts_[k] == OpenFaceLaw::Part::dry) add(held_at(face, face.lowest_pressure));
  }
}

// Solves for the pressures' next step, work_ (Pa). @return whether there is one.
bool PoreFlow::find_pressure_step(double time_step, const Boundary& boundary, bool lagged) {
  if (!lagged) add_face_slopes(time_step, boundary);
  Eigen::VectorXd b(static_cast<Eigen::Index>(state_.pressure.size()));
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) {
    b[static_cast<Eigen::Index>(p)] = is_held_[p] != 0 ? 0.0 : right_side_[p];
  }
  const bool new_pattern = !assembled_.pattern_known;
  assemble(time_step, lagged);
  Eigen::VectorXd solution;
  if (lagged) {
    if (new_pattern) assembled_.lagged_factorisation.analyzePattern(assembled_.matrix);
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
  std::copy(solution.begin(), solution.end(), work_.begin());
  return solution.allFinite();
}

// Where a step of the pressure goes that starts from one: drying soil stops where its conductivity begins to fall. For
// n < 2 that fall begins with an infinite slope, of which saturated soil knows nothing: from there Newton's method is
// thrown far beyond its aim and back, while from just inside it comes up to it.
double PoreFlow::stepped(std::size_t p, double pressure, double step) const {
  const double onset = drying_onset_[soil_[p]];
  return pressure > onset ? std::max(pressure + step, onset) : pressure + step;
}

SolveReport PoreFlow::advance(double time_step, const Skeleton& skeleton, const Boundary& boundary,
                              double tolerance_pressure, int maximum_iterations) {
  const std::size_t n = state_.pressure.size();
  follow(skeleton);
  const std::vector<double> start = state_.pressure;
  std::fill(is_held_.begin(), is_held_.end(), std::uint8_t{0});
  for (const HeldPressure& held : boundary.held) {
    is_held_[held.particle] = 1;
    state_.pressure[held.particle] = held.pressure;
  }
  evaluate_soil();
  const auto go_to = [&](const std::vector<double>& pressure, double share) {
    for (std::size_t p = 0; p < n; ++p) state_.pressure[p] = stepped(p, pressure[p], share * work_[p]);
    evaluate_soil();
    return find_imbalance(time_step, skeleton, boundary);
  };

  SolveReport report;
  report.converged = false;
  double imbalance = find_imbalance(time_step, skeleton, boundary);
  std::vector<double> here = state_.pressure, best = state_.pressure;
  double least_imbalance = imbalance, last_step = 0.0;  // (m2, Pa)
  while (!report.converged && report.iterations < maximum_iterations) {
    const bool lagged = report.iterations < lagged_iterations;
    if (report.iterations == lagged_iterations && imbalance > least_imbalance) imbalance = go_to(best, 0.0);
    if (!find_pressure_step(time_step, boundary, lagged)) break;
    ++report.iterations;
    double largest = 0.0;
    for (std::size_t p = 0; p < n; ++p) largest = std::max(largest, std::abs(work_[p]));
    const bool settles = !lagged || largest <= lagged_reduction * last_step || largest <= nothing * tolerance_pressure;
    report.converged = largest <= tolerance_pressure && settles;
    last_step = largest;
    here = state_.pressure;
    const double before = imbalance;
    imbalance = go_to(here, 1.0);
    if (lagged && imbalance < least_imbalance) {
      least_imbalance = imbalance;
      best = state_.pressure;
    }
    for (double share = 0.5;
         !lagged && !report.converged && imbalance >= before && imbalance > rounding_ && share >= least_share;
         share *= 0.5) {
      imbalance = go_to(here, share);
    }
  }
  if (!report.converged) {
    state_.pressure = start;
    std::fill(change_.begin(), change_.end(), 0.0);
    evaluate_soil();
    return report;
  }
  for (std::size_t p = 0; p < n; ++p) {
    change_[p] = state_.pressure[p] - start[p];
    report.largest_change = std::max(report.largest_change, std::abs(change_[p]));
  }
  latest_change_ = change_;
  find_flow(boundary);
  book(time_step, skeleton, boundary);
  return report;
}

}  // namespace slope::seepage
