#pragma once

#include "slope/seepage/saturation.hpp"

namespace slope::seepage {

/// Del Monte sand of Liakopoulos (1965); paper, Eq. 21: k_rw = 1 - a (1 - S_r)^b. Negative for dry soil (S_r < 0.547 by
/// default): to be used with a floor.
struct LiakopoulosPermeability {
  double coefficient = 2.207;  ///< a (-), > 0
  double exponent = 1.0;       ///< b (-), > 0

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
  /// @param suction_head h_s (m), not used; @param saturation S_r (-), in [0, 1]; @return k_rw (-), before the floor.
  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
  /// dk_rw/dh_s (1/m), <= 0, before the floor; `saturation` with its slope at h_s.
  [[nodiscard]] double slope(double suction_head, const Saturation& saturation) const;
};

}  // namespace slope::seepage
