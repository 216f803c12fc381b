#include "scheme.hpp"

#include <algorithm>

namespace slope::couple {

AnyScheme make_scheme(const Case& input) {
  if (input.scheme == Scheme::explicit_two_pass) return ExplicitScheme();
  if (input.scheme == Scheme::seepage) return SeepageScheme();
  return SemiImplicitScheme(input.numerics.pressure_tolerance);
}

double longest_step(const AnyScheme& scheme, const Mixture& mixture, double courant_number) {
  return std::visit(BySchemes{[](const SeepageScheme& water_alone) { return water_alone.state(); },
                              [&](const auto& coupled) { return coupled.stable_step(mixture, courant_number); }},
                    scheme);
}

Clock clock_limits(const AnyScheme& scheme, const Case& input, const Mixture& mixture) {
  Clock limits = input.clock;
  limits.maximum_factor = std::visit(
      BySchemes{[&](const ExplicitScheme& explicit_flow) {
                  return std::min(limits.maximum_factor,
                                  explicit_flow.largest_clock_factor(mixture, input.numerics.courant_number));
                },
                [&](const auto& /*bears any*/) { return limits.maximum_factor; }},
      scheme);
  return limits;
}

double water_step(const AnyScheme& scheme) {
  return std::visit(BySchemes{[](const SeepageScheme& water_alone) { return water_alone.state(); },
                              [](const auto& /*paced by the clock*/) { return 0.0; }},
                    scheme);
}

void set_water_step(AnyScheme& scheme, double step) {
  std::visit(BySchemes{[step](SeepageScheme& water_alone) { water_alone.set_state(step); },
                       [](auto& /*paced by the clock*/) {}},
             scheme);
}

}  // namespace slope::couple
