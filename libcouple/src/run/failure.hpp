#pragma once

#include <span>
#include <vector>

#include "slope/couple/geometry.hpp"
#include "slope/couple/simulation.hpp"
#include "slope/solid/particles.hpp"

namespace slope::couple {

/// The ground surface at the start: the faces of the uppermost particles, from left to right.
class GroundSurface {
 public:
  GroundSurface(const InitialParticles& particles, const std::vector<Face>& uppermost);
  /// Distance of a point from the surface, normal to it (m).
  [[nodiscard]] double depth(double x, double y) const;

 private:
  std::vector<Point> points_;
};

/// Extent of the particles whose deviatoric strain exceeds `threshold`.
[[nodiscard]] FailureZone find_failure_zone(const solid::Particles& particles, std::span<const double> suction,
                                            const GroundSurface& surface, double spacing, double threshold);

/// eps_q of a particle (-).
[[nodiscard]] double deviatoric_strain_of(const solid::Particles& particles, std::size_t p);

}  // namespace slope::couple
