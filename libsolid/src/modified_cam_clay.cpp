#include "slope/solid/modified_cam_clay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slope::solid {

namespace {

constexpr double largest_part = 1.0e-3;  // strain that is taken at once
constexpr double largest_step = 1.0;     // strain

double mean_stress_of(const SymmetricTensor& stress) {
  return -trace(stress) / 3.0;
}

double product(const SymmetricTensor& a, const SymmetricTensor& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2.0 * a.xy * b.xy;
}

// Where a function passes from below zero at `low` to above at `high` (Ridders 1979); an end that is not on its side
// is the answer.
template <class Function>
double crossing(const Function& function, double low, double high) {
  double below = function(low), above = function(high);
  if (!(below < 0.0)) return low;
  if (!(above > 0.0)) return high;
  const double sharp = 1.0e-13 * std::max(std::abs(low), std::abs(high));
  while (high - low > sharp) {
    const double middle = 0.5 * (low + high), at_middle = function(middle);
    const double root = std::sqrt(at_middle * at_middle - below * above);
    if (root == 0.0) return middle;
    const double guess = middle - (middle - low) * at_middle / root;
    const double at_guess = function(guess);
    if (at_guess == 0.0 || !(low < middle && middle < high)) return guess;
    // the middle and the guess bound the crossing, or one of them and an end
    for (const auto& [place, value] : {std::pair(middle, at_middle), std::pair(guess, at_guess)}) {
      if (place <= low || place >= high) continue;
      (value < 0.0 ? low : high) = place;
      (value < 0.0 ? below : above) = value;
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

// A strain increment taken at once, as a function of y, what the specific volume loses for good in it (positive in
// compression): mean stress and p_c follow from y alone, the shear stress from f = 0, and the flow rule decides on y.
struct HardeningEllipse::Part {
  const HardeningEllipse& law;
  double mean_stress, preconsolidation;   // p and p_c before (Pa)
  double specific_volume, loss;           // v, and what it loses in all
  double squared, mixed, strain_squared;  // s:s / 2 before, s:e and e:e / 2

  [[nodiscard]] double swelling(double y) const { return (loss - y) / law.strength_.kappa; }
  [[nodiscard]] double p(double y) const { return law.after(mean_stress, swelling(y)); }
  [[nodiscard]] double p_c(double y) const {
    const double hardened = preconsolidation * std::exp(y / (law.strength_.lambda - law.strength_.kappa));
    return std::max(hardened, law.strength_.minimum_mean_stress);
  }
  [[nodiscard]] double shear_modulus(double y) const {
    return law.shear_over_bulk_ * specific_volume / law.strength_.kappa * law.secant(mean_stress, swelling(y));
  }
  [[nodiscard]] double trial_q(double shear) const {
    return std::sqrt(std::max(0.0, 3.0 * (squared + 2.0 * shear * (mixed + 2.0 * shear * strain_squared))));
  }
  [[nodiscard]] double q(double p, double p_c) const {
    return law.strength_.critical_state_ratio * std::sqrt(std::max(0.0, p * (p_c - p)));
  }

  // Flow rule: y / v = (q_trial / q - 1) M^2 / (6 G) (2 p - p_c), times 6 G q. Beyond the critical state, where y and
  // 2 p - p_c would differ in sign, only y counts.
  [[nodiscard]] double flow_rule(double y, bool wet) const {
    const double shear = shear_modulus(y), p_now = p(y), p_c_now = p_c(y), slope = 2.0 * p_now - p_c_now;
    const double ratio = law.strength_.critical_state_ratio;
    if (wet != (slope > 0.0)) return 3.0 * shear * ratio * p_c_now * y / specific_volume;
    const double q_now = q(p_now, p_c_now);
    return 6.0 * shear * q_now * y / specific_volume - ratio * ratio * (trial_q(shear) - q_now) * slope;
  }

  [[nodiscard]] bool yields() const {
    const double now = p(0.0), q_over_m = trial_q(shear_modulus(0.0)) / law.strength_.critical_state_ratio;
    return q_over_m * q_over_m + now * (now - preconsolidation) > 0.0;
  }

  [[nodiscard]] double plastic_loss() const {
    const double kappa = law.strength_.kappa, lambda = law.strength_.lambda, trial = p(0.0);
    const double to_middle = kappa * (law.scaled(trial) - law.scaled(0.5 * preconsolidation));
    const bool wet = 2.0 * trial > preconsolidation;
    const auto rule = [this, wet](double y) { return flow_rule(y, wet); };
    if (wet) {
      const double to_tip = kappa * (lambda - kappa) / lambda * std::log(std::max(1.0, trial / preconsolidation));
      return crossing(rule, to_tip, to_middle);
    }
    const double to_origin = kappa * (law.scaled(trial) - law.scaled(0.0));
    return crossing(rule, to_middle, std::min(0.0, to_origin));
  }
};

HardeningEllipse::HardeningEllipse(const ModifiedCamClay& strength, double poissons_ratio)
    : strength_(strength),
      poissons_ratio_(poissons_ratio),
      shear_over_bulk_(1.5 * (1.0 - 2.0 * poissons_ratio) / (1.0 + poissons_ratio)) {}

double HardeningEllipse::value(const SymmetricTensor& stress, std::span<const double> internal) const {
  const double p = mean_stress_of(stress) / internal[0], ratio = strength_.critical_state_ratio;
  return 3.0 * second_invariant(stress) / (ratio * ratio * internal[0] * internal[0]) + p * (p - 1.0);
}

void HardeningEllipse::initial(const SymmetricTensor& stress, std::span<double> internal) const {
  const double p = std::max(mean_stress_of(stress), strength_.minimum_mean_stress);
  const double q_over_m = std::min(std::sqrt(3.0 * second_invariant(stress)) / strength_.critical_state_ratio, p);
  const double through_stress = p + q_over_m * q_over_m / p;
  internal[0] = std::max(strength_.overconsolidation_ratio.value_or(1.0) * through_stress +
                             strength_.pre_overburden_pressure.value_or(0.0),
                         strength_.preconsolidation_pressure.value_or(0.0));
}

Elastic HardeningEllipse::stiffness(const SymmetricTensor& stress, double specific_volume) const {
  const double p = std::max(mean_stress_of(stress), strength_.minimum_mean_stress);
  return {3.0 * (1.0 - 2.0 * poissons_ratio_) * specific_volume * p / strength_.kappa, poissons_ratio_};
}

// ln(p / p_min), and below p_min its tangent: elastic soil changes it by -dv / kappa.
double HardeningEllipse::scaled(double mean_stress) const {
  const double ratio = mean_stress / strength_.minimum_mean_stress;
  return ratio > 1.0 ? std::log(ratio) : ratio - 1.0;
}

double HardeningEllipse::unscaled(double scaled) const {
  return strength_.minimum_mean_stress * (scaled > 0.0 ? std::exp(scaled) : 1.0 + scaled);
}

double HardeningEllipse::after(double mean_stress, double swelling) const {
  const double p = mean_stress * std::exp(swelling);
  if (std::min(mean_stress, p) >= strength_.minimum_mean_stress) return p;
  return unscaled(scaled(mean_stress) + swelling);
}

// Mean of the stress that K is taken at over the way.
double HardeningEllipse::secant(double mean_stress, double swelling) const {
  constexpr double short_way = 1.0e-6;  // below it the difference is rounding
  if (std::abs(swelling) < short_way) {
    return std::max(after(mean_stress, 0.5 * swelling), strength_.minimum_mean_stress);
  }
  return (after(mean_stress, swelling) - mean_stress) / swelling;
}

double HardeningEllipse::update(const StrainStep& step, std::span<double> internal, SymmetricTensor& stress) const {
  const double volumetric = trace(step.strain), size = std::abs(volumetric) + deviatoric_strain(step.strain);
  if (!(size <= largest_step)) {
    stress.xx = std::numeric_limits<double>::quiet_NaN();
    return 0.0;
  }
  const double parts = std::max(1.0, std::ceil(size / largest_part));
  const SymmetricTensor whole = deviator(step.strain);
  const SymmetricTensor e{whole.xx / parts, whole.yy / parts, whole.zz / parts, whole.xy / parts};
  double plastic_strain = 0.0;
  for (double done = 0.0; done < parts; done += 1.0) {
    const SymmetricTensor s = deviator(stress);
    const Part part{*this,
                    mean_stress_of(stress),
                    internal[0],
                    step.specific_volume,
                    -step.specific_volume * volumetric / parts,
                    second_invariant(s),
                    product(s, e),
                    second_invariant(e)};
    const bool yields = step.yields && part.yields();
    const double y = yields ? part.plastic_loss() : 0.0;
    const double p = part.p(y), shear = part.shear_modulus(y);
    double scale = 1.0;
    if (yields) {
      internal[0] = part.p_c(y);
      const double trial = part.trial_q(shear), q = part.q(p, internal[0]);
      scale = trial > 0.0 ? q / trial : 0.0;
      plastic_strain += std::max(0.0, trial - q) / (3.0 * shear);
    }
    stress = {scale * (s.xx + 2.0 * shear * e.xx) - p, scale * (s.yy + 2.0 * shear * e.yy) - p,
              scale * (s.zz + 2.0 * shear * e.zz) - p, scale * (s.xy + 2.0 * shear * e.xy)};
  }
  return plastic_strain;
}

}  // namespace slope::solid
