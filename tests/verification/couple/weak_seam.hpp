#pragma once

#include <string>
#include <vector>

namespace slope::testing {

/// A wedge that slides on a straight seam of clay (weak_seam.yaml): 16 m long, 5 m high over its middle, half a metre
/// at its ends, so that nothing is squeezed out there.
struct WeakSeam {
  double thickness = 0.0;        ///< of the seam (m)
  double cell_size = 0.0;        ///< (m)
  double times_as_strong = 3.0;  ///< the firm clay (-); infinite: it never yields
  /// Whether the firm ground drops away beyond the seam's ends; else its surface goes on in the plane of sliding, and
  /// the wedge has ground beside its foot.
  bool stands_free = false;

  /// What strength reduction finds, over what sliding along the bottom of the seam has: s_u L / (W sin(dip)), exact
  /// where the wedge stays whole.
  [[nodiscard]] double found() const;
};

}  // namespace slope::testing
