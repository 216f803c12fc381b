#include "slope/seepage/conductivity_curve.hpp"

#include <algorithm>
#include <cmath>

namespace slope::seepage {

namespace {

constexpr double per_e_fold = 16.0;       // entries
constexpr double smallest = 1.0e-8;       // suction head of the first entry (m), unless air enters later
constexpr double largest = 1.0e5;         // of the last one (m)
constexpr double least_share = 1.0e-200;  // of the saturated conductivity: its logarithm is finite

double share_at(const Soil& soil, double suction_head) {
  const double saturation = evaluate(soil.retention, suction_head).saturation;
  return std::max(soil.relative_permeability.evaluate(suction_head, saturation), least_share);
}

// The largest suction head at which the soil conducts as at zero suction.
double wet_until(const Soil& soil) {
  const double full = share_at(soil, 0.0);
  if (share_at(soil, smallest) < full) return 0.0;
  double wet = smallest, dry = largest;
  if (share_at(soil, dry) >= full) return dry;
  while (dry > wet * (1.0 + 1.0e-12)) {
    const double middle = std::sqrt(wet * dry);
    (share_at(soil, middle) < full ? dry : wet) = middle;
  }
  return wet;
}

}  // namespace

ConductivityCurve::ConductivityCurve(const Soil& soil)
    : saturated_(soil.hydraulic_conductivity * share_at(soil, 0.0)),
      wet_(wet_until(soil)),
      first_(std::max(wet_ * (1.0 + 1.0e-9), smallest)),
      first_log_(std::log(first_)) {
  const auto cells = static_cast<std::size_t>(std::max(1.0, std::ceil((std::log(largest) - first_log_) * per_e_fold)));
  for (std::size_t i = 0; i <= cells; ++i) {
    const double suction_head = std::exp(first_log_ + static_cast<double>(i) / per_e_fold);
    const double share = share_at(soil, suction_head);
    const double slope = soil.relative_permeability.slope(suction_head, evaluate(soil.retention, suction_head));
    log_.push_back(std::log(soil.hydraulic_conductivity * share));
    slope_.push_back(share > least_share ? slope * suction_head / share : 0.0);
  }
}

ConductivityCurve::Value ConductivityCurve::at(double pressure_head) const {
  const double suction_head = -pressure_head;
  if (suction_head <= wet_) return {saturated_, 0.0};
  if (suction_head <= first_) {  // straight down to the first entry
    const double fall = (saturated_ - std::exp(log_[0])) / (first_ - wet_);
    return {saturated_ - fall * (suction_head - wet_), fall};
  }
  const double place = (std::log(suction_head) - first_log_) * per_e_fold;
  const std::size_t last = log_.size() - 1;
  if (place >= static_cast<double>(last)) return {std::exp(log_[last]), 0.0};
  const auto i = static_cast<std::size_t>(place);
  const double t = place - static_cast<double>(i), u = 1.0 - t;
  const double rise = log_[i + 1] - log_[i];
  const double a = slope_[i] / per_e_fold - rise, b = rise - slope_[i + 1] / per_e_fold;
  const double value = std::exp(u * log_[i] + t * log_[i + 1] + t * u * (a * u + b * t));
  const double over_log = per_e_fold * (rise + (u - t) * (a * u + b * t) + t * u * (b - a));
  return {value, std::max(0.0, -value * over_log / suction_head)};
}

}  // namespace slope::seepage
