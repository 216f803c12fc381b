#pragma once

#include <string>
#include <vector>

namespace slope::testing {

/// A wedge that slides on a straight seam of clay (weak_seam.yaml): 16 m long, 5 m high over its middle, half a metre
/// at its ends, so that nothing is squeezed out there.
struct WeakSeam {
  double thickness = 0.0;  ///< of the seam (m)
  double cell_size = 0.0;  ///< (m)

  /// What strength reduction finds, over what sliding along the bottom of the seam has: s_u L / (W sin(dip)), exact
  /// where the wedge stays whole.
  [[nodiscard]] double found() const;
};

}  // namespace slope::testing
