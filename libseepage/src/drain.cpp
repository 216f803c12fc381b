#include "slope/seepage/drain.hpp"

#include "slope/seepage/pore_flow.hpp"

namespace slope::seepage {

DrainLaw law_of(const Drain& drain, const PoreFlow& flow, double /*elevation*/, double head) {
  const std::size_t p = drain.particle;
  return {drain.width * flow.conductivity(p), drain.width * flow.conductivity_slope(p), head,
          drain.width * flow.soil(p).hydraulic_conductivity};
}

}  // namespace slope::seepage
