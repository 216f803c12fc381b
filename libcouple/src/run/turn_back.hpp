#pragma once

#include "case/frame.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::couple {

/// From the frame in which a case is computed to its own coordinates: positions, directions and shear of all particles,
/// whose order stays.
void turn_back(const Frame& frame, ParticleTable& table);
void turn_back(const Frame& frame, Summary& summary);

}  // namespace slope::couple
