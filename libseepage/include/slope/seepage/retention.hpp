#pragma once

#include <variant>

#include "slope/seepage/exponential_retention.hpp"
#include "slope/seepage/liakopoulos_retention.hpp"
#include "slope/seepage/van_genuchten_retention.hpp"

namespace slope::seepage {

/// The water retention curve of a soil: one of the laws, each with evaluate(suction head) -> Saturation,
/// steepest() -> suction head of the largest slope, kink() -> where the slope jumps, and check() of its parameters.
using Retention = std::variant<VanGenuchten, LiakopoulosRetention, ExponentialRetention>;

/// @param suction_head h_s (m), any sign.
[[nodiscard]] inline Saturation evaluate(const Retention& retention, double suction_head) {
  return std::visit([&](const auto& law) { return law.evaluate(suction_head); }, retention);
}

}  // namespace slope::seepage
