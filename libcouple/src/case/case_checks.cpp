#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "case_format.hpp"
#include "contrast_checks.hpp"
#include "frame.hpp"
#include "ground_checks.hpp"
#include "initial_values.hpp"
#include "slope/couple/geometry.hpp"
#include "slope/couple/text_file.hpp"
#include "units.hpp"
#include "water_checks.hpp"

namespace slope::couple {

namespace {

/// Of water boundaries, and of loads.
constexpr std::size_t most_conditions = 1000;
/// More files or rows than this are taken for a slip of the unit.
constexpr double most_snapshots = 1.0e4, most_rows = 1.0e6;
constexpr std::size_t most_reference_bytes = 100'000'000;
constexpr const char* reference_column = "suction_head_m_t";

/// @return whether there are few enough to be compared with each other
template <class Condition>
bool check_number(const Input& place, const std::vector<Condition>& conditions) {
  if (conditions.size() <= most_conditions) return true;
  place.problem(fmt::format("has {} items, at most {} are possible", conditions.size(), most_conditions));
  return false;
}

template <class Condition>
void check_names(const Input& place, const std::vector<Condition>& conditions) {
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (conditions[i].name != conditions[j].name) continue;
      place.item(i).at("name").problem(
          fmt::format("\"{}\" is the name of an earlier one; choose another", conditions[i].name));
      break;
    }
  }
}

template <class Condition>
void check_places(const Input& place, const std::vector<Condition>& conditions, const InitialParticles& particles) {
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (!particles_at(conditions[i].where, particles).empty()) continue;
    place.item(i).problem("no particle lies there; check \"at\", \"from\" and \"to\"");
  }
}

/// The water alone moves no soil, whatever acts on it.
void check_loads_are_felt(const Input& root, const Case& input) {
  if (input.scheme != Scheme::seepage) return;
  const auto refuse = [&root](const char* key) {
    root.at(key).problem(
        "has no effect with \"coupling: {scheme: seepage}\", which moves the water alone; remove it, or choose the "
        "scheme semi_implicit");
  };
  if (!input.tractions.empty()) refuse("loads");
  if (input.seismic.horizontal_coefficient != 0.0 || input.seismic.vertical_coefficient != 0.0) refuse("seismic");
}

void check_k0(const Input& root, const Case& input) {
  const Input place = root.at("initial");
  if (input.initial_stress != InitialStress::k0) {
    if (input.k0_coefficient)
      place.at("k0_coefficient").problem("has a meaning only with \"stress: k0\"; remove one or add the other");
    return;
  }
  if (input.k0_coefficient) return;
  for (const Soil& soil : input.soils) {
    if (friction_angle_of(soil.solid.strength)) continue;
    place.problem_with(
        "k0_coefficient",
        fmt::format("missing; the soil \"{}\" has no friction angle for Jaky's formula; write for example "
                    "\"k0_coefficient: 0.5\"",
                    soil.name));
  }
}

/// A mineral is seldom lighter than water or heavier than lead ore.
void doubt_grains(const Input& soils, const Case& input) {
  constexpr double lightest = 1000.0, heaviest = 8000.0;
  for (const Soil& soil : input.soils) {
    const double density = soil.solid.grain_density;
    if (density >= lightest && density <= heaviest) continue;
    soils.at(soil.name)
        .at("grain_density")
        .warning(fmt::format("{} is {}; is the unit right?", quantity_text(density, Dimension::density),
                             density < lightest ? "lighter than water" : "heavier than any mineral of a soil"));
  }
}

void check_times(const Input& list, const std::vector<double>& times, double end) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] > end)
      list.item(i).problem(fmt::format("{:g} s is after the end of the run, stop.time = {:g} s", times[i], end));
  }
}

void check_output(const Input& place, const Case& input) {
  if (static_cast<double>(input.output.snapshots.size()) > most_snapshots) {
    place.at("snapshots")
        .problem(fmt::format("makes {} particle files, at most {:g} are possible", input.output.snapshots.size(),
                             most_snapshots));
  }
  const auto check = [&](const char* key, double interval, double most, const char* what) {
    if (input.stop.time / interval <= most) return;
    place.at(key).problem(
        fmt::format("makes {:.3g} {} until stop.time = {:g} s, at most {:g} are possible; choose {:g} s "
                    "or more",
                    input.stop.time / interval, what, input.stop.time, most, input.stop.time / most));
  };
  check("snapshot_interval", input.output.snapshot_interval, most_snapshots, "particle files");
  check("history_interval", input.output.history_interval, most_rows, "rows");
}

