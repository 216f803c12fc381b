#pragma once

#include "slope/seepage/saturation.hpp"

namespace slope::seepage {

/// van Genuchten (1980), Soil Sci. Soc. Am. J. 44; paper, Eq. 8:
///
///     S_e = (1 + (alpha h_s)^n)^-m,  m = 1 - 1/n,        dS_e/dh_s = -m n S_e (alpha h_s)^n / (h_s (1 + (alpha
///     h_s)^n))
///
/// for h_s > 0, and S_e = 1 for h_s <= 0.
struct VanGenuchten {
  double alpha = 0.0;  ///< alpha' (1/m), > 0
  double n = 0.0;      ///< n' (-), > 1
  SaturationRange range;

  /// @param suction_head h_s = s / gamma_w (m), any sign.
  [[nodiscard]] Saturation evaluate(double suction_head) const;
};

}  // namespace slope::seepage
