#include "slope/seepage/explicit_step.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "slope/seepage/two_pass_operator.hpp"

namespace slope::seepage {

double ExplicitStep::stable_step(const PoreFlow& flow, const Skeleton& skeleton) {
  const Water& water = flow.water();
  const double spacing = flow.settings().spacing;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < flow.size(); ++p) {
    const double diffusivity =
        flow.soil(p).hydraulic_conductivity * water.bulk_modulus / (skeleton.porosity[p] * water.unit_weight());
    shortest = std::min(shortest, spacing * spacing / diffusivity);
  }
  return shortest;
}

void ExplicitStep::advance(PoreFlow& flow, double time_step, const Skeleton& skeleton, std::span<const double> vx,
                           std::span<const double> vy, const Boundary& boundary) {
  const std::size_t n = flow.size();
  assert(time_step > 0.0 && skeleton.size() == n && vx.size() == n && vy.size() == n);
  for (auto* field : {&head_, &conductivity_, &wx_, &wy_, &skeleton_divergence_, &change_, &pressure_, &flow_.outflow})
    field->resize(n);
  const FlowSettings& settings = flow.settings();
  TwoPassOperator two_pass(settings.spacing, settings.smoothing_ratio, settings.walls);
  flow.follow(skeleton);
  two_pass.update(skeleton);
  for (std::size_t p = 0; p < n; ++p) head_[p] = flow.pressure_head()[p] + skeleton.y[p];
  for (std::size_t p = 0; p < n; ++p) conductivity_[p] = flow.conductivity(p);
  two_pass.darcy_velocity(head_, conductivity_, wx_, wy_);
  two_pass.divergence(wx_, wy_, flow_.outflow);
  two_pass.divergence(vx, vy, skeleton_divergence_);
  for (std::size_t p = 0; p < n; ++p) flow_.outflow[p] *= skeleton.volume[p];
  boundary_.find(boundary, flow, skeleton.y, head_);
  boundary_.take_in(head_, flow_);
  const std::span<const double> saturation = flow.saturation(), capacity = flow.capacity();
  for (std::size_t p = 0; p < n; ++p) {
    const double storage = skeleton.porosity[p] * (saturation[p] / flow.water().bulk_modulus + capacity[p]);
    change_[p] =
        -time_step / storage * (flow_.outflow[p] / skeleton.volume[p] + saturation[p] * skeleton_divergence_[p]);
  }
  for (const HeldPressure& held : boundary_.held())
    change_[held.particle] = held.pressure - flow.pressure()[held.particle];
  for (std::size_t p = 0; p < n; ++p) pressure_[p] = flow.pressure()[p] + change_[p];
  flow.set_pressure(pressure_);
  flow.book(time_step, skeleton, flow_, boundary_.held());
}

}  // namespace slope::seepage
