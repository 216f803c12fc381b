#pragma once

#include <optional>

#include "slope/couple/state.hpp"

namespace slope::couple {

/// Finds when the motion runs away: the kink of the largest displacement u over time, after which it has grown by a
/// given growth, at a mean rate that is `runaway_ratio` times the mean rate before, without slowing down (the second
/// half of that way takes at most `slowing_ratio` times as long as the first). A growth within a given time after the
/// start runs away from the start on: before that the slope rested.
///
/// The kink is where u lies deepest below the chord from the start to now; while the part after it has such a kink of
/// its own, that one counts. So neither creep at an even rate, nor a settlement that fades (u ~ sqrt(t)), nor steps
/// smaller than the growth run away; and where a storm after a dry time makes the slope settle before it slides, the
/// slide counts. The kink lies before the time at which it is found, and depends on nothing later.
///
/// Motion in the sense of the inverse-velocity method (Fukuzono 1985), u ~ 1 / (t_f - t) - 1 / t_f, has such a kink
/// when a share of 1 / runaway_ratio of t_f is left, if u has grown by what is asked; an even, faster slide, such as
/// one that stays in balance with the water, has a kink but no t_f. So the kink is taken.
class RunawayWatch {
 public:
  using State = RunawayState;
  static constexpr double runaway_ratio = 5.0;
  static constexpr double slowing_ratio = 1.5;

  /// @param growth  of the largest displacement after the kink (m), > 0.
  /// @param at_once  time after the start (s), > 0.
  RunawayWatch(double growth, double at_once);

  /// Takes note of the largest displacement (m, >= 0) at a time (s, ascending). @return whether it has just been found
  /// to have run away
  bool observe(double time, double displacement);
  /// The time of the kink (s); none: the motion has not run away so far.
  [[nodiscard]] std::optional<double> time() const { return state_.time; }
  /// The largest displacement then (m).
  [[nodiscard]] double displacement() const { return state_.displacement; }

  [[nodiscard]] const State& state() const { return state_; }
  void set_state(State state) { state_ = std::move(state); }

 private:
  using Sample = State::Sample;

  void find_kink();
  [[nodiscard]] bool goes_on_after(std::size_t kink) const;
  [[nodiscard]] std::size_t deepest_after(std::size_t start) const;
  [[nodiscard]] double time_of(double displacement, std::size_t from) const;

  double growth_, at_once_;
  State state_;
};

}  // namespace slope::couple
