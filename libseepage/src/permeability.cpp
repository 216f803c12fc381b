#include "slope/seepage/permeability.hpp"

#include <algorithm>

#include "require.hpp"

namespace slope::seepage {

void RelativePermeability::check() const {
  std::visit([](const auto& l) { l.check(); }, law);
  require(floor > 0.0 && floor < 1.0, "floor", "above 0 and below 1", floor);
}

double RelativePermeability::evaluate(double suction_head, double saturation) const {
  const double value = std::visit([&](const auto& l) { return l.evaluate(suction_head, saturation); }, law);
  return std::max(value, floor);
}

double RelativePermeability::slope(double suction_head, const Saturation& saturation) const {
  return std::visit(
      [&](const auto& l) {
        return l.evaluate(suction_head, saturation.saturation) > floor ? l.slope(suction_head, saturation) : 0.0;
      },
      law);
}

}  // namespace slope::seepage
