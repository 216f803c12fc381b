#pragma once

#include <vector>

#include "frame.hpp"
#include "input.hpp"
#include "slope/couple/case.hpp"
#include "slope/couple/geometry.hpp"

// What the water at the start and at the boundaries must be. `root` is the whole case; where particles are given, the
// case is the one placed in their frame.

namespace slope::couple {

/// A particle whose pressure is held, or on which rain falls or water stands, takes no second such condition of that
/// place. Rain may fall on a reservoir, and fluxes add to each other and to free drainage.
void check_overlaps(const Input& place, const std::vector<WaterBoundary>& boundaries);
/// The last row of a table of rain holds for ever. Gauges write what fell in each of their intervals: a run that goes
/// on after the last of them must be told what comes then.
void check_rain_ends(const Input& place, const Case& input);
/// A steady state needs water that holds it, and only a steady state has boundaries that are there before the start.
void check_steady(const Input& root, const Case& input);
/// Standing water weighs on the soil up to where its share fades out (see StandingWaterShare): there must be room.
void check_reservoirs(const Input& place, const Case& input);
/// Beyond the range of a reservoir the ground must be higher than its level, or its weight would stand in the air.
void check_shores(const Input& place, const Case& input, const InitialParticles& particles, const Frame& frame);
/// Water above the ground that nothing holds there would fall on the soil as pressure without weight.
void check_water_table(const Input& place, const Case& input, const InitialParticles& particles, const Frame& frame);
/// A warning where a reservoir stands at the start and the water in the ground below it stands at another level: the
/// soil bears the difference from the first moment on.
void doubt_levels(const Input& place, const Case& input, const InitialParticles& particles, const Frame& frame);

}  // namespace slope::couple
