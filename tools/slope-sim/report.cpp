#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "slope/couple/water_amounts.hpp"
#include "time_unit.hpp"

namespace slope::tools {

namespace {

std::string end_text(const couple::Case& input, const couple::Summary& summary) {
  const bool moves = input.stop.at_rest && summary.onset_time;
  const std::string note = moves ? "; the slide had not come to rest" : "";
  switch (summary.end_reason) {
    case couple::EndReason::time:
      return "the time asked for" + note;
    case couple::EndReason::displacement:
      return fmt::format("displacement above {:g} m{}", input.stop.displacement, note);
    case couple::EndReason::after_onset:
      return fmt::format("{:g} s after the onset{}", input.stop.after_onset, note);
    case couple::EndReason::at_rest:
      return "the slide has come to rest";
    case couple::EndReason::running:
    case couple::EndReason::interrupted:
    case couple::EndReason::error:
      break;
  }
  return std::string(couple::text_of(summary.end_reason));
}

/// In seconds, and in its own unit if that is another.
std::string seconds_text(double seconds) {
  const std::string text = fmt::format("{:.5g} s", seconds);
  return time_unit(seconds).seconds == 1.0 ? text : fmt::format("{} ({})", text, time_text(seconds));
}

std::string zone_text(const couple::FailureZone& zone) {
  if (zone.area <= 0.0) return "none";
  return fmt::format("{:.1f} m long, {:.1f} m high, {:.1f} m deep, {:.1f} m2", zone.length, zone.height, zone.depth,
                     zone.area);
}

/// What may bring the slope down: "in the rain", or nothing if there is no water boundary.
std::string under_what(const couple::Case& input) {
  return input.water_boundaries.empty() ? "" : " in the rain";
}

std::string run_out_text(const couple::Slide& slide) {
  if (!slide.run_out) {
    return fmt::format("no toe to count it from: the ground falls to the {} side",
                       slide.direction > 0.0 ? "right" : "left");
  }
  if (!slide.toe) return "0 m";
  return fmt::format("{:.2f} m beyond the first toe, x = {:.4f} m, y = {:.4f} m, to the {}{}", *slide.run_out,
                     (*slide.toe)[0], (*slide.toe)[1], slide.direction > 0.0 ? "right" : "left",
                     slide.reaches_wall ? "; it has come to the side of the domain" : "");
}

std::string runaway_text(const couple::Summary& summary) {
  if (!summary.runaway_onset) return "the motion has not run away";
  return fmt::format("the motion runs away from {} on", seconds_text(*summary.runaway_onset));
}

}  // namespace

std::string verdict_text(const couple::Case& input, const couple::Summary& summary) {
  switch (summary.verdict) {
    case couple::Verdict::stands:
      return fmt::format("stands until the end, {}", seconds_text(summary.time));
    case couple::Verdict::moves:
      return fmt::format(
          "moves without failing, by {:.2g} cm until {}: the motion has not run away, and nothing has sheared by {:g} "
          "%",
          100.0 * summary.largest_displacement, seconds_text(summary.time), 100.0 * input.failure_zone_strain);
    case couple::Verdict::fails:
      return fmt::format("fails{}, after {}", under_what(input), seconds_text(*summary.onset_time));
    case couple::Verdict::does_not_stand:
      return fmt::format("does not stand before {}: no balance was found, {:.2g} % of the weight stays unbalanced",
                         input.water_boundaries.empty() ? "the start" : "the rain",
                         100.0 * summary.initial_unbalanced_ratio);
    case couple::Verdict::water_alone:
      return "none: the water moves alone, the soil is not asked";
    case couple::Verdict::undecided:
      break;
  }
  return fmt::format("undecided: it stands until {}, where the run was ended", seconds_text(summary.time));
}

std::string onset_text(const couple::Case& input, const couple::Summary& summary) {
  const double centimetres = 100.0 * summary.onset_criterion;
  const bool runaway = input.onset == couple::Onset::runaway;
  if (!summary.onset_time) {
    return runaway ? "none (the motion has not run away)"
                   : fmt::format("none (the largest displacement stayed below {:g} cm)", centimetres);
  }
  return fmt::format(
      "{} ({}), at x = {:.1f} m, y = {:.1f} m", seconds_text(*summary.onset_time),
      runaway ? std::string("the motion runs away") : fmt::format("largest displacement above {:g} cm", centimetres),
      summary.onset_position[0], summary.onset_position[1]);
}

namespace {

/// What moved, and how far.
void add_motion(const couple::Case& input, const couple::Summary& summary, const auto& line) {
  line("onset", onset_text(input, summary));
  line("runaway", runaway_text(summary));
  line("displacement", fmt::format("{:.3g} m at the end, where it is largest; horizontally {:.3g} m",
                                   summary.largest_displacement, summary.slide_at_end.largest_horizontal_displacement));
  line("run-out", run_out_text(summary.slide_at_end));
  line("slid", fmt::format("{:.1f} m2 (displacement above {:g} cm)", summary.slide_at_end.area,
                           100.0 * summary.onset_criterion));
  const std::string threshold = fmt::format("deviatoric strain above {:g} %", 100.0 * input.failure_zone_strain);
  if (summary.zone_at_10_cm)
    line("zone at 10 cm", fmt::format("{} ({})", zone_text(*summary.zone_at_10_cm), threshold));
  line("zone at the end", fmt::format("{} ({})", zone_text(summary.zone_at_end), threshold));
}

/// "1.5 m3/m in"
std::string amount_text(const couple::WaterBudget& water, const couple::WaterAmount& amount) {
  return fmt::format("{:.4g} {} {}", water.*amount.value, amount.unit, amount.phrase);
}

/// The water's books: what came in and out, and the rain and what the air took if there were any.
void add_water(const couple::WaterBudget& water, const auto& line) {
  namespace amounts = couple::water_amounts;
  const auto text = [&water](const couple::WaterAmount& amount) { return amount_text(water, amount); };
  line("water",
       fmt::format("{}, {}, {}, {} {:.1e}", text(amounts::infiltration), text(amounts::outflow), text(amounts::storage),
                   amounts::relative_balance_error.phrase, water.relative_balance_error));
  if (water.rain > 0.0) {
    line("rain",
         fmt::format("{}: {}, {}", text(amounts::rain), text(amounts::rain_infiltration), text(amounts::run_off)));
  }
  if (water.seepage + water.evaporation > 0.0) {
    line("to the air", fmt::format("{}, {}", text(amounts::seepage), text(amounts::evaporation)));
  }
}

std::string least_safety_text(const std::vector<couple::FactorOfSafety>& safety) {
  const auto least = std::ranges::min_element(safety, {}, &couple::FactorOfSafety::factor);
  return fmt::format("{:.3f} at {}", least->factor, time_text(least->time));
}

}  // namespace

std::string safety_text(const couple::FactorOfSafety& safety) {
  const std::string at = time_text(safety.time);
  if (!safety.upper) return fmt::format("above {:.3g} at {}: it stood with all that was tried", safety.lower, at);
  if (safety.lower == 0.0)
    return fmt::format("below {:.3g} at {}: it flowed with all that was tried", *safety.upper, at);
  return fmt::format("{:.3f} at {} ({:.4f} to {:.4f}, {} trials); what flows is {:.3g} m2, {:.2g} m deep",
                     safety.factor, at, safety.lower, *safety.upper, safety.trials, safety.area, safety.depth);
}

std::string safety_report_text(const couple::Case& input, const couple::RunSummary& run) {
  std::string text = fmt::format("{}\n", input.title);
  for (const couple::FactorOfSafety& safety : run.found.safety) {
    text += fmt::format("  factor of safety {}\n", safety_text(safety));
  }
  if (run.found.safety.empty()) return text + "  no factor of safety: the run ended before the first time asked for\n";
  if (run.found.safety.size() > 1) text += fmt::format("  least            {}\n", least_safety_text(run.found.safety));
  return text;
}

std::string report_text(const couple::Case& input, const couple::RunSummary& run) {
  const couple::Summary& summary = run.found;
  std::string text = fmt::format("{}\n", input.title);
  const auto line = [&text](std::string_view name, const std::string& content) {
    text += fmt::format("  {:<15}  {}\n", name, content);
  };
  line("verdict", verdict_text(input, summary));
  line("end", fmt::format("{} ({})", seconds_text(summary.time), end_text(input, summary)));
  if (summary.verdict != couple::Verdict::water_alone) add_motion(input, summary, line);
  if (!summary.safety.empty()) {
    line("safety",
         fmt::format("factor {}; least {}", safety_text(summary.safety.back()), least_safety_text(summary.safety)));
  }
  line("suction left", fmt::format("{:.1f} kPa at most", summary.zone_at_end.largest_suction / 1000.0));
  add_water(summary.water, line);
  if (summary.largest_unbalanced_ratio > 0.0) {
    line("clock",
         fmt::format("ahead of the soil with at most {:.2g} of the weight unbalanced (limit {:g} at the start, {:.2g} "
                     "at the end)",
                     summary.largest_unbalanced_ratio, input.clock.unbalanced_limit, summary.unbalanced_limit));
  }
  line("cost", fmt::format("{} particles, {} steps, {:.1f} s on {} thread{}", summary.particles, summary.steps,
                           run.wall_time, run.threads, run.threads == 1 ? "" : "s"));
  if (summary.unsettled_steps > 0) {
    line("unsettled",
         fmt::format("{} steps whose pore pressures kept changing to the last iteration; what that left of the "
                     "water went to the steps after them",
                     summary.unsettled_steps));
  }
  return text;
}

}  // namespace slope::tools
