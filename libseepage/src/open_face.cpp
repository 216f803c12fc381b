#include "slope/seepage/open_face.hpp"

#include <algorithm>

#include "slope/seepage/pore_flow.hpp"

namespace slope::seepage {

OpenFaceLaw::Part OpenFaceLaw::part_at(double head) const {
  Part at = Part::air;
  if (rain < 0.0) {
    const double drying = inflow(Part::dry, head);
    at = drying >= 0.0 ? Part::closed : drying > rain ? Part::dry : Part::air;
  }
  return inflow(Part::wet, head) < inflow(at, head) ? Part::wet : at;
}

double OpenFaceLaw::inflow(Part of, double head) const {
  switch (of) {
    case Part::air:
      return rain;
    case Part::wet:
      return wet.inflow(head);
    case Part::dry:
      return dry.inflow(head);
    case Part::closed:
      return 0.0;
  }
  return 0.0;
}

double OpenFaceLaw::stiffness() const {
  return part == Part::wet ? wet.conductance : part == Part::dry ? dry.conductance : 0.0;
}

double OpenFaceLaw::conductance_slope() const {
  return part == Part::wet ? wet.conductance_slope() : part == Part::dry ? dry.conductance_slope() : 0.0;
}

bool OpenFaceLaw::follow(double head) {
  const Part before = part;
  part = part_at(head);
  return part != before;
}

// What the law says at the head: were the step solved for another part of it, the particle's defect has the difference.
Exchange OpenFaceLaw::exchange(double head) const {
  const Part now = part_at(head);
  const double rate = inflow(now, head);
  return {rate, std::max(rate, 0.0), now != Part::air, air_flow(rain, rate)};
}

OpenFaceLaw law_of(const OpenFace& face, const PoreFlow& flow, double elevation, double head) {
  const double height = elevation + face.rise;
  const auto held_at = [&](double pressure) {
    FaceLaw law = law_of(FacePressure{face.particle, face.boundary, pressure, face.rise, face.distance, face.area},
                         flow, elevation, head);
    law.face_head = pressure / flow.water().unit_weight() + height;
    return law;
  };
  OpenFaceLaw law;
  law.rain = face.rain;
  law.wet = held_at(face.ponding_pressure);
  if (face.rain < 0.0) law.dry = held_at(face.lowest_pressure);
  law.part = law.part_at(head);
  return law;
}

}  // namespace slope::seepage
