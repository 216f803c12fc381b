#pragma once

#include "slope/couple/case.hpp"
#include "slope/couple/geometry.hpp"

namespace slope::testing {

/// A rectangle of saturated soil (Table 2 of the paper) with its lower left corner at the origin, in a box that leaves
/// `margin` (m) free to the right and above: what the tests that drive the scheme step by step start from.
struct Block {
  /// @param width, height  (m), whole numbers of cells
  Block(double width, double height, double cell_size, double margin);

  couple::Case input;
  couple::InitialParticles particles() const;
};

}  // namespace slope::testing
