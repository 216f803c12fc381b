#include "initial_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slope/couple/simulation.hpp"

namespace slope::couple {

namespace {

constexpr double balanced = 1.0e-6;      // unbalanced over gravity forces at which the stress is taken as found
constexpr double longest_search = 40.0;  // first periods

}  // namespace

std::vector<double> initial_pressure(const Case& input, const InitialParticles& particles) {
  const double unit_weight = input.water.density * input.gravity;
  std::vector<double> pressure(particles.x.size());
  for (std::size_t p = 0; p < pressure.size(); ++p) {
    if (const auto* hydrostatic = std::get_if<HydrostaticWater>(&input.initial_water)) {
      pressure[p] = std::max(unit_weight * (hydrostatic->water_table - particles.y[p]), -hydrostatic->maximum_suction);
    } else if (const auto* uniform = std::get_if<UniformWater>(&input.initial_water)) {
      pressure[p] = uniform->pressure;
    } else {
      pressure[p] = unit_weight * (std::get<SteadyWater>(input.initial_water).water_table - particles.y[p]);
    }
  }
  return pressure;
}

void find_steady_flow(Mixture& mixture, BoundaryConditions& conditions) {
  Actions actions;
  conditions.apply_initial(mixture, actions);
  const double tolerance = 1.0e-3;  // Pa
  double step = 1.0;                // s; doubled while Newton's method converges
  for (int k = 0; k < 400; ++k) {
    const auto report = mixture.water.advance(step, mixture.skeleton(), actions.water, tolerance);
    if (!report.converged) {
      step *= 0.25;
    } else if (report.largest_change < tolerance && step > 1.0e8) {
      return;
    } else {
      step = std::min(2.0 * step, 1.0e12);
    }
  }
  throw SimulationError("the steady state of the pore water before the start was not found in 400 steps");
}

double find_self_weight_stress(Mixture& mixture, const Actions& actions, const SlopeScale& scale, double time_step) {
  // near critical for the first shear mode, whose period is about twice that of the first P-wave
  const double damping = 2.0 * std::numbers::pi / scale.period();
  solid::MaterialPointMethod& soil = mixture.soil;
  double unbalanced = 0.0;
  for (const bool yields : {false, true}) {
    const solid::StepMode mode{.yields = yields, .moves = false, .accumulates_strain = false};
    for (double t = 0.0; t < longest_search * scale.period(); t += time_step) {
      soil.predict(time_step, mixture.pore_state(), actions.tractions, damping);
      soil.advance(time_step, mixture.water.suction(), mode);
      unbalanced = soil.balance().unbalanced_force / soil.balance().weight;
      if (t > scale.period() && unbalanced < balanced) break;
    }
  }
  soil.stop();
  return unbalanced;
}

}  // namespace slope::couple
