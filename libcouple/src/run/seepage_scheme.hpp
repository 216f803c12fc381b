#pragma once

#include <vector>

#include "slope/couple/state.hpp"
#include "slope/seepage/rigid_step.hpp"
#include "step.hpp"

namespace slope::couple {

/// The water alone: the soil stays where it is, and the water flows in implicit steps as long as accuracy and Newton's
/// method allow.
class SeepageScheme {
 public:
  using State = WaterPace;
  static constexpr bool moves_soil = false;

  /// One step; if it does not converge nothing has changed, and a shorter one is tried.
  /// @throws SimulationError if there is none left to try
  StepDone step(const StepTask& task);

  /// The latest step (s).
  [[nodiscard]] double time_step() const { return state_.latest_step; }
  [[nodiscard]] const State& state() const { return state_; }
  void set_state(const State& state) { state_ = state; }

 private:
  // The water's changes within a step of that length; afterwards the next one's length is known.
  seepage::SolveReport advance(Mixture& mixture, const Actions& actions, double duration);

  State state_;
  std::vector<double> saturation_;  // at the start of the step
  seepage::RigidStep water_step_;
};

}  // namespace slope::couple
