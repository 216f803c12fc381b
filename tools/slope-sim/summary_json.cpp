#include "summary_json.hpp"

#include <fmt/format.h>

#include <optional>

#include "slope/couple/document.hpp"

namespace slope::tools {

namespace {

using couple::Document;

Document number(double value) {
  return Document::number(value);
}
Document number(const std::optional<double>& value) {
  return value ? Document::number(*value) : Document{};
}
Document count(std::size_t value) {
  return Document::number(static_cast<double>(value));
}

Document end_of(const couple::Summary& summary, const RunRecord& record) {
  Document end = Document::map();
  end.set("reason", Document::text(record.end_reason)).set("time_s", number(summary.time));
  if (!record.message.empty()) end.set("message", Document::text(record.message));
  return end;
}

Document onset_of(const couple::Case& input, const couple::Summary& summary) {
  if (!summary.onset_time) return {};
  const bool runaway = input.onset == couple::Onset::runaway;
  Document onset = Document::map();
  onset.set("time_s", number(summary.onset_time))
      .set("criterion",
           Document::text(runaway ? "kink from which on the largest displacement grew by displacement_m at "
                                    "five times the mean rate before, without slowing down"
                                  : "largest displacement above displacement_m"))
      .set("displacement_m", number(summary.onset_criterion))
      .set("position_m", Document::list({number(summary.onset_position[0]), number(summary.onset_position[1])}));
  return onset;
}

Document displacement_times_of(const couple::Summary& summary) {
  Document times = Document::list();
  for (const couple::DisplacementTime& passed : summary.displacement_times) {
    Document entry = Document::map();
    entry.set("displacement_m", number(passed.displacement)).set("time_s", number(passed.time));
    times.children.push_back(std::move(entry));
  }
  return times;
}

Document zone_of(const couple::FailureZone& zone) {
  Document entry = Document::map();
  entry.set("length_m", number(zone.length))
      .set("height_m", number(zone.height))
      .set("depth_m", number(zone.depth))
      .set("area_m2", number(zone.area))
      .set("lowest_m", number(zone.lowest))
      .set("highest_m", number(zone.highest))
      .set("largest_suction_Pa", number(zone.largest_suction));
  return entry;
}

Document zones_of(const couple::Case& input, const couple::Summary& summary) {
  Document zones = Document::map();
  zones.set("criterion", Document::text("deviatoric strain above deviatoric_strain"))
      .set("deviatoric_strain", number(input.failure_zone_strain))
      .set("at_onset", summary.zone_at_onset ? zone_of(*summary.zone_at_onset) : Document{})
      .set("at_10_cm", summary.zone_at_10_cm ? zone_of(*summary.zone_at_10_cm) : Document{})
      .set("at_end", zone_of(summary.zone_at_end));
  return zones;
}

Document slide_of(const couple::Slide& slide) {
  Document entry = Document::map();
  entry.set("area_m2", number(slide.area))
      .set("direction", number(slide.direction))
      .set("run_out_m", number(slide.run_out))
      .set("first_toe_m", slide.toe ? Document::list({number((*slide.toe)[0]), number((*slide.toe)[1])}) : Document{})
      .set("largest_horizontal_displacement_m", number(slide.largest_horizontal_displacement))
      .set("reaches_wall", Document::flag(slide.reaches_wall));
  return entry;
}

Document slides_of(const couple::Summary& summary) {
  Document slides = Document::map();
  slides.set("criterion", Document::text("displacement above displacement_m"))
      .set("displacement_m", number(summary.onset_criterion))
      .set("at_10_cm", summary.slide_at_10_cm ? slide_of(*summary.slide_at_10_cm) : Document{})
      .set("at_end", slide_of(summary.slide_at_end));
  return slides;
}

Document verdict_of(couple::Verdict verdict) {
  switch (verdict) {
    case couple::Verdict::stands:
      return Document::text("stands");
    case couple::Verdict::moves:
      return Document::text("moves without failing");
    case couple::Verdict::fails:
      return Document::text("fails");
    case couple::Verdict::does_not_stand:
      return Document::text("does not stand before the start");
    case couple::Verdict::water_alone:
      return Document::text("water alone");
    case couple::Verdict::undecided:
      break;
  }
  return Document::text("undecided");
}

Document water_of(const couple::WaterBudget& water) {
  Document boundaries = Document::map();
  for (const auto& [name, inflow] : water.by_boundary) boundaries.set(name, number(inflow));
  Document budget = Document::map();
  budget.set("infiltration_m3_per_m", number(water.infiltration))
      .set("outflow_m3_per_m", number(water.outflow))
      .set("storage_m3_per_m", number(water.storage))
      .set("error", number(water.error))
      .set("rain_m3_per_m", number(water.rain))
      .set("rain_infiltration_m3_per_m", number(water.rain_infiltration))
      .set("run_off_m3_per_m", number(water.run_off))
      .set("seepage_m3_per_m", number(water.seepage))
      .set("evaporation_m3_per_m", number(water.evaporation))
      .set("net_inflow_by_boundary_m3_per_m", std::move(boundaries));
  return budget;
}

}  // namespace

std::string summary_json(const couple::Case& input, const couple::Summary& summary, const RunRecord& record) {
  Document root = Document::map();
  root.set("verdict", verdict_of(summary.verdict))
      .set("program", Document::text("slope-sim"))
      .set("version", Document::text(record.version))
      .set("title", Document::text(input.title))
      .set("case", Document::text(input.path))
      .set("end", end_of(summary, record))
      .set("onset", onset_of(input, summary))
      .set("onset_criterion_m", number(summary.onset_criterion))
      .set("onset_by_displacement_s", number(summary.displacement_onset))
      .set("onset_by_runaway_s", number(summary.runaway_onset))
      .set("largest_displacement_m", number(summary.largest_displacement))
      .set("displacement_times", displacement_times_of(summary))
      .set("failure_zone", zones_of(input, summary))
      .set("slide", slides_of(summary))
      .set("water_budget", water_of(summary.water))
      .set("pressure_checkerboard", number(summary.pressure_checkerboard))
      .set("initial_head_flux", number(summary.initial_head_flux))
      .set("initial_unbalanced_ratio", number(summary.initial_unbalanced_ratio))
      .set("largest_unbalanced_ratio", number(summary.largest_unbalanced_ratio))
      .set("unbalanced_limit", number(summary.unbalanced_limit))
      .set("particles", count(summary.particles))
      .set("steps", count(summary.steps))
      .set("mean_pressure_iterations", number(summary.mean_pressure_iterations))
      .set("unsettled_pressure_steps", number(static_cast<double>(summary.unsettled_steps)))
      .set("threads", number(record.threads))
      .set("wall_time_s", number(record.wall_time));
  return json_text(root);
}

}  // namespace slope::tools
