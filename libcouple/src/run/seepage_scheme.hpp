#pragma once

#include <vector>

#include "actions.hpp"
#include "mixture.hpp"
#include "slope/seepage/rigid_step.hpp"

namespace slope::couple {

/// The water alone: the soil stays where it is, and the water flows in implicit steps as long as accuracy and Newton's
/// method allow.
class SeepageScheme {
 public:
  /// The length of the next step, one of equal ones from `time` to `next` (s).
  [[nodiscard]] double pace(double time, double next) const;

  /// How long the next step may be (s): all that the scheme remembers.
  [[nodiscard]] double state() const { return step_; }
  void set_state(double step) { step_ = step; }

  /// One step of clock_factor x time_step. If it does not converge nothing has changed, and pace() gives a shorter one.
  /// @throws SimulationError if there is none left to try
  seepage::SolveReport step(Mixture& mixture, const Actions& actions, double time_step, double clock_factor);

 private:
  double step_ = 1.0;               // the state; where the search begins
  std::vector<double> saturation_;  // at the start of the step
  seepage::RigidStep water_step_;
};

}  // namespace slope::couple
