#include "slope/seepage/liakopoulos_retention.hpp"

#include <cmath>

namespace slope::seepage {

Saturation LiakopoulosRetention::evaluate(double suction_head) const {
  if (suction_head <= 0.0) return {1.0, 0.0};
  const double drop = coefficient * std::pow(suction_head, exponent);
  if (1.0 - drop <= floor) return {floor, 0.0};
  return {1.0 - drop, -exponent * drop / suction_head};
}

double LiakopoulosRetention::steepest() const {
  return std::pow((1.0 - floor) / coefficient, 1.0 / exponent) * (1.0 - 1.0e-6);
}

}  // namespace slope::seepage
