#pragma once

#include <cstdint>

#include "slope/seepage/exchange.hpp"

namespace slope::seepage {

class PoreFlow;

/// Water that enters a particle, whatever its head.
struct Inflow {
  std::uint32_t particle = 0;
  std::uint32_t boundary = 0;  ///< which budget the water counts in
  double rate = 0.0;           ///< (m2/s per metre of thickness), positive inwards
};

struct InflowLaw {
  double rate = 0.0;  ///< (m2/s)

  [[nodiscard]] double inflow(double /*head*/) const { return rate; }
  [[nodiscard]] static double stiffness() { return 0.0; }
  [[nodiscard]] static double conductance_slope() { return 0.0; }
  static bool follow(double /*head*/) { return false; }
  [[nodiscard]] Exchange exchange(double /*head*/) const { return {rate, 0.0, false, {}}; }
};

[[nodiscard]] inline InflowLaw law_of(const Inflow& inflow, const PoreFlow& /*flow*/, double /*elevation*/,
                                      double /*head*/) {
  return {inflow.rate};
}

}  // namespace slope::seepage
