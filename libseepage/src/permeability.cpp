#include "slope/seepage/permeability.hpp"

#include <algorithm>

namespace slope::seepage {

double RelativePermeability::evaluate(double suction_head, double saturation) const {
  const double value = std::visit([&](const auto& l) { return l.evaluate(suction_head, saturation); }, law);
  return std::max(value, floor);
}

}  // namespace slope::seepage
