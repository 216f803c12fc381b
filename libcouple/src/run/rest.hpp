#pragma once

#include <span>

#include "slope/couple/state.hpp"

namespace slope::couple {

/// Finds when a slide has come to rest: over the last third of the time since its onset, and at least five times
/// sqrt(H / g), also of the soil's own time, no particle moved by more than `rest_share` of what the largest
/// displacement has grown by since the onset. Soil that creeps on evenly moves a third of that in that time, however
/// slowly, so it does not rest; nor does a slide that follows the rain. Judged at times that grow by a half: rest is
/// found when 2.25 times the duration of the slide have passed since the onset, at the latest.
class RestWatch {
 public:
  using State = RestState;
  static constexpr double rest_share = 0.02;

  /// @param slide_time  sqrt(H / g) of the slope (s), > 0.
  explicit RestWatch(double slide_time) : shortest_(5.0 * slide_time) {}

  /// Takes note of a step.
  /// @param since_onset  physical time since the onset (s).  @param own_step  the soil's own time of the step (s).
  /// @param moved  what the largest displacement has grown by since the onset (m).
  /// @return whether the slide rests
  bool observe(double since_onset, double own_step, double moved, std::span<const double> ux,
               std::span<const double> uy);

  [[nodiscard]] const State& state() const { return state_; }
  void set_state(State state) { state_ = std::move(state); }

 private:
  void begin(double since_onset, std::span<const double> ux, std::span<const double> uy);

  double shortest_;  // time between two judgements (s)
  State state_;
};

}  // namespace slope::couple
