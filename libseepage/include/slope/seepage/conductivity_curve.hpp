#pragma once

#include <vector>

#include "slope/seepage/soil.hpp"

namespace slope::seepage {

/// The conductivity k k_rw of a soil over the pressure head, from a table: for where it is wanted at a pressure that no
/// particle has, many times in a step. Cubic in the logarithms of conductivity and suction between its entries, sixteen
/// to a factor of e; within 1e-4 of the soil's own laws.
class ConductivityCurve {
 public:
  struct Value {
    double conductivity = 0.0;  ///< k k_rw (m/s), > 0
    double slope = 0.0;         ///< over the pressure head (1/s), >= 0
  };

  explicit ConductivityCurve(const Soil& soil);

  /// @param pressure_head  P_w / gamma_w (m), any sign
  [[nodiscard]] Value at(double pressure_head) const;
  /// Conductivity of the saturated soil (m/s).
  [[nodiscard]] double saturated() const { return saturated_; }

 private:
  double saturated_;
  double wet_;    // suction head up to which the soil conducts like saturated soil (m)
  double first_;  // suction head of the first entry (m), > wet_ or equal
  double first_log_;
  std::vector<double> log_, slope_;  // ln K, and its slope over ln h_s
};

}  // namespace slope::seepage
