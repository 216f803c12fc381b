#include "standing_water_share.hpp"

#include <algorithm>

namespace slope::couple {

StandingWaterShare::StandingWaterShare(std::span<const WaterBoundary> boundaries) {
  for (std::size_t b = 0; b < boundaries.size(); ++b) {
    if (!std::holds_alternative<Reservoir>(boundaries[b].condition)) continue;
    ranges_.push_back({b, boundaries[b].where.from, boundaries[b].where.to});
  }
  std::ranges::sort(ranges_, {}, &Range::from);
}

StandingWaterShare::Share StandingWaterShare::of(std::size_t boundary, double x) const {
  const auto range = std::ranges::find(ranges_, boundary, &Range::boundary);
  if (range == ranges_.end()) return {};
  if (x < range->from && range != ranges_.begin()) {
    const double end = (range - 1)->to;
    if (x <= end) return {};
    return {(x - end) / (range->from - end), 1.0 / (range->from - end)};
  }
  if (x > range->to && range + 1 != ranges_.end()) {
    const double next = (range + 1)->from;
    if (x >= next) return {};
    return {(next - x) / (next - range->to), -1.0 / (next - range->to)};
  }
  return {1.0, 0.0};
}

double StandingWaterShare::gap_after(std::size_t boundary) const {
  const auto range = std::ranges::find(ranges_, boundary, &Range::boundary);
  if (range == ranges_.end() || range + 1 == ranges_.end()) return never;
  return (range + 1)->from - range->to;
}

}  // namespace slope::couple
