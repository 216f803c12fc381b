#pragma once

#include "slope/seepage/saturation.hpp"

namespace slope::seepage {

/// Power of the degree of saturation (Hillel 1971); paper, Eq. 10: k_rw = S_r^L.
struct HillelPower {
  double exponent = 2.0;  ///< L (-), > 0; 2 to 4 as a rule

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
  /// @param suction_head h_s (m), not used; @param saturation S_r (-), in [0, 1]; @return k_rw (-), before the floor.
  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
  /// dk_rw/dh_s (1/m), <= 0, before the floor; `saturation` with its slope at h_s.
  [[nodiscard]] double slope(double suction_head, const Saturation& saturation) const;
};

}  // namespace slope::seepage
