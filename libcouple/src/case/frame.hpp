#pragma once

#include <optional>

#include "slope/couple/case.hpp"
#include "slope/couple/geometry.hpp"

namespace slope::couple {

/// Turns a component to its mirror image.
inline void negate(double& value) {
  value = 0.0 - value;  // zero stays positive
}

/// The coordinates in which a case is computed, so that neither its place nor its direction decides anything: copies of
/// a case that were moved or turned to their mirror image give the same numbers, to the last bit.
///
/// The origin is the lower left corner of the domain. Of a case and its mirror image one is computed for both: the one
/// whose ground is the higher on the right or, if it is symmetric, whose text comes first. Coordinates are rounded to a
/// decimal quantum of a millionth of the cell size, far above the rounding of survey coordinates of thousands of
/// kilometres and far below what matters.
class Frame {
 public:
  /// @param mirrored  whether it is the mirror image; none: decided by the case
  explicit Frame(const Case& given, std::optional<bool> mirrored = {});
  [[nodiscard]] bool is_mirrored() const { return mirrored_; }

  /// The case as it is computed. What is a position is moved, rounded and mirrored, what has a direction mirrored.
  [[nodiscard]] Case place(const Case& given) const;

  // From the frame to the coordinates of the case.
  [[nodiscard]] Point position(const Point& in_frame) const;
  [[nodiscard]] double height(double in_frame) const { return origin_[1] + in_frame; }
  /// Positions of all particles, whose order stays.
  void turn_back(InitialParticles& particles) const;

 private:
  [[nodiscard]] double rounded(double length) const;
  [[nodiscard]] double x_of(double given) const;
  [[nodiscard]] double y_of(double given) const { return rounded(given - origin_[1]); }
  [[nodiscard]] std::vector<Point> outline_of(const std::vector<Point>& polygon) const;
  void place(PlaceRange& where) const;
  void place(InitialWater& water) const;
  void place(WaterBoundary& boundary) const;

  Point origin_;             // (m)
  double width_, height_;    // of the domain (m)
  double quanta_per_metre_;  // (1/m)
  bool mirrored_ = false;
};

}  // namespace slope::couple
