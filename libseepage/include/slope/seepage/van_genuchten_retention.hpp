#pragma once

#include "slope/seepage/saturation.hpp"

namespace slope::seepage {

/// van Genuchten (1980), Soil Sci. Soc. Am. J. 44; paper, Eq. 8:
///
///     S_e = (1 + (alpha h_s)^n)^-m,  m = 1 - 1/n,        dS_e/dh_s = -m n S_e (alpha h_s)^n / (h_s (1 + (alpha
///     h_s)^n))
///
/// for h_s > 0, and S_e = 1 for h_s <= 0. With an air entry h_e the soil stays wet up to it, and S_e above it is that
/// of the formula over its value at h_e (Vogel, van Genuchten and Cislerova 2001, Adv. Water Resour. 24): for n near 1,
/// where the permeability that belongs to the formula falls within a millimetre of suction by half.
struct VanGenuchten {
  double alpha = 0.0;  ///< alpha' (1/m), > 0
  double n = 0.0;      ///< n' (-), > 1
  SaturationRange range;
  double air_entry = 0.0;  ///< h_e, suction head at which air enters (m), >= 0

  /// The formula's S_e at the air entry (-), in (0, 1].
  [[nodiscard]] double entry_saturation() const;

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
  /// @param suction_head h_s = s / gamma_w (m), any sign.
  [[nodiscard]] Saturation evaluate(double suction_head) const;
  /// Suction head at which the curve is steepest (m), > 0.
  [[nodiscard]] double steepest() const;
  /// Suction head at which the slope jumps (m), >= 0.
  [[nodiscard]] double kink() const { return air_entry; }
};

}  // namespace slope::seepage
