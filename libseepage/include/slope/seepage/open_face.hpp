#pragma once

#include <cstdint>

#include "slope/seepage/exchange.hpp"
#include "slope/seepage/face_pressure.hpp"

namespace slope::seepage {

/// A face where soil meets air, half a spacing away from its particle. Rain falls on it or the air asks for water; what
/// the soil cannot take runs off, and water under pressure leaves; none is ever sucked in.
///
/// The inflow q is a function of the particle's head h that never rises with it:
///
///     q = min(a, G_w (h_w - h)),   a = R for rain R >= 0,   a = max(R, min(0, G_d (h_d - h))) for evaporation R < 0,
///
/// with h_w the head of the face at the ponding pressure, h_d at the lowest pressure, and G the conductance of the half
/// spacing of soil between face and particle. As long as q = R the air decides; q < R means that the pressure of the
/// face is held: q >= 0, and R - q runs off; or q < 0, and water comes out (a seepage face).
struct OpenFace {
  std::uint32_t particle = 0;
  std::uint32_t boundary = 0;     ///< which budget the water counts in
  double rain = 0.0;              ///< R (m2/s per metre of thickness), negative: what the air could evaporate
  double ponding_pressure = 0.0;  ///< P_w at the face that rain cannot exceed (Pa), >= 0
  double lowest_pressure = 0.0;   ///< P_w at the face to which the air can dry it (Pa), < ponding_pressure
  double rise = 0.0;              ///< height of the face above the particle (m), negative below
  double distance = 0.0;          ///< of the face from the particle (m), > 0
  double area = 0.0;              ///< of the face per metre of thickness (m), > 0
};

/// The inflow of an OpenFace with conductances that stay what they are during a step.
struct OpenFaceLaw {
  /// Which part of the law holds.
  enum class Part { air, wet, dry, closed };

  double rain = 0.0;
  FaceLaw wet;            ///< with the ponding pressure at the face
  FaceLaw dry;            ///< with the lowest one; for evaporation only
  Part part = Part::air;  ///< which stands in the equations

  [[nodiscard]] Part part_at(double head) const;
  /// Inflow (m2/s) by one part of the law, which is linear in the head.
  [[nodiscard]] double inflow(Part of, double head) const;

  [[nodiscard]] double inflow(double head) const { return inflow(part, head); }
  [[nodiscard]] double stiffness() const;
  [[nodiscard]] double conductance_slope() const;
  bool follow(double head);
  [[nodiscard]] Exchange exchange(double head) const;
};

[[nodiscard]] OpenFaceLaw law_of(const OpenFace& face, const PoreFlow& flow, double elevation, double head);

}  // namespace slope::seepage
