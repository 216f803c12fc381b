#pragma once

#include <span>

#include "canvas.hpp"

namespace slope::tools {

/// Colours at equal steps from the lowest to the highest value.
using ColourMap = std::span<const Colour>;

/// viridis: dark blue to yellow. Perceptually uniform, legible in grey and to colour-blind readers.
[[nodiscard]] ColourMap viridis();
/// magma from its light end: cream to black.
[[nodiscard]] ColourMap magma_reversed();

/// The colour at a share of the way, which is limited to [0, 1]; in between, straight lines in RGB.
[[nodiscard]] Colour colour_at(ColourMap map, double share);

/// Eight colours for curves that colour-blind readers tell apart.
[[nodiscard]] Colour curve_colour(std::size_t index);

}  // namespace slope::tools
