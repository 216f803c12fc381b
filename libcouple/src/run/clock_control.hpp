#pragma once

#include <span>
#include <vector>

#include "slope/couple/case.hpp"
#include "slope/couple/state.hpp"

namespace slope::couple {

/// What the clock measures motion and pressure against.
struct SlopeScale {
  double height = 0.0;      ///< of the soil (m)
  double wave_speed = 0.0;  ///< drained P-wave (m/s)
  double overburden = 0.0;  ///< rho g H (Pa)
  double gravity = 0.0;     ///< (m/s2)

  [[nodiscard]] double period() const { return 4.0 * height / wave_speed; }  ///< first period of a layer (s)
};

/// Chooses the clock factor Theta: how much faster than the soil's own time the water's time runs. Theta is the same as
/// scaling the soil's mass by Theta^2 in physical time. Water that runs ahead of the soil leaves forces out of balance:
/// the factor grows while these are small against the weight, and falls to one, real time, when they are not. What is
/// small is a matter of what the water does: once pore pressures have changed by more than a hundredth of the
/// overburden in the mean, the limit grows with their change.
class ClockControl {
 public:
  using State = ClockState;

  ClockControl(const Clock& limits, const SlopeScale& scale, std::vector<double> change_times);

  /// What the soil's time step and the factor are, and by how much the soil's velocities must be scaled before the
  /// step.
  struct Pace {
    double time_step = 0.0;  ///< (s)
    double factor = 1.0;     ///< >= 1
    double velocity_scale = 1.0;
  };
  /// For a step that starts at `time` and must not pass `next` (s): the steps up to `next` are equal, and none of the
  /// soil's is longer than `time_step` (s). At real time the soil's step is shortened to fit, not the factor: soil that
  /// lagged behind its water would be too heavy. Velocities belong
  /// to the soil's own time; where the factor falls they fall with it, so that what creeps does not gain speed in
  /// physical time.
  /// @param prescribed_rate  how fast a prescribed pressure changes now (Pa/s): the factor is at most the one with
  /// which that is as calm as a pressure change may be that lets the factor grow.
  Pace pace(double time, double next, double time_step, double prescribed_rate = 0.0);
  /// Takes note of a step done; twenty times in the first period the factor is judged anew.
  /// @param unbalanced_ratio  unbalanced forces over the weight (-) in it
  /// @param first_pressure  pore pressure of the particles at the start of the run (Pa)
  /// @param pressure        after the step (Pa)
  void observe(double time_step, double unbalanced_ratio, std::span<const double> first_pressure,
               std::span<const double> pressure);
  /// The unbalanced ratio that is allowed now (-).
  [[nodiscard]] double unbalanced_limit() const;
  /// The largest unbalanced ratio that a judgement found while the water ran ahead of the soil (-).
  [[nodiscard]] double largest_unbalanced_ratio() const { return state_.largest_unbalanced_ratio; }
  [[nodiscard]] const State& state() const { return state_; }
  void set_state(State state) { state_ = std::move(state); }

 private:
  void begin_block(std::span<const double> pressure);

  Clock limits_;
  SlopeScale scale_;
  std::vector<double> change_times_;
  State state_;
};

}  // namespace slope::couple
