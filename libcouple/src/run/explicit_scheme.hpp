#pragma once

#include <vector>

#include "actions.hpp"
#include "mixture.hpp"
#include "slope/seepage/explicit_step.hpp"

namespace slope::couple {

/// The paper's own cycle (section 2.6) with its two-pass operator (Eqs. 18, 19): everything explicit, each particle's
/// own pressure on the grid, one time step short enough for the compression wave in saturated soil with stiff water.
class ExplicitScheme {
 public:
  /// Courant number x the shorter of: cell size over the undrained P-wave's speed; and, in the soil's time, what the
  /// explicit flow bears (s).
  [[nodiscard]] static double stable_step(const Mixture& mixture, double courant_number);
  /// Largest clock factor for which the flow is stable at that step (-), >= 1.
  [[nodiscard]] static double largest_clock_factor(const Mixture& mixture, double courant_number);

  /// One step; see SemiImplicitScheme::step().
  seepage::SolveReport step(Mixture& mixture, const Actions& actions, double time_step, double clock_factor);

 private:
  std::vector<double> vx_, vy_;  // of the skeleton in the water's time (m/s)
  seepage::ExplicitStep water_step_;
};

}  // namespace slope::couple
