#pragma once

#include <cstdint>

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

/// What air and soil exchange (m2/s per metre of thickness), each >= 0: rain = infiltration + run_off, and the inflow
/// is infiltration - seepage - evaporation.
struct AirFlow {
  double rain = 0.0;          ///< what fell
  double infiltration = 0.0;  ///< of it into the soil
  double run_off = 0.0;       ///< of it along the ground and away
  double seepage = 0.0;       ///< out of the soil, as water
  double evaporation = 0.0;   ///< out of the soil, into the air

  AirFlow& operator+=(const AirFlow& other);

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("rain", s.rain);
    visit("infiltration", s.infiltration);
    visit("run_off", s.run_off);
    visit("seepage", s.seepage);
    visit("evaporation", s.evaporation);
  }
  bool operator==(const AirFlow&) const = default;
};

/// The parts of an inflow q through a face with rain R; q <= max(R, 0).
[[nodiscard]] AirFlow air_flow(double rain, double inflow);

/// The inflow of an OpenFace with conductances that stay what they are during a step.
struct OpenFaceLaw {
  /// Which part of the law holds.
  enum class Part { air, wet, dry, closed };

  double rain = 0.0;
  double wet_conductance = 0.0, wet_head = 0.0;  ///< G_w (m/s per metre of thickness), h_w (m)
  double dry_conductance = 0.0, dry_head = 0.0;

  [[nodiscard]] Part part_at(double head) const;
  /// Inflow (m2/s) by one part of the law, which is linear in the head.
  [[nodiscard]] double inflow(Part part, double head) const;
  /// By how much that inflow falls with the head (m/s).
  [[nodiscard]] double conductance(Part part) const;
};

}  // namespace slope::seepage
