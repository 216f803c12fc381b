#pragma once

#include <variant>

namespace slope::seepage {

/// Degree of saturation and its slope at one state.
struct Saturation {
  double saturation = 1.0;  ///< S_r (-)
  double slope = 0.0;       ///< dS_r/dh_s (1/m), h_s the suction head; <= 0
};

/// Limits of the degree of saturation: S_r = residual + (maximum - residual) S_e.
struct SaturationRange {
  double residual = 0.0;  ///< (-), in [0, maximum)
  double maximum = 1.0;   ///< (-), in (residual, 1]
};

/// van Genuchten (1980), paper Eq. 8: S_e = (1 + (alpha h_s)^n)^-m, m = 1 - 1/n. For h_s <= 0: S_e = 1.
struct VanGenuchten {
  double alpha = 0.0;  ///< alpha' (1/m), > 0
  double n = 0.0;      ///< n' (-), > 1
  SaturationRange range;

  /// @param suction_head h_s = s / gamma_w (m), any sign.
  [[nodiscard]] Saturation evaluate(double suction_head) const;
};

/// Liakopoulos (1965), paper Eq. 20: S_r = 1 - a h_s^b with h_s in metres, not below `floor`.
struct LiakopoulosRetention {
  double coefficient = 0.10152;  ///< a (m^-b), > 0
  double exponent = 2.4279;      ///< b (-), > 1
  double floor = 0.0;            ///< lowest S_r (-), in [0, 1)

  [[nodiscard]] Saturation evaluate(double suction_head) const;
};

/// Exponential (Gardner) retention: S_e = exp(-alpha h_s). For h_s <= 0: S_e = 1.
struct ExponentialRetention {
  double alpha = 0.0;  ///< (1/m), > 0
  SaturationRange range;

  [[nodiscard]] Saturation evaluate(double suction_head) const;
};

using Retention = std::variant<VanGenuchten, LiakopoulosRetention, ExponentialRetention>;

}  // namespace slope::seepage
