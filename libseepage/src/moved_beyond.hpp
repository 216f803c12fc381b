#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "slope/seepage/skeleton.hpp"

namespace slope::seepage {

/// Whether a particle is farther than `limit` (m) from where it was; x, y are the positions then, one per particle.
inline bool moved_beyond(double limit, const Skeleton& now, std::span<const double> x, std::span<const double> y) {
  double farthest = 0.0;
  for (std::size_t p = 0; p < now.size(); ++p) {
    const double dx = now.x[p] - x[p], dy = now.y[p] - y[p];
    farthest = std::max(farthest, dx * dx + dy * dy);
  }
  return farthest > limit * limit;
}

}  // namespace slope::seepage
