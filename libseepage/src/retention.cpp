#include "slope/seepage/retention.hpp"

#include <algorithm>
#include <cmath>

namespace slope::seepage {

namespace {

Saturation within(const SaturationRange& range, double effective, double effective_slope) {
  const double span = range.maximum - range.residual;
  return {range.residual + span * effective, span * effective_slope};
}

}  // namespace

Saturation VanGenuchten::evaluate(double suction_head) const {
  if (suction_head <= 0.0) return {range.maximum, 0.0};
  const double m = 1.0 - 1.0 / n;
  const double x_n = std::pow(alpha * suction_head, n);
  const double effective = std::pow(1.0 + x_n, -m);
  return within(range, effective, -m * n * effective * x_n / ((1.0 + x_n) * suction_head));
}

Saturation LiakopoulosRetention::evaluate(double suction_head) const {
  if (suction_head <= 0.0) return {1.0, 0.0};
  const double drop = coefficient * std::pow(suction_head, exponent);
  if (1.0 - drop <= floor) return {floor, 0.0};
  return {1.0 - drop, -exponent * drop / suction_head};
}

Saturation ExponentialRetention::evaluate(double suction_head) const {
  if (suction_head <= 0.0) return {range.maximum, 0.0};
  const double effective = std::exp(-alpha * suction_head);
  return within(range, effective, -alpha * effective);
}

}  // namespace slope::seepage
