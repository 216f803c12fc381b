#include "slope/seepage/mean_conductivity.hpp"

#include <algorithm>
#include <cmath>

namespace slope::seepage {

namespace {

constexpr double alike = 0.1;     // |d| below which a short formula takes over, in full below half of it
constexpr double longest = 40.0;  // x beyond which nothing changes any more

// (e^t - 1) / t
double phi(double t) {
  return std::abs(t) < 1.0e-3 ? 1.0 + t * (0.5 + t / 6.0) : std::expm1(t) / t;
}

// Slope of ln(phi).
double log_phi_slope(double t) {
  if (std::abs(t) < 1.0e-3) return 0.5 + t / 12.0;
  return -1.0 / std::expm1(-t) - 1.0 / t;
}

// x, and how it changes with d. Two soils may have d against psi: then both are 0.
struct Length {
  double x = 0.0, over_d = 0.0;
};

Length length_of(double d, double fall, double drop) {
  if (d * fall <= 0.0) return {};
  const double x = d / fall * drop;
  return std::abs(x) < longest ? Length{x, drop / fall} : Length{std::copysign(longest, x), 0.0};
}

// For ends that are alike: Simpson's rule, and to first order in d how far the wet end counts for more. Of
// coth(x/2) - 2/x it takes a fraction with the same ends, within 7 %.
double mean_of_alike(const ConductivityAt& a, const ConductivityAt& b, double drop) {
  const double sum = a.conductivity + b.conductivity;
  const double level = (sum + 4.0 * std::sqrt(a.conductivity * b.conductivity)) / 6.0;
  const double d = 2.0 * (a.conductivity - b.conductivity) / sum;
  const double y = 0.5 * length_of(d, a.pressure_head - b.pressure_head, drop).x, size = std::abs(y);
  return level * (1.0 + 0.5 * d * y / (1.0 + size + 4.0 / (2.0 + size)));
}

double mean_of_unlike(const ConductivityAt& a, const ConductivityAt& b, double drop) {
  const double d = std::log(a.conductivity / b.conductivity);
  const double x = length_of(d, a.pressure_head - b.pressure_head, drop).x;
  return b.conductivity * phi(d + x) / phi(x);
}

bool equal(const PotentialAt& a, const PotentialAt& b) {
  return std::abs(a.conductivity - b.conductivity) <= 1.0e-6 * b.conductivity;
}

// With G the exponential's mean, L its level mean, W the conductivity of the upper end and M the level mean of the true
// curve it is W - (W - M) (W - G) / (W - L).
struct TrueMean {
  TrueMean(const PotentialAt& a, const PotentialAt& b, double drop)
      : more(a.conductivity - b.conductivity),
        fall(a.pressure_head - b.pressure_head),
        gain(a.potential - b.potential),
        d(std::log(a.conductivity / b.conductivity)),
        x(std::clamp(drop * more / gain, -longest, longest)),
        follows_first(x > 0.0),
        exponential(b.conductivity * phi(d + x) / phi(x)),
        exponential_level(more / d),
        level(gain / fall),
        limit(follows_first ? a.conductivity : b.conductivity),
        ratio((limit - exponential) / (limit - exponential_level)) {}

  [[nodiscard]] double value() const { return limit - (limit - level) * ratio; }

  // Over the pressure head at a.
  [[nodiscard]] double slope_at(const PotentialAt& a, double slope) const {
    const double over_d = slope / a.conductivity;
    const double over_x = std::abs(x) < longest ? x * (slope / more - a.conductivity / gain) : 0.0;
    const double over_exponential =
        exponential * (log_phi_slope(d + x) * (over_d + over_x) - log_phi_slope(x) * over_x);
    const double over_exponential_level = (slope - exponential_level * over_d) / d;
    const double over_level = (a.conductivity - level) / fall;
    const double over_limit = follows_first ? slope : 0.0;
    const double over_ratio =
        (over_limit - over_exponential - ratio * (over_limit - over_exponential_level)) / (limit - exponential_level);
    return over_limit - (over_limit - over_level) * ratio - (limit - level) * over_ratio;
  }

  double more, fall, gain;  // of the conductivity, the pressure head and the potential from b to a
  double d, x;
  bool follows_first;
  double exponential, exponential_level, level, limit, ratio;
};

}  // namespace

double mean_conductivity(const ConductivityAt& a, const ConductivityAt& b, double drop) {
  const double sum = a.conductivity + b.conductivity;
  const double difference = 2.0 * std::abs(a.conductivity - b.conductivity);  // over the sum: |d|, nearly
  if (difference < 0.5 * alike * sum) return mean_of_alike(a, b, drop);
  const double mean = mean_of_unlike(a, b, drop);
  if (difference > alike * sum) return mean;
  const double share = difference / (0.5 * alike * sum) - 1.0;
  return share * mean + (1.0 - share) * mean_of_alike(a, b, drop);
}

double mean_conductivity_slope(const ConductivityAt& a, const ConductivityAt& b, double drop, double slope) {
  const double d = std::log(a.conductivity / b.conductivity);
  const double fall = a.pressure_head - b.pressure_head;
  const Length length = length_of(d, fall, drop);
  const double both = log_phi_slope(d + length.x), rest = log_phi_slope(length.x);
  const double over_d = both * (1.0 + length.over_d) - rest * length.over_d;
  const double over_fall = length.over_d != 0.0 ? -(both - rest) * length.x / fall : 0.0;
  return mean_conductivity(a, b, drop) * (over_d * slope / a.conductivity + over_fall);
}

double kirchhoff_mean(const PotentialAt& a, const PotentialAt& b, double drop) {
  return equal(a, b) ? 0.5 * (a.conductivity + b.conductivity) : TrueMean(a, b, drop).value();
}

double kirchhoff_mean_slope(const PotentialAt& a, const PotentialAt& b, double drop, double slope) {
  return equal(a, b) ? 0.5 * slope : TrueMean(a, b, drop).slope_at(a, slope);
}

}  // namespace slope::seepage
