#pragma once

#include <variant>

#include "explicit_scheme.hpp"
#include "seepage_scheme.hpp"
#include "semi_implicit_scheme.hpp"

namespace slope::couple {

/// How a step is taken: what the case's `coupling.scheme` names.
using AnyScheme = std::variant<SemiImplicitScheme, ExplicitScheme, SeepageScheme>;

[[nodiscard]] AnyScheme make_scheme(const Case& input);
/// The soil's time step (s); of the water alone, the first.
[[nodiscard]] double stable_step(const AnyScheme& scheme, const Mixture& mixture, double courant_number);
/// The clock's limits, with the largest factor that the scheme bears.
[[nodiscard]] Clock clock_limits(const AnyScheme& scheme, const Case& input, const Mixture& mixture);

}  // namespace slope::couple
