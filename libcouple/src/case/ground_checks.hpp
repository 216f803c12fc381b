#pragma once

#include <vector>

#include "frame.hpp"
#include "input.hpp"
#include "slope/couple/case.hpp"
#include "slope/couple/geometry.hpp"

// What the domain, the regions of the soil and the points in it must be. `root` is the whole case.

namespace slope::couple {

void check_domain(const Input& place, const Domain& domain);
/// Says what is more than a run can hold, before any of it is made.
void check_size(const Input& root, const Case& input);
void check_region(const Input& place, const Domain& domain, const Region& region);
/// @return whether no two edges cross each other
bool check_simple(const Input& outline, const std::vector<Point>& polygon);
void check_points(const Input& root, const Case& input);
/// Soil that hangs in the air falls at once.
/// @param columns  of squares of the lattice that the particles come from, in the whole width
void doubt_hanging_soil(const Input& place, const InitialParticles& particles, const Frame& frame, int columns);

}  // namespace slope::couple
