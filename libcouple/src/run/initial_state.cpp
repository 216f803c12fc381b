#include "initial_state.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <numbers>
#include <sstream>
#include <string>

#include "slope/seepage/rigid_step.hpp"

namespace slope::couple {

namespace {

constexpr double balanced = 1.0e-6;  // unbalanced over gravity forces at which the stress is taken as found
// The search is looked at when it has gone on for this many first periods, and each time this has doubled: it goes on
// while what is unbalanced has fallen by enough. Soil that stands by a hair comes to rest slowly; soil that falls does
// not.
constexpr double first_look = 20.0, last_look = 640.0;
constexpr double still_falling = 0.7;  // of what was unbalanced at the look before
constexpr int steps_between_questions = 20;

std::string number_text(double value) {
  std::ostringstream text;
  text << std::setprecision(4) << value;
  return text.str();
}

// Damped motion at fixed positions until the forces balance. Returns the unbalanced over the gravity forces; none if it
// was not to go on.
std::optional<double> find_balance(Mixture& mixture, const Actions& actions, const SlopeScale& scale,
                                   const TimeStep& time_step, bool yields, const InitialObserver& go_on) {
  // near critical for the first shear mode, whose period is about twice that of the first P-wave
  const double damping = 2.0 * std::numbers::pi / scale.period();
  solid::MaterialPointMethod& soil = mixture.soil;
  const solid::StepMode mode{.yields = yields, .moves = false, .accumulates_strain = false};
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
    if (t > scale.period() && unbalanced < balanced) break;
    const bool asks = ++steps % steps_between_questions == 0;
    if (asks && !go_on({yields ? "stress" : "elastic stress", unbalanced, balanced})) return std::nullopt;
  }
  return unbalanced;
}

// Vertical effective stress by the weight of what lies above in the same column, one spacing wide, and of half the
// particle itself; under standing water by the weight less the buoyancy, and the pore pressure less the water's.
void set_overburden(Mixture& mixture, const StandingWater& standing, double gravity, double spacing) {
  solid::Particles& p = mixture.soil.particles();
  const std::vector<double> water_mass = mixture.water_mass();
  const double left = *std::ranges::min_element(p.x);
  std::map<long, std::vector<std::size_t>> columns;
  for (std::size_t i = 0; i < p.size(); ++i) columns[std::lround((p.x[i] - left) / spacing)].push_back(i);
  for (auto& [number, column] : columns) {
    std::ranges::sort(column, [&p](std::size_t a, std::size_t b) { return p.y[a] > p.y[b]; });
    double above = 0.0;
    for (const std::size_t i : column) {
      double own = (p.solid_mass[i] + water_mass[i]) * gravity / spacing;
      double pressure = mixture.water.pore_stress()[i];
      if (!standing.pressure.empty()) {
        own += p.volume[i] * standing.gradient_y[i] / spacing;
        pressure -= standing.pressure[i];
      }
      p.syy[i] = std::min(0.0, pressure - above - 0.5 * own);
      above += own;
    }
  }
}

void set_horizontal_stress(solid::Particles& p, std::span<const double> k0) {
  for (std::size_t i = 0; i < p.size(); ++i) p.sxx[i] = p.szz[i] = k0[p.soil[i]] * p.syy[i];
}

// Which particle keeps the flow from being steady: the one whose pressure changed most in the latest step.
std::string unsteady_text(const Mixture& mixture, std::span<const double> change, double longest_step) {
  if (change.empty()) {
    return "the steady state of the pore water before the start was not found: its equations have no solution for any "
           "step; make the particles smaller, or give retention curves with n near 1 an air_entry";
  }
  const std::span<const double> pressure = mixture.water.pressure();
  std::size_t worst = 0;
  for (std::size_t p = 0; p < change.size(); ++p) {
    if (std::abs(change[p]) > std::abs(change[worst])) worst = p;
  }
  const solid::Particles& soil = mixture.soil.particles();
  return "the steady state of the pore water before the start was not found in 400 steps, the longest of " +
         number_text(longest_step) + " s: particle " + std::to_string(worst) + " at x = " + number_text(soil.x[worst]) +
         " m, y = " + number_text(soil.y[worst]) + " m, with a pressure of " + number_text(pressure[worst]) +
         " Pa, still " + (change[worst] > 0.0 ? "gets wetter, by " : "dries, by ") +
         number_text(std::abs(change[worst])) +
         " Pa in the latest step. Either water can enter and not leave, or leave and not enter, and no steady state "
         "exists; or its soil's conductivity falls too steeply near saturation: give its retention an air_entry";
}

}  // namespace

bool find_steady_flow(Mixture& mixture, BoundaryConditions& conditions, const InitialObserver& go_on) {
  Actions actions;
  conditions.apply_initial(mixture, actions);
  seepage::RigidStep water_step;
  const double tolerance = 1.0e-3;  // Pa
  const double steady = 1.0e8;      // s
  double step = 1.0;                // s; doubled while Newton's method converges
  double change = never, longest = 0.0;
  for (int k = 0; k < 400; ++k) {
    const auto report = water_step.advance(mixture.water, step, mixture.skeleton(), actions.water, tolerance);
    if (!report.converged) {
      step *= 0.25;
    } else if (report.largest_change < tolerance && step > steady) {
      return true;
    } else {
      change = report.largest_change;
      longest = std::max(longest, step);
      step = std::min(2.0 * step, 1.0e12);
    }
    if (!go_on({"steady flow", change, tolerance, step})) return false;
  }
  throw SimulationError(unsteady_text(mixture, water_step.pressure_change(), longest));
}

std::optional<double> find_self_weight_stress(Mixture& mixture, const Actions& actions, const SlopeScale& scale,
                                              const TimeStep& time_step, const InitialObserver& go_on) {
  if (!find_balance(mixture, actions, scale, time_step, false, go_on)) return std::nullopt;
  mixture.soil.set_internal_variables();
  const auto unbalanced = find_balance(mixture, actions, scale, time_step, true, go_on);
  mixture.soil.stop();
  return unbalanced;
}

std::optional<double> find_k0_stress(Mixture& mixture, const Actions& actions, const SlopeScale& scale,
                                     const TimeStep& time_step, double spacing, std::span<const double> k0,
                                     const InitialObserver& go_on) {
  solid::MaterialPointMethod& soil = mixture.soil;
  set_overburden(mixture, actions.standing_water, scale.gravity, spacing);
  set_horizontal_stress(soil.particles(), k0);
  // the grid's own balance differs a little from the overburden: take the ratio again from what it found
  if (!find_balance(mixture, actions, scale, time_step, false, go_on)) return std::nullopt;
  soil.stop();
  set_horizontal_stress(soil.particles(), k0);
  soil.set_internal_variables();
  const auto unbalanced = find_balance(mixture, actions, scale, time_step, true, go_on);
  soil.stop();
  return unbalanced;
}

bool add_standing_acceleration(Mixture& mixture, Actions actions, std::array<double, 2> acceleration,
                               const SlopeScale& scale, const TimeStep& time_step, const InitialObserver& go_on) {
  if (acceleration == std::array{0.0, 0.0}) return true;
  actions.body_acceleration = acceleration;
  const bool done = find_balance(mixture, actions, scale, time_step, true, go_on).has_value();
  mixture.soil.stop();
  return done;
}

}  // namespace slope::couple
