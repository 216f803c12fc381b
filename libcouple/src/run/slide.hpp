#pragma once

#include <optional>
#include <vector>

#include "slope/couple/geometry.hpp"
#include "slope/couple/simulation.hpp"
#include "slope/solid/particles.hpp"

namespace slope::couple {

/// The ground at the start as it is drawn: the upper outline of all regions, from left to right; the domain's base
/// where there is none.
class GroundLine {
 public:
  GroundLine(const Domain& domain, const std::vector<Region>& regions);

  /// y of the ground at x (m); of a vertical face, its upper end.
  [[nodiscard]] double height(double x) const;
  /// From the left to the right side of the domain (m); two points of the same x are a vertical face.
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }

  /// The toes of the faces that lie in a direction, +1 to the right or -1 to the left, from `x` (m) on, in their order.
  /// A toe is the first corner from which on the ground falls less than half as steeply as from where it began to fall
  /// down to there, and less steeply than 1 in 10, over a reach of two cells; what lies on a narrower bench does not
  /// count. Ground that falls all the way to the side of the domain has no toe.
  [[nodiscard]] std::vector<Point> toes(double x, double direction) const;

 private:
  [[nodiscard]] double fall_after(std::size_t point, int step) const;

  std::vector<Point> points_;
  double reach_;  // m
};

/// What of the soil has moved by more than `moved` (m), and how far it ran. Positions at the start are the present ones
/// less the displacements.
/// @param spacing  of the particles at the start (m)
[[nodiscard]] Slide find_slide(const solid::Particles& particles, const GroundLine& ground, const Domain& domain,
                               double spacing, double moved);

}  // namespace slope::couple
