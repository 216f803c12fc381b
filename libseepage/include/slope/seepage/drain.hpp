#pragma once

#include <algorithm>
#include <cstdint>

#include "slope/seepage/exchange.hpp"

namespace slope::seepage {

class PoreFlow;

/// Water leaves a particle downwards by its own weight, with a head that falls by one metre per metre (free drainage):
/// the soil goes on below as it is here, and the water table is far down.
struct Drain {
  std::uint32_t particle = 0;
  std::uint32_t boundary = 0;  ///< which budget the water counts in
  double width = 0.0;          ///< horizontal (m), > 0
};

/// The outflow of a drain, linear about the head at which it was found, up to that of saturated soil.
struct DrainLaw {
  double rate = 0.0;        ///< (m2/s), outwards
  double slope = 0.0;       ///< (m/s), >= 0
  double found_head = 0.0;  ///< (m)
  double largest = 0.0;     ///< (m2/s)

  [[nodiscard]] double inflow(double head) const { return -(rate + slope * (head - found_head)); }
  [[nodiscard]] double stiffness() const { return slope; }
  [[nodiscard]] static double conductance_slope() { return 0.0; }
  static bool follow(double /*head*/) { return false; }
  [[nodiscard]] Exchange exchange(double head) const {
    return {-std::clamp(-inflow(head), 0.0, largest), 0.0, false, {}};
  }
};

[[nodiscard]] DrainLaw law_of(const Drain& drain, const PoreFlow& flow, double elevation, double head);

}  // namespace slope::seepage
