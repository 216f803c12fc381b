#include "a_summary.hpp"

#include <limits>

namespace slope::couple::test {

RunSummary a_summary() {
  Case input;
  input.title = "A \"strange\" title:\n\\ {\x1b";
  input.path = "cases/x.yaml";
  input.failure_zone_strain = 0.02;
  Summary found;
  found.end_reason = EndReason::displacement;
  found.verdict = Verdict::fails;
  found.time = 890.5;
  found.onset_criterion = 0.02;
  found.onset_time = found.displacement_onset = 618.25;
  found.runaway_onset = 590.5;
  found.onset_position = {11.5, 5.75};
  found.displacement_times = {{0.02, 618.25}, {1.0, {}}};
  found.zone_at_onset = FailureZone{1, 2, 3, 4, 5, 6, 8000};
  found.zone_at_end = FailureZone{15, 7.75, 2.25, 27, 5, 12.75, 38000};
  found.slide_at_end = {31.5, -1.0, 0.28, Point{10, 5}, 0.25, false};
  found.water = {1.5, 0.25, 1.25, 1.5e-9, 1e-9, {{"rain", 1.5}, {"outlet", -0.25}}, 2.5, 1.5, 1.0, 0.125, 0.0625};
  found.safety = {{0.0, 1.9, 1.875, 1.925, 9, 87.5, 5.5}, {600.0, 20.0, 20.0, std::nullopt, 7, 0.0, 0.0}};
  found.largest_displacement = 0.3;
  found.pressure_checkerboard = std::numeric_limits<double>::quiet_NaN();
  found.largest_unbalanced_ratio = 1.0 / 3.0;
  found.unbalanced_limit = 1e-320;
  found.particles = 5089;
  found.steps = 46312;
  found.unsettled_steps = 3;
  RunSummary run = run_summary(input, found);
  run.wall_time = 61.5;
  run.threads = 2;
  return run;
}

}  // namespace slope::couple::test
