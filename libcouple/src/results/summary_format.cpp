#include "results/summary_format.hpp"

#include <algorithm>

#include "slope/couple/water_amounts.hpp"

namespace slope::couple {

namespace {

constexpr auto whole = [](auto& run) -> auto& {
  return run;
};

/// A part of what was found of the slope.
template <class V>
auto found(V Summary::*member) {
  return [member](auto& run) -> auto& {
    return run.found.*member;
  };
}

/// A value that stands elsewhere too, so that it is known without this key.
template <class V>
ResultFormat<V> repeated(ResultFormat<V> format) {
  format.forget = [](V&) {};
  return format;
}

std::string key_of(const WaterAmount& amount) {
  std::string key(amount.name);
  std::ranges::replace_if(
      key, [](char letter) { return letter == ' ' || letter == '-'; }, '_');
  return key;
}

ResultFormat<RunSummary> end_format() {
  return ResultRecord<RunSummary>()
      .key("reason", found(&Summary::end_reason), word_of(end_reasons), "why the run ended")
      .key("time", found(&Summary::time), measured("s"), "simulated until then, >= 0")
      .key("message", &RunSummary::message, words(), "of the error or the interruption")
      .left_out_if([](const RunSummary& run) { return run.message.empty(); })
      .format();
}

ResultFormat<RunSummary> onset_format() {
  ResultRecord<RunSummary> record;
  record.key("time", found(&Summary::onset_time), maybe(measured("s")), "since the start, >= 0")
      .key("criterion", &RunSummary::onset_criterion, word_of(onset_criteria),
           "by which it is, failure.onset of the case")
      .key("displacement", found(&Summary::onset_criterion), repeated(measured("m")),
           "that counts as failure, failure.onset_displacement of the case")
      .key("position", found(&Summary::onset_position), place(),
           "where the soil had moved most when the onset was found, y upwards");
  return only_if<RunSummary>([](const RunSummary& run) { return run.found.onset_time.has_value(); }, record, "time_s");
}

ResultFormat<DisplacementTime> displacement_time_format() {
  return ResultRecord<DisplacementTime>()
      .key("displacement", &DisplacementTime::displacement, measured("m"), "that the largest displacement passed")
      .key("time", &DisplacementTime::time, maybe(measured("s")), "when it did, since the start; null: it did not")
      .format();
}

ResultFormat<FailureZone> zone_format() {
  return ResultRecord<FailureZone>()
      .key("length", &FailureZone::length, measured("m"), "horizontal extent, >= 0")
      .key("height", &FailureZone::height, measured("m"), "vertical extent, >= 0")
      .key("depth", &FailureZone::depth, measured("m"),
           "largest depth, normal to the ground surface at the start, >= 0")
      .key("area", &FailureZone::area, measured("m2"), "volume per metre of thickness, >= 0")
      .key("lowest", &FailureZone::lowest, measured("m"), "y of its lowest point, upwards")
      .key("highest", &FailureZone::highest, measured("m"), "y of its highest point, upwards")
      .key("largest_suction", &FailureZone::largest_suction, measured("Pa"),
           "left anywhere in the slope, positive above the water level")
      .format();
}

ResultFormat<RunSummary> zones_format() {
  return ResultRecord<RunSummary>()
      .constant("criterion", "deviatoric strain above deviatoric_strain", "what soil is of the zone")
      .key("deviatoric_strain", &RunSummary::zone_strain, measured("-"),
           "failure.zone_deviatoric_strain of the case, > 0")
      .key("at_onset", found(&Summary::zone_at_onset), maybe(zone_format()),
           "when the onset was found; null: there was none")
      .key("at_10_cm", found(&Summary::zone_at_10_cm), maybe(zone_format()),
           "when the largest displacement passed 10 cm; null: it did not")
      .key("at_end", found(&Summary::zone_at_end), zone_format(), "at the end of the run")
      .format();
}

ResultFormat<Slide> slide_format() {
  return ResultRecord<Slide>()
      .key("area", &Slide::area, measured("m2"), "volume per metre of thickness of what slid, >= 0")
      .key("direction", &Slide::direction, measured("-"), "+1 to the right, -1 to the left, 0: nothing slid")
      .key("run_out", &Slide::run_out, maybe(measured("m")),
           "advance of the ground line beyond its first toe, >= 0; null: it has no toe")
      .key("first_toe", &Slide::toe, maybe(place()),
           "lowest point of the face that it stood on, y upwards; null: nothing slid, or the ground falls to the side")
      .key("largest_horizontal_displacement", &Slide::largest_horizontal_displacement, measured("m"),
           "of any particle, >= 0")
      .key("reaches_wall", &Slide::reaches_wall, yes_or_no(),
           "whether the front has come to the last cell before the side of the domain")
      .format();
}

ResultFormat<RunSummary> slides_format() {
  return ResultRecord<RunSummary>()
      .constant("criterion", "displacement above displacement_m", "what soil slid")
      .key("displacement", found(&Summary::onset_criterion), repeated(measured("m")),
           "failure.onset_displacement of the case, > 0")
      .key("at_10_cm", found(&Summary::slide_at_10_cm), maybe(slide_format()),
           "when the largest displacement passed 10 cm; null: it did not")
      .key("at_end", found(&Summary::slide_at_end), slide_format(), "at the end of the run")
      .format();
}

ResultFormat<WaterBudget> water_format() {
  ResultRecord<WaterBudget> record;
  const auto add = [&record](const WaterAmount& amount) -> auto& {
    return record.key(key_of(amount), amount.value, measured(amount.unit), std::string(amount.meaning));
  };
  for (const WaterAmount& amount : water_amounts::all) add(amount);
  add(water_amounts::relative_balance_error).once("error");
  record.key("net_inflow_by_boundary", &WaterBudget::by_boundary, by_name("m3/m"),
             "through each of the case's water boundaries, drains too, by their names; negative: out of the soil");
  return record.format();
}

ResultFormat<FactorOfSafety> safety_format() {
  return ResultRecord<FactorOfSafety>()
      .key("time", &FactorOfSafety::time, measured("s"), "since the start")
      .key("factor", &FactorOfSafety::factor, measured("-"), "of safety, the middle of its bracket, > 0")
      .key("lower", &FactorOfSafety::lower, measured("-"),
           "with the strength divided by this the slope stands; 0: it did with none that was tried")
      .key("upper", &FactorOfSafety::upper, maybe(measured("-")),
           "with the strength divided by this it flows; null: it stood with all that were tried")
      .key("trials", &FactorOfSafety::trials, count(), "number of them")
      .key("area", &FactorOfSafety::area, measured("m2"), "of the soil that moves then, per metre of thickness, >= 0")
      .key("depth", &FactorOfSafety::depth, measured("m"), "its largest, normal to the ground at the start, >= 0")
      .format();
}

void add_quality(ResultRecord<RunSummary>& record) {
  record
      .key("pressure_checkerboard", found(&Summary::pressure_checkerboard), measured("-"),
           "what alternates in the pore pressure from particle to particle, over its range: largest of the run, >= 0")
      .key("initial_head_flux", found(&Summary::initial_head_flux), measured("-"),
           "largest Darcy flux of the head operator before the start, over the conductivity, >= 0")
      .key("initial_unbalanced_ratio", found(&Summary::initial_unbalanced_ratio), measured("-"),
           "unbalanced forces that the initial state left, over the weight, >= 0")
      .key("largest_unbalanced_ratio", found(&Summary::largest_unbalanced_ratio), measured("-"),
           "unbalanced forces over the weight while the water's time ran ahead, largest of the run, >= 0")
      .key("unbalanced_limit", found(&Summary::unbalanced_limit), measured("-"),
           "what of it the clock allowed at the end, > 0")
      .key("particles", found(&Summary::particles), count(), "number of them")
      .key("steps", found(&Summary::steps), count(), "number of them")
      .key("mean_pressure_iterations", found(&Summary::mean_pressure_iterations), measured("-"), "per step, >= 0")
      .key("unsettled_pressure_steps", found(&Summary::unsettled_steps), count(),
           "number of steps whose pressures were taken as they were after the last iteration allowed")
      .key("threads", &RunSummary::threads, count(), "on which the program ran")
      .key("wall_time", &RunSummary::wall_time, measured("s"), "that the run took, >= 0");
}

}  // namespace

ResultFormat<RunSummary> summary_format() {
  ResultRecord<RunSummary> record;
  record.key("verdict", found(&Summary::verdict), word_of(verdicts), "what the run says of the slope")
      .constant("program", summary_program, "that wrote this")
      .key("version", &RunSummary::version, words(), "of the program")
      .key("title", &RunSummary::title, words(), "of the case")
      .key("case", &RunSummary::case_file, words(), "path of the case file")
      .key("end", whole, end_format(), "of the run")
      .key("onset", whole, onset_format(), "of failure, by the criterion of the case; null: there was none")
      .key("onset_criterion", found(&Summary::onset_criterion), measured("m"),
           "displacement that counts as failure, failure.onset_displacement of the case, > 0")
      .key("onset_by_displacement", found(&Summary::displacement_onset), maybe(measured("s")),
           "when the largest displacement passed onset_criterion_m, since the start; null: it did not")
      .key("onset_by_runaway", found(&Summary::runaway_onset), maybe(measured("s")),
           "from when on the motion ran away, since the start; null: it did not")
      .key("largest_displacement", found(&Summary::largest_displacement), measured("m"), "at the end, >= 0")
      .key("displacement_times", found(&Summary::displacement_times), list_of(displacement_time_format()),
           "when the largest displacement passed some values")
      .key("failure_zone", whole, zones_format(), "the soil that sheared")
      .key("slide", whole, slides_format(), "the soil that slid")
      .key("water_budget", found(&Summary::water), water_format(), "cumulative since the start, per metre of thickness")
      .key("factor_of_safety", found(&Summary::safety), list_of(safety_format()),
           "by strength reduction, at the times that the case asks for");
  add_quality(record);
  return record.format();
}

}  // namespace slope::couple
