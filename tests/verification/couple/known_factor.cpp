#include "known_factor.hpp"

#include <stdexcept>

#include "dry_slope.hpp"
#include "run_case.hpp"

namespace slope::testing {

double KnownFactor::found_on(int cells) const {
  std::vector<std::string> all = overrides;
  all.push_back("domain.cell_size=" + std::to_string(4.0 / cells) + " m");
  return found_factor(start_case("slope_factor.yaml", all)) / factor;
}

double found_factor(couple::Simulation simulation) {
  if (!simulation.initialise() || !simulation.find_safety()) throw std::logic_error("nobody stopped the search");
  return simulation.summary().safety.back().factor;
}

KnownFactor frictional_slope() {
  return {{}, factor_of_safety(start_case("slope_factor.yaml"))};
}

KnownFactor dilatant_slope() {
  KnownFactor slope = frictional_slope();
  slope.overrides = {"soils.loam.strength.dilatancy_angle=25 deg"};
  return slope;
}

// Limit analysis with finite elements bounds its factor from both sides, with the
// walls and the base of the case: linear programs over stresses in balance, linear in each triangle and with jumps
// (Sloan 1988, Int. J. Numer. Anal. Methods Geomech. 12, 61-77), and over velocities likewise (Sloan 1989, ibid. 13,
// 263-282), with a yield polygon of 24 sides inside and outside of the circle. The lower bound is 1.048 (936
// triangles), the upper one 1.079 (936) and 1.071 (3,744). The lowest slip circle, 1.101, is above an upper bound, as a
// circle may be.
KnownFactor undrained_slope() {
  constexpr double lower_bound = 1.048, upper_bound = 1.071;
  return {{"soils.loam.strength={model: von_mises, undrained_strength: 15 kPa}"}, 0.5 * (lower_bound + upper_bound)};
}

}  // namespace slope::testing
