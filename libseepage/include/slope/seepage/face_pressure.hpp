#pragma once

#include <algorithm>
#include <cstdint>

#include "slope/seepage/exchange.hpp"

namespace slope::seepage {

class PoreFlow;

/// The pressure of a face is prescribed, half a spacing away from its particle.
struct FacePressure {
  std::uint32_t particle = 0;
  std::uint32_t boundary = 0;  ///< which budget the water counts in
  double pressure = 0.0;       ///< P_w at the face at the end of the step (Pa)
  double rise = 0.0;           ///< height of the face above the particle (m), negative below
  double distance = 0.0;       ///< of the face from the particle (m), > 0
  double area = 0.0;           ///< of the face per metre of thickness (m), > 0
};

/// The inflow G (h_f - h), with a conductance G that stays what it is during a step.
struct FaceLaw {
  double conductance = 0.0;  ///< G (m/s)
  double face_head = 0.0;    ///< h_f (m)
  double slope = 0.0;        ///< of the inflow over the particle's head, with that of G (m/s), <= 0

  [[nodiscard]] double inflow(double head) const { return conductance * (face_head - head); }
  [[nodiscard]] double stiffness() const { return conductance; }
  [[nodiscard]] double conductance_slope() const { return slope + conductance; }
  bool follow(double /*head*/) { return false; }
  [[nodiscard]] Exchange exchange(double head) const {
    const double rate = inflow(head);
    return {rate, std::max(rate, 0.0), true, {}};
  }
};

/// The law of a condition at the present state of the water.
/// @param elevation  of its particle (m); @param head  there (m)
[[nodiscard]] FaceLaw law_of(const FacePressure& face, const PoreFlow& flow, double elevation, double head);

}  // namespace slope::seepage
