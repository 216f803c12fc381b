#pragma once

#include "slope/seepage/saturation.hpp"

namespace slope::seepage {

/// Exponential in suction (Gardner 1958): k_rw = exp(-alpha h_s) for h_s > 0, and 1 for h_s <= 0.
struct ExponentialPermeability {
  double alpha = 0.0;  ///< (1/m), > 0

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
  /// @param suction_head h_s (m), any sign; @param saturation S_r (-), not used; @return k_rw (-), before the floor.
  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
  /// dk_rw/dh_s (1/m), <= 0, before the floor; `saturation` with its slope at h_s.
  [[nodiscard]] double slope(double suction_head, const Saturation& saturation) const;
};

}  // namespace slope::seepage
