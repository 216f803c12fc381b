#include "report.hpp"

#include <fmt/format.h>

#include "time_unit.hpp"

namespace slope::tools {

namespace {

std::string end_text(const couple::Case& input, const RunRecord& record) {
  if (record.end_reason == "time") return "the time asked for";
  if (record.end_reason == "displacement") return fmt::format("displacement above {:g} m", input.stop.displacement);
  if (record.end_reason == "after_onset") return fmt::format("{:g} s after the onset", input.stop.after_onset);
  return record.end_reason;
}

/// In seconds, and in its own unit if that is another.
std::string seconds_text(double seconds) {
  const std::string text = fmt::format("{:.5g} s", seconds);
  return time_unit(seconds).seconds == 1.0 ? text : fmt::format("{} ({})", text, time_text(seconds));
}

std::string zone_text(const couple::FailureZone& zone) {
  if (zone.area <= 0.0) return "none";
  return fmt::format("{:.1f} m long, {:.1f} m high, {:.1f} m deep, {:.1f} m2, run-out {:.2f} m", zone.length,
                     zone.height, zone.depth, zone.area, zone.run_out);
}

}  // namespace

std::string onset_text(const couple::Summary& summary) {
  const double centimetres = 100.0 * summary.onset_criterion;
  if (!summary.onset_time) return fmt::format("none (the largest displacement stayed below {:g} cm)", centimetres);
  return fmt::format("{} (largest displacement above {:g} cm), at x = {:.1f} m, y = {:.1f} m",
                     seconds_text(*summary.onset_time), centimetres, summary.onset_position[0],
                     summary.onset_position[1]);
}

std::string report_text(const couple::Case& input, const couple::Summary& summary, const RunRecord& record) {
  const couple::WaterBudget& water = summary.water;
  std::string text = fmt::format("{}\n", input.title);
  const auto line = [&text](std::string_view name, const std::string& content) {
    text += fmt::format("  {:<15}  {}\n", name, content);
  };
  line("end", fmt::format("{} ({})", seconds_text(summary.time), end_text(input, record)));
  line("onset", onset_text(summary));
  line("displacement", fmt::format("{:.3g} m at the end, where it is largest", summary.largest_displacement));
  const std::string threshold = fmt::format("deviatoric strain above {:g} %", 100.0 * input.failure_zone_strain);
  if (summary.zone_at_10_cm)
    line("zone at 10 cm", fmt::format("{} ({})", zone_text(*summary.zone_at_10_cm), threshold));
  line("zone at the end", fmt::format("{} ({})", zone_text(summary.zone_at_end), threshold));
  line("suction left", fmt::format("{:.1f} kPa at most", summary.zone_at_end.largest_suction / 1000.0));
  line("water", fmt::format("{:.4g} m3/m in, {:.4g} m3/m out, {:.4g} m3/m stored, error {:.1e}", water.infiltration,
                            water.outflow, water.storage, water.error));
  if (water.rain > 0.0) {
    line("rain", fmt::format("{:.4g} m3/m: {:.4g} m3/m infiltrated, {:.4g} m3/m ran off", water.rain,
                             water.rain_infiltration, water.run_off));
  }
  if (water.seepage + water.evaporation > 0.0) {
    line("to the air", fmt::format("{:.4g} m3/m seeped out, {:.4g} m3/m evaporated", water.seepage, water.evaporation));
  }
  line("cost", fmt::format("{} particles, {} steps, {:.1f} s on {} thread{}", summary.particles, summary.steps,
                           record.wall_time, record.threads, record.threads == 1 ? "" : "s"));
  if (summary.unsettled_steps > 0) {
    line("unsettled",
         fmt::format("{} steps whose pore pressures kept changing to the last iteration; what that left of the "
                     "water went to the steps after them",
                     summary.unsettled_steps));
  }
  return text;
}

}  // namespace slope::tools
