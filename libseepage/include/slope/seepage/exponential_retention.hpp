#pragma once

#include "slope/seepage/saturation.hpp"

namespace slope::seepage {

/// Exponential retention that goes with Gardner's (1958) permeability, as in Srivastava and Yeh (1991):
///
///     S_e = exp(-alpha h_s),                             dS_e/dh_s = -alpha S_e
///
/// for h_s > 0, and S_e = 1 for h_s <= 0.
struct ExponentialRetention {
  double alpha = 0.0;  ///< (1/m), > 0
  SaturationRange range;

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
  /// @param suction_head h_s = s / gamma_w (m), any sign.
  [[nodiscard]] Saturation evaluate(double suction_head) const;
  /// Suction head at which the curve is steepest (m), > 0.
  [[nodiscard]] double steepest() const;
  /// Suction head at which the slope jumps (m), >= 0.
  [[nodiscard]] double kink() const { return 0.0; }
};

}  // namespace slope::seepage
