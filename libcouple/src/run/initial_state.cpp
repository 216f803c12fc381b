#include "initial_state.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>

#include "balance.hpp"
#include "slope/seepage/rigid_step.hpp"

namespace slope::couple {

namespace {

std::string number_text(double value) {
  std::ostringstream text;
  text << std::setprecision(4) << value;
  return text.str();
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
  if (!find_balance(mixture, actions, scale, time_step, Yields::no, balanced, go_on)) return std::nullopt;
  mixture.soil.set_internal_variables();
  const auto unbalanced = find_balance(mixture, actions, scale, time_step, Yields::yes, balanced, go_on);
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
  if (!find_balance(mixture, actions, scale, time_step, Yields::no, balanced, go_on)) return std::nullopt;
  soil.stop();
  set_horizontal_stress(soil.particles(), k0);
  soil.set_internal_variables();
  const auto unbalanced = find_balance(mixture, actions, scale, time_step, Yields::yes, balanced, go_on);
  soil.stop();
  return unbalanced;
}

bool add_standing_acceleration(Mixture& mixture, Actions actions, std::array<double, 2> acceleration,
                               const SlopeScale& scale, const TimeStep& time_step, const InitialObserver& go_on) {
  if (acceleration == std::array{0.0, 0.0}) return true;
  actions.body_acceleration = acceleration;
  const bool done = find_balance(mixture, actions, scale, time_step, Yields::yes, balanced, go_on).has_value();
  mixture.soil.stop();
  return done;
}

}  // namespace slope::couple
