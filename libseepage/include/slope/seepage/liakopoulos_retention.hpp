#pragma once

#include "slope/seepage/saturation.hpp"

namespace slope::seepage {

/// Del Monte sand of Liakopoulos (1965); paper, Eq. 20:
///
///     S_r = 1 - a h_s^b  with h_s in metres,             dS_r/dh_s = -b a h_s^(b - 1)
///
/// for h_s > 0, not below `floor` (where the slope is 0; the default law reaches 0 at h_s = 2.57 m); S_r = 1 for
/// h_s <= 0.
struct LiakopoulosRetention {
  double coefficient = 0.10152;  ///< a (m^-b), > 0
  double exponent = 2.4279;      ///< b (-), > 1
  double floor = 0.0;            ///< lowest S_r (-), in [0, 1)

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
  /// @param suction_head h_s = s / gamma_w (m), any sign.
  [[nodiscard]] Saturation evaluate(double suction_head) const;
  /// Suction head at which the curve is steepest (m), > 0.
  [[nodiscard]] double steepest() const;
  /// Suction head at which the slope jumps (m), >= 0.
  [[nodiscard]] double kink() const;
};

}  // namespace slope::seepage
