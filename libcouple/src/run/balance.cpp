#include "balance.hpp"

#include <numbers>

namespace slope::couple {

namespace {

// In first periods.
constexpr double first_look = 20.0, last_look = 640.0;
constexpr double still_falling = 0.7;  // of what was unbalanced at the look before
constexpr int steps_between_questions = 20;

}  // namespace

std::optional<double> find_balance(Mixture& mixture, const Actions& actions, const SlopeScale& scale,
                                   const TimeStep& time_step, Yields yields, double wanted,
                                   const InitialObserver& go_on) {
  // near critical for the first shear mode, whose period is about twice that of the first P-wave
  const double damping = 2.0 * std::numbers::pi / scale.period();
  solid::MaterialPointMethod& soil = mixture.soil;
  const bool yielding = yields == Yields::yes;
  const solid::StepMode mode{.yields = yielding, .moves = false, .accumulates_strain = false};
  double unbalanced = 0.0;
  double look = first_look, before = never;
  int steps = 0;
  double dt = 0.0;
  for (double t = 0.0;; t += dt) {
    if (t >= look * scale.period()) {
      if (unbalanced > still_falling * before || look >= last_look) break;
      before = unbalanced;
      look *= 2.0;
    }
    dt = time_step();
    soil.predict(dt, mixture.pore_state(), actions.loads(), damping);
    soil.advance(dt, mixture.water.suction(), mode);
    unbalanced = soil.balance().unbalanced_force / soil.balance().weight;
    if (t > scale.period() && unbalanced < wanted) break;
    const bool asks = ++steps % steps_between_questions == 0;
    if (asks && !go_on({yielding ? "stress" : "elastic stress", unbalanced, wanted})) return std::nullopt;
  }
  return unbalanced;
}

}  // namespace slope::couple
