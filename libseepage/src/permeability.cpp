#include "slope/seepage/permeability.hpp"

#include <algorithm>

namespace slope::seepage {

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
