#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::couple {

/// How far the soil below a place bears the pressure of each reservoir, as if there were only that one.
///
/// The weight of standing water acts as the volume force of a pressure field that goes on inside the soil. Any field
/// with the right values on the surface has the right resultant (Gauss); this one is that of a reservoir within its
/// range, and goes over linearly in x to that of the next between the two, where the ground is higher than both. Beyond
/// the first and the last it is theirs.
class StandingWaterShare {
 public:
  explicit StandingWaterShare(std::span<const WaterBoundary> boundaries);

  struct Share {
    double value = 0.0;  ///< (-), in [0, 1]; those of all reservoirs add up to 1
    double slope = 0.0;  ///< along x (1/m)
  };
  /// Of the reservoir that is the boundary of that index; zero for other boundaries.
  [[nodiscard]] Share of(std::size_t boundary, double x) const;
  /// From the end of a reservoir's range to the beginning of the next one's (m); infinite after the last.
  [[nodiscard]] double gap_after(std::size_t boundary) const;

 private:
  struct Range {
    std::size_t boundary;
    double from, to;
  };
  std::vector<Range> ranges_;  // from left to right
};

}  // namespace slope::couple
