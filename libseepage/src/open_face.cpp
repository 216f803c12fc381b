#include "slope/seepage/open_face.hpp"

#include <algorithm>

namespace slope::seepage {

AirFlow& AirFlow::operator+=(const AirFlow& other) {
  rain += other.rain;
  infiltration += other.infiltration;
  run_off += other.run_off;
  seepage += other.seepage;
  evaporation += other.evaporation;
  return *this;
}

AirFlow air_flow(double rain, double inflow) {
  AirFlow flow;
  flow.rain = std::max(rain, 0.0);
  flow.infiltration = std::max(inflow, 0.0);
  flow.run_off = flow.rain - flow.infiltration;
  const double outflow = std::max(-inflow, 0.0);
  flow.evaporation = std::min(outflow, std::max(-rain, 0.0));
  flow.seepage = outflow - flow.evaporation;
  return flow;
}

OpenFaceLaw::Part OpenFaceLaw::part_at(double head) const {
  Part part = Part::air;
  if (rain < 0.0) {
    const double dry = inflow(Part::dry, head);
    part = dry >= 0.0 ? Part::closed : dry > rain ? Part::dry : Part::air;
  }
  return inflow(Part::wet, head) < inflow(part, head) ? Part::wet : part;
}

double OpenFaceLaw::inflow(Part part, double head) const {
  switch (part) {
    case Part::air:
      return rain;
    case Part::wet:
      return wet_conductance * (wet_head - head);
    case Part::dry:
      return dry_conductance * (dry_head - head);
    case Part::closed:
      return 0.0;
  }
  return 0.0;
}

double OpenFaceLaw::conductance(Part part) const {
  return part == Part::wet ? wet_conductance : part == Part::dry ? dry_conductance : 0.0;
}

}  // namespace slope::seepage
