#include "slope/seepage/mean_conductivity.hpp"

#include <algorithm>
#include <cmath>

#include "exponential_fitting.hpp"

namespace slope::seepage {

namespace {

constexpr double longest = 40.0;      // x beyond which nothing changes any more
constexpr double bend_width = 0.005;  // of the passage to the level mean, of the conductivity

// At one pressure a soil has one conductivity, whatever the last digits of the law and its table say.
bool equal(const PotentialAt& a, const PotentialAt& b) {
  if (std::abs(a.pressure_head - b.pressure_head) <= 1.0e-9 * std::abs(b.pressure_head)) return true;
  return std::abs(a.conductivity - b.conductivity) <= 1.0e-6 * b.conductivity;
}

// Gravity helps: the wetter end is above, or the path is level. The level mean is more where the curve is flat at the
// wetter end and steep at the other: soil that is wet over most of the path conducts its weight of water too.
struct DownMean {
  DownMean(const PotentialAt& a, const PotentialAt& b, double z)
      : drop(z),
        gain(a.potential - b.potential),
        x((a.conductivity - b.conductivity) / gain * drop),
        weight(1.0 / phi(-x)),
        whole(a.pressure_head - b.pressure_head + drop),
        fall(a.pressure_head - b.pressure_head),
        level(gain / fall),
        exponential((b.conductivity * drop + gain * weight) / whole) {}

  // No less than the level mean, nearly: it bends over to it without a kink.
  [[nodiscard]] double mean() const {
    const double lack = 1.0 - exponential / level;
    return lack > 0.0 ? exponential + level * lack * lack / (lack + bend_width) : exponential;
  }

  [[nodiscard]] double slope_at(const PotentialAt& a, double slope) const {
    const double bend = weight * log_phi_slope(-x) * (drop * slope - x * a.conductivity);
    const double over = (a.conductivity * weight + bend - exponential) / whole;
    const double lack = 1.0 - exponential / level;
    if (lack <= 0.0) return over;
    const double over_level = (a.conductivity - level) / fall, sum = lack + bend_width;
    const double over_lack = (exponential / level * over_level - over) / level;
    return over + over_level * lack * lack / sum + level * lack * (lack + 2.0 * bend_width) / (sum * sum) * over_lack;
  }

  double drop, gain, x, weight, whole, fall, level, exponential;
};

// Gravity opposes: the wetter end is below.
struct UpMean {
  UpMean(const PotentialAt& a, const PotentialAt& b, double z)
      : drop(z),
        more(a.conductivity - b.conductivity),
        fall(a.pressure_head - b.pressure_head),
        d(std::log(a.conductivity / b.conductivity)),
        x(std::clamp(d / fall * drop, -longest, longest)),
        exponential(b.conductivity * phi(d + x) / phi(x)),
        level((a.potential - b.potential) / fall),
        ratio(level * d / more),
        share(fall / (fall - drop)),
        mean(exponential * (1.0 + (ratio - 1.0) * share)) {}

  [[nodiscard]] double slope_at(const PotentialAt& a, double slope) const {
    const double over_d = slope / a.conductivity;
    const double over_x = std::abs(x) < longest ? (drop * over_d - x) / fall : 0.0;
    const double of_exponential = log_phi_slope(d + x) * (over_d + over_x) - log_phi_slope(x) * over_x;
    const double of_ratio = (a.conductivity - level) / (fall * level) - (slope - more / d * over_d) / more;
    const double over_share = -drop / ((fall - drop) * (fall - drop));
    return mean * of_exponential + exponential * (ratio * of_ratio * share + (ratio - 1.0) * over_share);
  }

  double drop, more, fall, d, x, exponential, level, ratio, share, mean;
};

bool gravity_helps(const PotentialAt& a, const PotentialAt& b, double drop) {
  return (a.conductivity - b.conductivity) * drop >= 0.0;
}

}  // namespace

double logarithmic_mean(double a, double b) {
  constexpr double alike = 1.0e-3;  // difference over the mean below which Simpson's rule is exact to rounding
  const double sum = a + b, difference = a - b;
  if (2.0 * std::abs(difference) < alike * sum) return (sum + 4.0 * std::sqrt(a * b)) / 6.0;
  return difference / std::log(a / b);
}

double kirchhoff_mean(const PotentialAt& a, const PotentialAt& b, double drop) {
  if (equal(a, b)) return 0.5 * (a.conductivity + b.conductivity);
  return gravity_helps(a, b, drop) ? DownMean(a, b, drop).mean() : UpMean(a, b, drop).mean;
}

double kirchhoff_mean_slope(const PotentialAt& a, const PotentialAt& b, double drop, double slope) {
  if (equal(a, b)) return 0.5 * slope;
  return gravity_helps(a, b, drop) ? DownMean(a, b, drop).slope_at(a, slope) : UpMean(a, b, drop).slope_at(a, slope);
}

}  // namespace slope::seepage
