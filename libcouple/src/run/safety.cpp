#include "safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "slope/solid/tensor.hpp"

namespace slope::couple {

namespace {

constexpr double most = 20.0, least = 0.02;  // factors between which it is looked for
// Of the factor, from a guess and from an earlier one, until it is bracketed; then twice as much each time.
constexpr double first_growth = 0.1, later_growth = 0.02;
constexpr double margin = 0.1;      // of the bracket, from its ends: there, and outside, no estimate is believed
constexpr double slow = 0.1;        // share of the largest speed up to which soil does not belong to what moves
constexpr int strained_steps = 10;  // over which the strain of a flow is measured

}  // namespace

SafetySearch::SafetySearch(const Mixture& slope, const Actions& actions, const SlopeScale& scale, double courant_number,
                           const GroundSurface& surface)
    : slope_(slope),
      actions_(actions),
      scale_(scale),
      courant_number_(courant_number),
      surface_(surface),
      stressed_(slope.soil.particles()) {
  mechanism_.speed.assign(stressed_.size(), 0.0);
  mechanism_.shear_strain.assign(stressed_.size(), 0.0);
}

std::optional<FactorOfSafety> SafetySearch::find(double tolerance, std::optional<double> earlier,
                                                 const InitialObserver& go_on) {
  double growth = earlier ? later_growth : first_growth;
  double factor = earlier.value_or(1.0);
  for (;;) {
    const auto trial = attempt(factor, go_on);
    if (!trial) return std::nullopt;
    ++found_.trials;
    if (trial->unbalanced <= unbalanced_limit) {
      borne_ = trial;
      if (factor >= most) break;
    } else {
      too_much_.push_back(*trial);
      if (factor <= least) break;
    }
    if (borne_ && !too_much_.empty() && too_much_.back().factor - borne_->factor <= tolerance * borne_->factor) break;
    factor = std::clamp(next_factor(growth), least, most);
    growth *= 2.0;
  }
  if (borne_) found_.lower = borne_->factor;
  if (!too_much_.empty()) found_.upper = too_much_.back().factor;
  found_.factor = found_.upper ? 0.5 * (found_.lower + *found_.upper) : found_.lower;
  return found_;
}

// Of the next trial.
double SafetySearch::next_factor(double growth) const {
  if (too_much_.empty()) return borne_->factor * (1.0 + growth);
  const Trial& last = too_much_.back();
  if (!borne_) return last.factor / (1.0 + growth);
  const double width = last.factor - borne_->factor;
  if (too_much_.size() > 1) {
    const Trial& before = too_much_[too_much_.size() - 2];
    const double slope = (before.unbalanced - last.unbalanced) / (before.factor - last.factor);
    const double estimate = last.factor - last.unbalanced / slope;
    if (estimate > borne_->factor + margin * width && estimate < last.factor - margin * width) return estimate;
  }
  return borne_->factor + 0.5 * width;
}

std::optional<SafetySearch::Trial> SafetySearch::attempt(double factor, const InitialObserver& go_on) {
  Mixture trial = slope_;
  trial.soil = slope_.soil.weakened(factor, where_);
  solid::Particles& particles = trial.soil.particles();
  particles.sxx = stressed_.sxx, particles.syy = stressed_.syy;
  particles.szz = stressed_.szz, particles.sxy = stressed_.sxy;
  trial.soil.stop();
  const double first = trial.soil.stable_step(courant_number_, trial.water_mass());
  const TimeStep step = [&] {
    return trial.soil.stiffness_varies() ? trial.soil.stable_step(courant_number_, trial.water_mass()) : first;
  };
  const std::string stage = fmt::format("strength over {:.4g}", factor);
  const auto unbalanced =
      find_balance(trial, actions_, scale_, step, Yields::yes, nearly_balanced, [&](const InitialProgress& progress) {
        return go_on({stage, progress.measure, progress.wanted, 0.0, "factor of safety"});
      });
  if (!unbalanced) return std::nullopt;
  if (*unbalanced <= unbalanced_limit) {
    stressed_ = particles;
  } else {
    take_mechanism(trial);
  }
  return Trial{factor, *unbalanced};
}

void SafetySearch::take_mechanism(Mixture& flowing) {
  solid::MaterialPointMethod& soil = flowing.soil;
  const std::size_t n = soil.particles().size();
  double fastest = 0.0;
  for (std::size_t p = 0; p < n; ++p) {
    mechanism_.speed[p] = std::hypot(soil.particles().vx[p], soil.particles().vy[p]);
    fastest = std::max(fastest, mechanism_.speed[p]);
  }
  found_.area = found_.depth = 0.0;
  for (std::size_t p = 0; p < n; ++p) {
    mechanism_.speed[p] /= fastest;
    if (mechanism_.speed[p] <= slow) continue;
    found_.area += soil.particles().volume[p];
    found_.depth = std::max(found_.depth, surface_.depth(soil.particles().x[p], soil.particles().y[p]));
  }
  solid::Particles before = soil.particles();
  const double dt = soil.stable_step(courant_number_, flowing.water_mass());
  for (int k = 0; k < strained_steps; ++k) {
    soil.predict(dt, flowing.pore_state(), actions_.loads(), 0.0);
    soil.advance(dt, flowing.water.suction(), {.moves = false});
  }
  const auto take_away = [](std::vector<double>& from, const std::vector<double>& to) {
    for (std::size_t p = 0; p < from.size(); ++p) from[p] = to[p] - from[p];
  };
  take_away(before.exx, soil.particles().exx);
  take_away(before.eyy, soil.particles().eyy);
  take_away(before.exy, soil.particles().exy);
  double largest = 0.0;
  for (std::size_t p = 0; p < n; ++p) {
    mechanism_.shear_strain[p] = deviatoric_strain_of(before, p);
    largest = std::max(largest, mechanism_.shear_strain[p]);
  }
  if (largest == 0.0) return;  // all of it goes as one body
  for (double& strain : mechanism_.shear_strain) strain /= largest;
}

}  // namespace slope::couple
