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

StepDone SeepageScheme::step(const StepTask& task) {
  for (;;) {
    const double way = task.next - task.time;
    const double equal = way / std::max(1.0, std::ceil(way / state_.next_step * (1.0 - 1.0e-12)));
    state_.latest_step = task.share * equal;
    const double end = end_of_step(task, state_.latest_step);
    task.conditions.apply(end, task.mixture, task.actions);
    const seepage::SolveReport report = advance(task.mixture, task.actions, state_.latest_step);
    if (report.converged) return {.time = end, .duration = state_.latest_step, .report = report};
  }
}

seepage::SolveReport SeepageScheme::advance(Mixture& mixture, const Actions& actions, double duration) {
  const std::span<const double> saturation = mixture.water.saturation();
  saturation_.assign(saturation.begin(), saturation.end());
  const auto report =
      water_step_.advance(mixture.water, duration, mixture.skeleton(), actions.water, pressure_tolerance);
  if (!report.converged) {
    state_.next_step = 0.25 * duration;
    if (state_.next_step < shortest_step)
      throw SimulationError("the pore water's equations have no solution for any step");
    return report;
  }
  double change = 0.0;
  for (std::size_t p = 0; p < saturation_.size(); ++p) {
    change = std::max(change, std::abs(saturation[p] - saturation_[p]));
  }
  const double growth = std::clamp(saturation_change / std::max(change, 1.0e-9), 0.5,
                                   report.iterations > easy_iterations ? 1.0 : fastest_growth);
  // a step cut short by what is due says nothing about longer ones, save that they would be as good
  state_.next_step = growth < 1.0 ? growth * duration : std::max(state_.next_step, growth * duration);
  return report;
}

}  // namespace slope::couple
