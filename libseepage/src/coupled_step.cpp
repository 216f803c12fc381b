#include "slope/seepage/coupled_step.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "for_each_index.hpp"

namespace slope::seepage {

namespace {

// At most so many times a step is solved until its boundary terms stay with their parts of the laws and its storage
// keeps to the retention curves.
constexpr int most_passes = 20;
constexpr int most_iterations = 500;
// Up to which pairs keep their conductances from one step to the next.
constexpr double conductance_tolerance = 1.0e-3;

// How much further than asked for conjugate gradients reduce a residual, which they weigh by the diagonal: what much
// more permeable soils lack of water counts for too little beside the others.
double tolerance_share_of(const std::vector<Soil>& soils) {
  constexpr double tolerable = 1.0e-3;
  const auto [least, most] = std::ranges::minmax(soils, {}, &Soil::hydraulic_conductivity);
  return std::min(1.0, std::sqrt(least.hydraulic_conductivity / (tolerable * most.hydraulic_conductivity)));
}

}  // namespace

void CoupledStep::resize(std::size_t particles) {
  for (auto* field :
       {&head_, &stiffness_, &right_side_, &diagonal_, &change_, &stress_change_, &storage_offset_, &storage_slope_,
        &touched_, &stress_, &volume_change_, &held_change_, &held_water_, &pressure_, &flow_.outflow}) {
    field->resize(particles, 0.0);
  }
}

SolveReport CoupledStep::solve(PoreFlow& flow, double time_step, const Skeleton& skeleton,
                               std::span<const double> strain, const Boundary& boundary, const VolumeResponse& response,
                               double tolerance) {
  const std::size_t n = flow.size();
  assert(time_step > 0.0 && skeleton.size() == n && strain.size() == n);
  time_step_ = time_step;
  flow_scale_ = time_step / flow.water().unit_weight();
  resize(n);
  flow.follow(skeleton);
  set_up(flow, skeleton, strain, boundary, response);
  if (!boundary_.held().empty()) take_out_held(flow, response);
  const auto apply = [&](std::span<const double> in, std::span<double> out) {
    apply_full(flow, response, in, out);
    for (const HeldPressure& held : boundary_.held()) out[held.particle] = diagonal_[held.particle] * in[held.particle];
  };
  std::fill(change_.begin(), change_.end(), 0.0);
  SolveReport report;
  const int threads = flow.settings().threads;
  tolerance *= tolerance_share_of(flow.soils());
  const double tolerable = tolerance * std::sqrt(blocked_dot(right_side_, right_side_, threads));
  for (int pass = 0; pass < most_passes; ++pass) {
    const double reduction = pass == 0 ? tolerance : std::min(tolerance, tolerance * offset_share());
    const auto result = solver_.solve(apply, diagonal_, right_side_, change_, reduction, most_iterations, threads);
    report.iterations += result.iterations;
    const bool switched = switch_terms(flow);
    const bool bent = follow_retention(flow, skeleton, tolerable);
    report.converged = result.converged && !switched && !bent;
    if (!switched && !bent) break;
  }
  for (const HeldPressure& held : boundary_.held())
    change_[held.particle] = held.pressure - flow.pressure()[held.particle];
  const std::span<const double> saturation = flow.saturation();
  for (std::size_t p = 0; p < n; ++p) {
    stress_change_[p] = saturation[p] * change_[p];
    report.largest_change = std::max(report.largest_change, std::abs(change_[p]));
  }
  solved_ = true;
  return report;
}

// The equations at the start of the step.
void CoupledStep::set_up(PoreFlow& flow, const Skeleton& skeleton, std::span<const double> strain,
                         const Boundary& boundary, const VolumeResponse& response) {
  const std::size_t n = flow.size();
  const std::span<const double> pressure = flow.pressure(), saturation = flow.saturation();
  const std::span<const double> pressure_head = flow.pressure_head(), capacity = flow.capacity();
  const std::span<const double> defect = flow.state().defect;
  const int threads = flow.settings().threads;
  for_each_index(
      n, threads, [&](std::size_t p) { head_[p] = pressure_head[p] + skeleton.y[p]; }, few_products);
  flow.find_conductances(conductance_tolerance);
  flow.head_operator().apply(head_, flow_.outflow);
  response.diagonal(volume_change_);
  const std::span<const double> flow_diagonal = flow.head_operator().diagonal();
  for_each_index(n, threads, [&](std::size_t p) {
    const double s = saturation[p];
    storage_slope_[p] = skeleton.volume[p] * skeleton.porosity[p] * (s / flow.water().bulk_modulus + capacity[p]);
    storage_offset_[p] = 0.0;
    touched_[p] = pressure[p];
    stiffness_[p] = storage_slope_[p];
    right_side_[p] = -s * skeleton.volume[p] * strain[p] - time_step_ * flow_.outflow[p] + defect[p];
    diagonal_[p] = stiffness_[p] + flow_scale_ * flow_diagonal[p] + s * s * volume_change_[p];
  });
  boundary_.find(boundary, flow, skeleton.y, head_);
  for (const BoundaryTerm& term : boundary_.terms()) {
    const std::size_t p = term.particle;
    const double stiffness = flow_scale_ * term.stiffness();
    stiffness_[p] += stiffness;
    diagonal_[p] += stiffness;
    right_side_[p] += time_step_ * term.inflow(head_[p]);
  }
}

// [storage + flow + response] in, of all particles.
void CoupledStep::apply_full(const PoreFlow& flow, const VolumeResponse& response, std::span<const double> in,
                             std::span<double> out) {
  const std::span<const double> saturation = flow.saturation();
  const int threads = flow.settings().threads;
  flow.head_operator().apply(in, out);
  for_each_index(
      in.size(), threads, [&](std::size_t p) { stress_[p] = saturation[p] * in[p]; }, few_products);
  response.apply(stress_, volume_change_);
  for_each_index(
      in.size(), threads,
      [&](std::size_t p) { out[p] = stiffness_[p] * in[p] + flow_scale_ * out[p] + saturation[p] * volume_change_[p]; },
      few_products);
}

// Puts the change of held pressures, which is known, on the right side.
void CoupledStep::take_out_held(const PoreFlow& flow, const VolumeResponse& response) {
  std::fill(held_change_.begin(), held_change_.end(), 0.0);
  bool any_change = false;
  for (const HeldPressure& held : boundary_.held()) {
    held_change_[held.particle] = held.pressure - flow.pressure()[held.particle];
    any_change = any_change || held_change_[held.particle] != 0.0;
  }
  if (any_change) {
    apply_full(flow, response, held_change_, held_water_);
    for (std::size_t p = 0; p < flow.size(); ++p) right_side_[p] -= held_water_[p];
  }
  for (const HeldPressure& held : boundary_.held()) right_side_[held.particle] = 0.0;
}

// Puts the parts of the boundaries' laws that hold at the head just found into the equations. @return whether one is
// another.
bool CoupledStep::switch_terms(const PoreFlow& flow) {
  bool switched = false;
  for (BoundaryTerm& term : boundary_.terms()) {
    const std::size_t p = term.particle;
    const double stiffness = term.stiffness(), inflow = term.inflow(head_[p]);
    if (!term.follow(head_[p] + change_[p] / flow.water().unit_weight())) continue;
    const double stiffer = flow_scale_ * (term.stiffness() - stiffness);
    stiffness_[p] += stiffer;
    diagonal_[p] += stiffer;
    right_side_[p] += time_step_ * (term.inflow(head_[p]) - inflow);
    switched = true;
  }
  return switched;
}

// The right side without the offsets of storage over the one with them, in the solver's norm.
double CoupledStep::offset_share() const {
  double without = 0.0, with = 0.0;
  for (std::size_t p = 0; p < right_side_.size(); ++p) {
    const double first = right_side_[p] + storage_offset_[p];
    without += first * first / diagonal_[p];
    with += right_side_[p] * right_side_[p] / diagonal_[p];
  }
  return with > 0.0 ? std::sqrt(without / with) : 1.0;
}

// The tangent at a pressure.
CoupledStep::Tangent CoupledStep::tangent_at(const PoreFlow& flow, std::size_t p, double pressure,
                                             const Skeleton& skeleton) const {
  const Water& water = flow.water();
  const double before = flow.pressure()[p];
  const Saturation s = evaluate(flow.soil(p).retention, -pressure / water.unit_weight());
  const double pores = skeleton.volume[p] * skeleton.porosity[p];
  const double stored = pores * (s.saturation * (1.0 + pressure / water.bulk_modulus) -
                                 flow.saturation()[p] * (1.0 + before / water.bulk_modulus));
  const double slope = pores * (s.saturation / water.bulk_modulus - s.slope / water.unit_weight());
  return {p, stored - slope * (pressure - before), slope, pressure};
}

// Puts the tangents of the retention curves at the pressure just found into the equations, if what the present ones get
// wrong exceeds the tolerable (m2, root of the sum of squares). @return whether it did.
bool CoupledStep::follow_retention(const PoreFlow& flow, const Skeleton& skeleton, double tolerable) {
  constexpr double straight = 0.01;  // relative change of the suction within which a curve counts as its tangent
  const std::span<const double> pressure = flow.pressure();
  kinks_.clear();
  for (const Soil& soil : flow.soils()) {
    const double kink = std::visit([](const auto& law) { return law.kink(); }, soil.retention);
    kinks_.push_back(-kink * flow.water().unit_weight());
  }
  double squares = 0.0;
  tangents_.clear();
  for (std::size_t p = 0; p < pressure.size(); ++p) {
    const double before = pressure[p], now = before + change_[p];
    const double kink = kinks_[flow.soil_index(p)];
    const bool bent = (before - kink) * (now - kink) <= 0.0;
    const bool on_tangent = (before > 0.0 && now > 0.0) || (std::abs(change_[p]) < -straight * before && !bent);
    if (on_tangent && storage_offset_[p] == 0.0) continue;
    tangents_.push_back(tangent_at(flow, p, now, skeleton));
    const Tangent& tangent = tangents_.back();
    const double wrong = tangent.offset - storage_offset_[p] + (tangent.slope - storage_slope_[p]) * change_[p];
    squares += wrong * wrong;
  }
  if (squares <= tolerable * tolerable) return false;
  for (Tangent& tangent : tangents_) {
    const std::size_t p = tangent.particle;
    // not past the steepest place from either side: behind it Newton's method would be thrown back further each time
    const double steepest = std::visit([&](const auto& law) { return -law.steepest() * flow.water().unit_weight(); },
                                       flow.soil(p).retention);
    if ((tangent.touched - steepest) * (touched_[p] - steepest) < 0.0)
      tangent = tangent_at(flow, p, steepest, skeleton);
    const double stiffer = tangent.slope - storage_slope_[p];
    stiffness_[p] += stiffer;
    diagonal_[p] += stiffer;
    right_side_[p] -= tangent.offset - storage_offset_[p];
    storage_slope_[p] = tangent.slope;
    storage_offset_[p] = tangent.offset;
    touched_[p] = tangent.touched;
  }
  return true;
}

// The flow of the step is that at its heads, with the conductivities and positions for which it was solved.
void CoupledStep::finish(PoreFlow& flow, const Skeleton& skeleton) {
  assert(solved_ && change_.size() == flow.size());
  solved_ = false;
  const double inverse_weight = 1.0 / flow.water().unit_weight();
  const std::span<const double> pressure = flow.pressure();
  for_each_index(change_.size(), flow.settings().threads, [&](std::size_t p) {
    head_[p] += change_[p] * inverse_weight;
    pressure_[p] = pressure[p] + change_[p];
  });
  flow.head_operator().apply(head_, flow_.outflow);
  boundary_.take_in(head_, flow_);
  flow.set_pressure(pressure_);
  flow.book(time_step_, skeleton, flow_, boundary_.held());
}

}  // namespace slope::seepage
