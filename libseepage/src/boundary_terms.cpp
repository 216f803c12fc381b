#include "slope/seepage/boundary_terms.hpp"

#include <algorithm>
#include <cassert>

namespace slope::seepage {

void BoundaryTerms::find(const Boundary& boundary, const PoreFlow& flow, std::span<const double> elevation,
                         std::span<const double> head) {
  terms_.clear();
  Boundary::for_each_list(boundary, [&](const auto& conditions) {
    for (const auto& condition : conditions) {
      const std::size_t p = condition.particle;
      assert(p < head.size() && condition.boundary < boundary.count);
      terms_.push_back({condition.particle, condition.boundary, law_of(condition, flow, elevation[p], head[p])});
    }
  });
  assert(std::ranges::all_of(boundary.held, [&](const HeldPressure& held) {
    return held.particle < head.size() && held.boundary < boundary.count;
  }));
  held_ = boundary.held;
  accounts_ = boundary.count;
}

void BoundaryTerms::take_in(std::span<const double> head, StepFlow& flow) const {
  flow.wetting.assign(head.size(), 0.0);
  flow.full.assign(head.size(), 0);
  flow.inflow_rate.assign(accounts_, 0.0);
  flow.air_flow = {};
  for (const BoundaryTerm& term : terms_) {
    const std::size_t p = term.particle;
    const Exchange exchange = term.exchange(head[p]);
    flow.outflow[p] -= exchange.inflow;
    flow.wetting[p] += exchange.wetting;
    if (exchange.full) flow.full[p] = 1;
    flow.inflow_rate[term.account] += exchange.inflow;
    flow.air_flow += exchange.air;
  }
}

}  // namespace slope::seepage
