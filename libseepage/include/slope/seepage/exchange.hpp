#pragma once

namespace slope::seepage {

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

/// What comes to a particle through one of its boundaries.
struct Exchange {
  double inflow = 0.0;   ///< (m2/s per metre of thickness), positive into the soil
  double wetting = 0.0;  ///< what of it comes through a face and wets the particle from there (m2/s), >= 0
  bool full = false;     ///< whether it is all that the soil takes through that face
  AirFlow air;           ///< the part of the air in it
};

}  // namespace slope::seepage
