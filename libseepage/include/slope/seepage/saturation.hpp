#pragma once

namespace slope::seepage {

/// Degree of saturation and its slope at one state.
struct Saturation {
  double saturation = 1.0;  ///< S_r (-)
  double slope = 0.0;       ///< dS_r/dh_s (1/m), h_s the suction head; <= 0
};

/// Limits of the degree of saturation: S_r = residual + (maximum - residual) S_e, with the effective saturation S_e.
struct SaturationRange {
  double residual = 0.0;  ///< (-), in [0, maximum)
  double maximum = 1.0;   ///< (-), in (residual, 1]

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
  /// S_r and its slope for those of S_e.
  [[nodiscard]] Saturation scale(double effective, double effective_slope) const {
    const double span = maximum - residual;
    return {residual + span * effective, span * effective_slope};
  }
};

}  // namespace slope::seepage
