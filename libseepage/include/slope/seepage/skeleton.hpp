#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace slope::seepage {

/// What the pore water needs to know of the soil skeleton: views of one entry per particle, SI units, per metre of
/// thickness.
struct Skeleton {
  std::span<const double> x;         ///< position (m)
  std::span<const double> y;         ///< position (m), upwards
  std::span<const double> volume;    ///< V (m2), > 0
  std::span<const double> porosity;  ///< n (-), in (0, 1)

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// @throws std::invalid_argument naming the field that is out of its range, or not one for each particle
  void check() const;
};

/// Straight impermeable walls, at which the particles see their mirror images. Infinite: no wall there.
struct MirrorWalls {
  double left = -std::numeric_limits<double>::infinity();  ///< x (m)
  double right = std::numeric_limits<double>::infinity();  ///< x (m)
  double base = -std::numeric_limits<double>::infinity();  ///< y (m)
  double top = std::numeric_limits<double>::infinity();    ///< y (m)

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
};

}  // namespace slope::seepage
