#pragma once

#include <variant>

#include "slope/seepage/exponential_retention.hpp"
#include "slope/seepage/liakopoulos_retention.hpp"
#include "slope/seepage/van_genuchten_retention.hpp"

namespace slope::seepage {

/// The water retention curve of a soil: one of the laws, each with evaluate(suction head) -> Saturation
/// and steepest() -> suction head of the largest slope.
using Retention = std::variant<VanGenuchten, LiakopoulosRetention, ExponentialRetention>;

}  // namespace slope::seepage
