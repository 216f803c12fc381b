#pragma once

#include "frame.hpp"
#include "input.hpp"
#include "slope/couple/case.hpp"
#include "slope/couple/geometry.hpp"

namespace slope::couple {

/// The grid holds soil too strong where it slides along soil that is stronger (libsolid's README has by how much): a
/// warning for each soil that is thin, in cells, between or above soils that bear more along a plane at its depth.
/// @param geometry  of the case; @param input  the case, placed in the frame of the particles
void doubt_contrast(const Input& geometry, const Case& input, const InitialParticles& particles, const Frame& frame);

}  // namespace slope::couple
