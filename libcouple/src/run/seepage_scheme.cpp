#include "seepage_scheme.hpp"

#include <algorithm>
#include <cmath>

#include "slope/couple/simulation.hpp"

namespace slope::couple {

namespace {

constexpr double pressure_tolerance = 1.0;  // Pa, a tenth of a millimetre of head
constexpr double saturation_change = 0.02;  // that a step is meant to bring to a particle at most
constexpr double fastest_growth = 1.5;      // of the step, from one to the next
constexpr int easy_iterations = 10;         // of Newton's method, beyond which the step does not grow
constexpr double shortest_step = 1.0e-6;    // s

}  // namespace

double SeepageScheme::pace(double time, double next) const {
  return (next - time) / std::max(1.0, std::ceil((next - time) / step_ * (1.0 - 1.0e-12)));
}

seepage::SolveReport SeepageScheme::step(Mixture& mixture, const Actions& actions, double time_step,
                                         double clock_factor) {
  const double water_step = clock_factor * time_step;
  const std::span<const double> saturation = mixture.water.saturation();
  saturation_.assign(saturation.begin(), saturation.end());
  const auto report =
      water_step_.advance(mixture.water, water_step, mixture.skeleton(), actions.water, pressure_tolerance);
  if (!report.converged) {
    step_ = 0.25 * water_step;
    if (step_ < shortest_step) throw SimulationError("the pore water's equations have no solution for any step");
    return report;
  }
  double change = 0.0;
  for (std::size_t p = 0; p < saturation_.size(); ++p) {
    change = std::max(change, std::abs(saturation[p] - saturation_[p]));
  }
  const double growth = std::clamp(saturation_change / std::max(change, 1.0e-9), 0.5,
                                   report.iterations > easy_iterations ? 1.0 : fastest_growth);
  // a step cut short by what is due says nothing about longer ones, save that they would be as good
  step_ = growth < 1.0 ? growth * water_step : std::max(step_, growth * water_step);
  return report;
}

}  // namespace slope::couple
