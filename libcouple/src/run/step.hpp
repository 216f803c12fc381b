#pragma once

#include "actions.hpp"
#include "boundary_conditions.hpp"
#include "mixture.hpp"
#include "slope/seepage/pore_flow.hpp"

namespace slope::couple {

/// Share of a step by which two times may differ and be the same (-).
inline constexpr double sliver = 1.0e-6;

/// What a step works on, and how far it may go.
struct StepTask {
  Mixture& mixture;
  BoundaryConditions& conditions;
  Actions& actions;    ///< takes what acts in the step
  double time = 0.0;   ///< at its start (s)
  double next = 0.0;   ///< that it must not pass (s)
  double share = 1.0;  ///< of the length that it would have (-)
};

/// What came of it.
struct StepDone {
  double time = 0.0;          ///< at its end (s)
  double duration = 0.0;      ///< of the water's time (s)
  double clock_factor = 1.0;  ///< of the water's time over the soil's own (-)
  seepage::SolveReport report;
};

/// The end of a step (s); the last one up to what is due ends there to the last digit.
[[nodiscard]] inline double end_of_step(const StepTask& task, double duration) {
  return task.time + (1.0 + sliver) * duration > task.next ? task.next : task.time + duration;
}

}  // namespace slope::couple
