#include "slope/seepage/exchange.hpp"

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

}  // namespace slope::seepage
