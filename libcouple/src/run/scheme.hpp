#pragma once

#include <variant>

#include "explicit_scheme.hpp"
#include "seepage_scheme.hpp"
#include "semi_implicit_scheme.hpp"

namespace slope::couple {

/// How a step is taken: what the case's `coupling.scheme` names.
using AnyScheme = std::variant<SemiImplicitScheme, ExplicitScheme, SeepageScheme>;

/// One function for each kind of scheme, for std::visit.
template <class... Functions>
struct BySchemes : Functions... {
  using Functions::operator()...;
};

[[nodiscard]] AnyScheme make_scheme(const Case& input);
/// The longest step of the soil (s); of the water alone, the first.
[[nodiscard]] double longest_step(const AnyScheme& scheme, const Mixture& mixture, double courant_number);
/// The clock's limits, with the largest factor that the scheme bears.
[[nodiscard]] Clock clock_limits(const AnyScheme& scheme, const Case& input, const Mixture& mixture);
/// What a scheme remembers from one step to the next (s): how long the next step of the water alone may be; of the
/// others zero, whose pace is the clock's.
[[nodiscard]] double water_step(const AnyScheme& scheme);
void set_water_step(AnyScheme& scheme, double step);

}  // namespace slope::couple
