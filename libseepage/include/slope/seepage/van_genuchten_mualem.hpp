#pragma once

#include "slope/seepage/saturation.hpp"

namespace slope::seepage {

/// van Genuchten (1980) with the pore model of Mualem (1976):
///
///     k_rw = sqrt(S_e) (1 - (1 - S_e^(1/m))^m)^2,  m = 1 - 1/n
///
/// with the effective saturation S_e of the soil's retention curve. Where that has an air entry (Vogel et al. 2001),
///
///     k_rw = sqrt(S_e) (F(S_e) / F(1))^2,  F(S_e) = 1 - (1 - (S_e S_c)^(1/m))^m,  S_c =
///     VanGenuchten::entry_saturation()
struct VanGenuchtenMualem {
  double n = 0.0;                 ///< n' (-), > 1
  SaturationRange range;          ///< that of the retention curve
  double entry_saturation = 1.0;  ///< S_c of the retention curve (-), in (0, 1]

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
  /// @param suction_head h_s (m), not used; @param saturation S_r (-), in [0, 1]; @return k_rw (-), before the floor.
  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
  /// dk_rw/dh_s (1/m), <= 0, before the floor; `saturation` with its slope at h_s.
  [[nodiscard]] double slope(double suction_head, const Saturation& saturation) const;
};

}  // namespace slope::seepage