/// What is asked of the factor of safety must be there.
void check_safety(const Input& place, const Case& input) {
  const SafetyQuestions& asked = input.safety;
  check_times(place.at("times"), asked.times, input.stop.time);
  if (input.stop.time / asked.interval > most_snapshots) {
    place.at("interval")
        .problem(fmt::format("asks {:.3g} times until stop.time = {:g} s, at most {:g} are possible; choose {:g} s or "
                             "more",
                             input.stop.time / asked.interval, input.stop.time, most_snapshots,
                             input.stop.time / most_snapshots));
  }
  check_simple(place.at("within"), asked.within);
  if (asked.times.empty() && asked.interval == never) return;
  for (const Soil& soil : input.soils) {
    if (!std::holds_alternative<solid::ModifiedCamClay>(soil.solid.strength)) continue;
    place.problem(
        fmt::format("strength reduction is not defined for modified_cam_clay, the strength of soil \"{}\"; give it "
                    "another strength, or ask for no factor of safety",
                    soil.name));
  }
  const auto yields = [](const Soil& soil) { return !std::holds_alternative<solid::NoYield>(soil.solid.strength); };
  if (std::ranges::none_of(input.soils, yields)) {
    place.problem("no soil has a strength that could be reduced: all are elastic");
  }
}

void check_reference(const Input& root, const Case& input) {
  if (input.figures.profile_reference.empty()) return;
  const auto path = std::filesystem::path(input.path).parent_path() / input.figures.profile_reference;
  std::error_code error;
  const Input place = root.at("figures").at("profile_reference");
  if (!std::filesystem::exists(path, error)) {
    place.problem(fmt::format("there is no file {}", path.string()));
    return;
  }
  try {
    const std::string content = read_text_file(path, most_reference_bytes);
    if (content.find("z_m") != std::string::npos && content.find(reference_column) != std::string::npos) return;
    place.problem(fmt::format("{} is no table with the columns z_m and {}<time>", path.string(), reference_column));
  } catch (const FileError& wrong) {
    place.problem(wrong.what());
  }
}

}  // namespace

void check_case(const Input& root, const Case& input) {
  // A key that is misspelt is told as such, and has no value.
  const auto given = [&root](const char* key) { return root.has(key) && root.clean(key); };
  if (given("domain")) check_domain(root.at("domain"), input.domain);
  const Input geometry = root.at("geometry");
  if (given("domain") && given("geometry")) {
    check_size(root, input);
    for (std::size_t i = 0; i < input.regions.size(); ++i)
      check_region(geometry.item(i), input.domain, input.regions[i]);
  }
  const bool soil_is_known = given("domain") && given("geometry") && !input.soils.empty();
  if (soil_is_known && root.clean("points")) check_points(root, input);
  const Input water = root.at("water_boundaries");
  if (root.clean("water_boundaries")) {
    if (check_number(water, input.water_boundaries)) {
      check_names(water, input.water_boundaries);
      check_overlaps(water, input.water_boundaries);
    }
    if (given("initial")) check_steady(root, input);
    // again: of those that overlap no more is told
    if (root.clean("coupling") && root.clean("water_boundaries")) check_reservoirs(water, input);
    if (given("stop")) check_rain_ends(water, input);
  }
  const Input loads = root.at("loads");
  if (root.clean("loads") && check_number(loads, input.tractions)) check_names(loads, input.tractions);
  if (root.clean("coupling") && root.clean("loads") && root.clean("seismic")) check_loads_are_felt(root, input);
  if (soil_is_known) {
    const Frame frame(input);
    const Case placed = frame.place(input);
    const InitialParticles particles = fill_regions(placed.domain, placed.regions);
    if (root.clean("water_boundaries")) {
      check_places(water, placed.water_boundaries, particles);
      if (root.clean("coupling")) check_shores(water, placed, particles, frame);
    }
    if (root.clean("loads")) check_places(loads, placed.tractions, particles);
    if (input.scheme != Scheme::seepage) {
      const double columns = std::sqrt(placed.domain.particles_per_cell) *
                             (placed.domain.upper[0] - placed.domain.lower[0]) / placed.domain.cell_size;
      doubt_hanging_soil(geometry, particles, frame, static_cast<int>(std::lround(columns)));
      if (given("soils")) doubt_contrast(geometry, placed, particles, frame);
    }
    if (root.clean("water_boundaries") && given("initial") && root.clean("coupling")) {
      check_water_table(root.at("initial").at("water"), placed, particles, frame);
      doubt_levels(water, placed, particles, frame);
    }
  }
  if (given("initial") && given("soils")) check_k0(root, input);
  if (given("soils")) doubt_grains(root.at("soils"), input);
  if (given("stop") && root.clean("output") && root.clean("figures")) {
    check_output(root.at("output"), input);
    check_times(root.at("output").at("snapshots"), input.output.snapshots, input.stop.time);
    check_times(root.at("figures").at("profile_times"), input.figures.profile_times, input.stop.time);
    check_times(root.at("figures").at("contour_times"), input.figures.contour_times, input.stop.time);
  }
  if (given("stop") && given("soils") && root.has("safety") && root.clean("safety")) {
    check_safety(root.at("safety"), input);
  }
  if (root.clean("figures")) check_reference(root, input);
}

}  // namespace slope::couple
