#include "slope/seepage/conductivity_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "slope/seepage/mean_conductivity.hpp"

namespace slope::seepage {

namespace {

constexpr double per_e_fold = 16.0;       // entries
constexpr double smallest = 1.0e-8;       // suction head of the first entry (m), unless air enters later
constexpr double largest = 1.0e5;         // of the last one (m)
constexpr double rounding = 1.0e-12;      // of the logarithm of a conductivity
constexpr double least_share = 1.0e-200;  // of the saturated conductivity: its logarithm is finite

double share_at(const Soil& soil, double suction_head) {
  const double saturation = evaluate(soil.retention, suction_head).saturation;
  return std::max(soil.relative_permeability.evaluate(suction_head, saturation), least_share);
}

// The largest suction head at which the soil conducts as at zero suction.
double find_wet_end(const Soil& soil) {
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

const Soil& checked(const Soil& soil) {
  soil.check();
  return soil;
}

}  // namespace

ConductivityCurve::ConductivityCurve(const Soil& soil)
    : saturated_(checked(soil).hydraulic_conductivity * share_at(soil, 0.0)),
      wet_(find_wet_end(soil)),
      first_(std::max(wet_ * (1.0 + 1.0e-9), smallest)),
      first_log_(std::log(first_)) {
  const auto cells = static_cast<std::size_t>(std::max(1.0, std::ceil((std::log(largest) - first_log_) * per_e_fold)));
  for (std::size_t i = 0; i <= cells; ++i) {
    const double suction_head = std::exp(first_log_ + static_cast<double>(i) / per_e_fold);
    const double share = share_at(soil, suction_head);
    const double slope = soil.relative_permeability.slope(suction_head, evaluate(soil.retention, suction_head));
    log_.push_back(std::log(soil.hydraulic_conductivity * share));
    slope_.push_back(share > least_share ? slope * suction_head / share / per_e_fold : 0.0);
    const double rate = std::exp(log_.back()) * suction_head / per_e_fold;
    potential_slope_.push_back(-rate);
    potential_curvature_.push_back(-rate * (1.0 / per_e_fold + slope_.back()));
  }
  kink_.assign(log_.size(), false);
  find_kinks();
  integrate();
  find_kinks();
}

// Whether conductivity and potential, as far as it is known, fall everywhere between an entry and the next.
bool ConductivityCurve::falls(std::size_t i) const {
  constexpr int parts = 32;
  for (int k = 0; k < parts; ++k) {
    const double t = static_cast<double>(k) / parts, next = static_cast<double>(k + 1) / parts;
    if (log_between(i, next) > log_between(i, t) + rounding) return false;
    if (!potential_.empty() && potential_between(i, next) > potential_between(i, t)) return false;
  }
  return true;
}

void ConductivityCurve::find_kinks() {
  for (std::size_t i = 0; i + 1 < log_.size(); ++i) {
    if (!falls(i)) kink_[i] = true;
  }
}

// The potential at the entries, from the last to the first, by Gauss' rule with four points.
void ConductivityCurve::integrate() {
  constexpr std::array place{0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263};
  constexpr std::array weight{0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269};
  potential_.assign(log_.size(), 0.0);
  for (std::size_t i = log_.size() - 1; i-- > 0;) {
    double sum = 0.0;
    if (kink_[i]) {
      const double width = std::exp(first_log_ + static_cast<double>(i) / per_e_fold) * std::expm1(1.0 / per_e_fold);
      potential_[i] = potential_[i + 1] + width * logarithmic_mean(std::exp(log_[i]), std::exp(log_[i + 1]));
      continue;
    }
    for (std::size_t k = 0; k < place.size(); ++k) {
      const double suction_head = std::exp(first_log_ + (static_cast<double>(i) + place[k]) / per_e_fold);
      sum += weight[k] * std::exp(log_between(i, place[k])) * suction_head / per_e_fold;
    }
    potential_[i] = potential_[i + 1] + sum;
  }
  wet_potential_ = potential_[0] + 0.5 * (saturated_ + std::exp(log_[0])) * (first_ - wet_);
}

double ConductivityCurve::log_between(std::size_t i, double t) const {
  const double u = 1.0 - t, rise = log_[i + 1] - log_[i];
  if (kink_[i]) return log_[i] + t * rise;
  return u * log_[i] + t * log_[i + 1] + t * u * ((slope_[i] - rise) * u + (rise - slope_[i + 1]) * t);
}

// Of degree five, with slopes and curvatures at both entries; at a kink the integral of an exponential.
double ConductivityCurve::potential_between(std::size_t i, double t) const {
  if (kink_[i]) {
    const double fall = std::max(log_[i] - log_[i + 1], rounding);
    const double share = std::expm1(-fall * (1.0 - t)) / std::expm1(-fall) * std::exp(-fall * t);
    return potential_[i + 1] + (potential_[i] - potential_[i + 1]) * share;
  }
  const double rise = potential_[i + 1] - potential_[i] - potential_slope_[i] - 0.5 * potential_curvature_[i];
  const double steeper = potential_slope_[i + 1] - potential_slope_[i] - potential_curvature_[i];
  const double bend = potential_curvature_[i + 1] - potential_curvature_[i];
  const double cubic = 10.0 * rise - 4.0 * steeper + 0.5 * bend;
  const double quartic = -15.0 * rise + 7.0 * steeper - bend;
  const double quintic = 6.0 * rise - 3.0 * steeper + 0.5 * bend;
  return potential_[i] +
         t * (potential_slope_[i] + t * (0.5 * potential_curvature_[i] + t * (cubic + t * (quartic + t * quintic))));
}

double ConductivityCurve::potential(double pressure_head) const {
  const double suction_head = -pressure_head;
  if (suction_head <= wet_) return wet_potential_ + saturated_ * (wet_ - suction_head);
  const double place = (std::log(suction_head) - first_log_) * per_e_fold;
  if (suction_head <= first_ || place >= static_cast<double>(log_.size() - 1)) return at(pressure_head).potential;
  const auto i = static_cast<std::size_t>(place);
  return potential_between(i, place - static_cast<double>(i));
}

ConductivityCurve::Value ConductivityCurve::at(double pressure_head) const {
  const double suction_head = -pressure_head;
  if (suction_head <= wet_) return {saturated_, 0.0, wet_potential_ + saturated_ * (wet_ - suction_head)};
  if (suction_head <= first_) {  // straight down to the first entry
    const double fall = (saturated_ - std::exp(log_[0])) / (first_ - wet_), beyond = suction_head - wet_;
    const double conductivity = saturated_ - fall * beyond;
    return {conductivity, fall, wet_potential_ - 0.5 * (saturated_ + conductivity) * beyond};
  }
  const double place = (std::log(suction_head) - first_log_) * per_e_fold;
  const std::size_t last = log_.size() - 1;
  if (place >= static_cast<double>(last)) {
    const double least = std::exp(log_[last]);
    return {least, 0.0, -least * (suction_head - std::exp(first_log_ + static_cast<double>(last) / per_e_fold))};
  }
  const auto i = static_cast<std::size_t>(place);
  const double t = place - static_cast<double>(i), u = 1.0 - t;
  const double rise = log_[i + 1] - log_[i];
  const double a = kink_[i] ? 0.0 : slope_[i] - rise, b = kink_[i] ? 0.0 : rise - slope_[i + 1];
  const double value = std::exp(log_between(i, t));
  const double over_place = rise + (u - t) * (a * u + b * t) + t * u * (b - a);
  return {value, std::max(0.0, -value * over_place * per_e_fold / suction_head), potential_between(i, t)};
}

double ConductivityCurve::suction_head_at(double share) const {
  double wet = smallest, dry = largest;
  if (at(-dry).conductivity >= share * saturated_) return dry;
  while (dry > wet * 1.001) {
    const double middle = std::sqrt(wet * dry);
    (at(-middle).conductivity < share * saturated_ ? dry : wet) = middle;
  }
  return dry;
}

}  // namespace slope::seepage
