#include "scheme.hpp"

#include <algorithm>

namespace slope::couple {

AnyScheme make_scheme(const Case& input) {
  if (input.scheme == Scheme::explicit_two_pass) return ExplicitScheme();
  if (input.scheme == Scheme::seepage) return SeepageScheme();
  return SemiImplicitScheme(input.numerics.pressure_tolerance);
}

double stable_step(const AnyScheme& scheme, const Mixture& mixture, double courant_number) {
  return std::visit([&](const auto& s) { return s.stable_step(mixture, courant_number); }, scheme);
}

Clock clock_limits(const AnyScheme& scheme, const Case& input, const Mixture& mixture) {
  Clock limits = input.clock;
  if (std::holds_alternative<ExplicitScheme>(scheme)) {
    limits.maximum_factor =
        std::min(limits.maximum_factor, ExplicitScheme::largest_clock_factor(mixture, input.numerics.courant_number));
  }
  return limits;
}

}  // namespace slope::couple
