#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "clock_control.hpp"
#include "slope/couple/case.hpp"
#include "slope/couple/state.hpp"
#include "step.hpp"

namespace slope::couple {

/// The pace of a scheme that moves the soil: steps of the soil's own time, as long as it is stable, while the water's
/// time runs ahead by the clock's factor.
/// @tparam Coupled  tells its stable_step() and largest_clock_factor(), and does the step()
template <class Coupled>
class ClockPaced {
 public:
  using State = ClockPace;
  static constexpr bool moves_soil = true;

  ClockPaced(Coupled scheme, const Case& input, const Mixture& mixture, const SlopeScale& scale,
             const std::vector<double>& change_times)
      : particles_(mixture.soil.particles().size()),
        scheme_(std::move(scheme)),
        courant_number_(input.numerics.courant_number),
        time_step_(scheme_.stable_step(mixture, courant_number_)),
        clock_(limits(input, mixture), scale, change_times) {}

  StepDone step(const StepTask& task) {
    Mixture& mixture = task.mixture;
    if (mixture.soil.stiffness_varies()) time_step_ = scheme_.stable_step(mixture, courant_number_);
    const ClockControl::Pace pace =
        clock_.pace(task.time, task.next, task.share * time_step_, task.conditions.prescribed_rate(task.time));
    if (pace.velocity_scale < 1.0) mixture.slow_down(pace.velocity_scale);
    const double duration = pace.factor * pace.time_step;
    const double end = end_of_step(task, duration);
    task.conditions.apply(end, mixture, task.actions);
    const seepage::SolveReport report = scheme_.step(mixture, task.actions, pace.time_step, pace.factor);
    const solid::Balance& balance = mixture.soil.balance();
    clock_.observe(pace.time_step, balance.unbalanced_force / balance.weight, task.conditions.first_pressure(),
                   mixture.water.pressure());
    return {end, duration, pace.factor, report};
  }

  /// The longest step of the soil; where its stiffness varies, that of the latest (s).
  [[nodiscard]] double time_step() const { return time_step_; }

  /// Adds how far the soil was out of balance.
  void tell(Summary& summary) const {
    summary.largest_unbalanced_ratio = clock_.largest_unbalanced_ratio();
    summary.unbalanced_limit = clock_.unbalanced_limit();
  }

  [[nodiscard]] State state() const { return {time_step_, clock_.state()}; }
  /// @throws std::invalid_argument if it is of another number of particles
  void set_state(State state) {
    if (!state.clock.pressure.empty() && state.clock.pressure.size() != particles_) {
      throw std::invalid_argument("the clock has not one pressure for each particle");
    }
    time_step_ = state.time_step;
    clock_.set_state(std::move(state.clock));
  }

 private:
  [[nodiscard]] Clock limits(const Case& input, const Mixture& mixture) const {
    Clock limits = input.clock;
    limits.maximum_factor = std::min(limits.maximum_factor, scheme_.largest_clock_factor(mixture, courant_number_));
    return limits;
  }

  std::size_t particles_;
  Coupled scheme_;
  double courant_number_;
  double time_step_;
  ClockControl clock_;
};

}  // namespace slope::couple
