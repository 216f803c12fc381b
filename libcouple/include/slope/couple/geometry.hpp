#pragma once

#include <cstddef>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::couple {

/// Particles of a case before the first step, in the order of their ids (by grid cell, row by row from below).
struct InitialParticles {
  std::vector<double> x, y;           ///< positions (m)
  std::vector<double> volume;         ///< per metre of thickness (m2)
  std::vector<int> soil;              ///< index into Case::soils
  std::vector<int> column, row;       ///< of the lattice
  std::vector<double> face_distance;  ///< of a free surface, normal to it (m): of the ground as it is drawn where that
                                      ///< is nearer than a spacing, else half of the volume over the spacing
  double spacing = 0.0;               ///< lattice spacing (m)
};

/// Fills the regions with particles on a square lattice, by the rule of domain.surface_particles.
/// - lattice: a whole particle at each lattice point that lies inside a polygon.
/// - clipped: a particle for each lattice square that the regions cut, with the volume and the centroid of the part cut
///   out, so that the volumes add up to the area of the regions to rounding. A part below half of a square is joined
///   to the neighbour that it touches. Where soils meet, a square belongs to the one with the largest share of it.
[[nodiscard]] InitialParticles fill_regions(const Domain& domain, const std::vector<Region>& regions);

/// Whether a region is large enough, or lies so, that the centre of a lattice square is in it.
[[nodiscard]] bool holds_lattice_point(const Domain& domain, const Region& region);

/// Where a particle of a place meets what is outside: the ground, or another side, as it is drawn.
struct Face {
  std::size_t particle = 0;
  Point normal{0.0, 1.0};  ///< outwards
  double distance = 0.0;   ///< of the particle from it, along the normal (m), > 0
  double area = 0.0;  ///< within the particle's column or row, per metre of thickness (m): a spacing or, inclined, more
  double outwards = 0.0;  ///< of the particle from it, vertically or on a side horizontally (m), > 0
};

/// The particles that a run of a case starts with. Copies of the case that were moved or turned to their mirror image
/// have the same particles, moved and mirrored, in the same order.
[[nodiscard]] InitialParticles first_particles(const Case& input);

/// Particles of a place: the uppermost of each lattice column (ground_surface, free_surface), the lowest (base),
/// the outermost of each lattice row (left, right); limited to the range.
[[nodiscard]] std::vector<std::size_t> particles_at(const PlaceRange& where, const InitialParticles& particles);

/// The faces of the particles of a place, in their order. Particles of a whole lattice have that of their square.
[[nodiscard]] std::vector<Face> faces_at(const PlaceRange& where, const Case& input, const InitialParticles& particles);

}  // namespace slope::couple
