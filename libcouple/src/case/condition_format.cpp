#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "case_format.hpp"
#include "hyetograph_file.hpp"
#include "units.hpp"

namespace slope::couple {

namespace {

constexpr auto itself = [](auto& value) -> auto& {
  return value;
};

/// A water boundary as it stands in the file: one of the conditions.
struct WaterBoundaryText {
  WaterBoundary common;  ///< all but the condition
  std::optional<TimeSeries> pressure, total_head, flux;
  std::optional<bool> free_drainage;
  std::optional<Rain> rain;
  std::optional<Reservoir> reservoir;
  std::optional<bool> at_face;
};

/// Rain as it stands in the file: one intensity, steps, or a file of steps.
struct RainText {
  Rain common;  ///< all but the hyetograph
  std::optional<double> intensity;
  std::vector<RainStep> hyetograph;
  std::string file;
  std::optional<bool> dry_after_table;
};

using Places = std::vector<std::pair<std::string, Place>>;

Places particle_places() {
  return {
      {"ground_surface", Place::ground_surface}, {"base", Place::base}, {"left", Place::left}, {"right", Place::right}};
}

/// The fields that say where a condition holds.
template <class Condition>
void add_place(Record<Condition>& record, auto where, Places places, const std::string& description) {
  const auto place = choice<Place>(std::move(places));
  const auto part_of = [where](auto member) {
    return [ where, member ](auto& condition) -> auto& {
      return where(condition).*member;
    };
  };
  record.required("at", part_of(&PlaceRange::place), place, description, "ground_surface")
      .optional("from", part_of(&PlaceRange::from), quantity(Dimension::length),
                "only particles from this x on (left, right: from this y on)")
      .optional("to", part_of(&PlaceRange::to), quantity(Dimension::length),
                "only particles up to this x (left, right: y)");
}

template <class Condition>
void add_times(Record<Condition>& record, auto of) {
  record
      .optional(
          "start", [of](auto& condition) -> auto& { return of(condition).start; },
          quantity(Dimension::time, at_least(0.0)), "when it begins")
      .optional(
          "ramp", [of](auto& condition) -> auto& { return of(condition).ramp; },
          quantity(Dimension::time, at_least(0.0)),
          "how long it takes to go from what is there to the prescribed value");
}

/// [time, value]
template <class Step>
Format<Step> step_format(double Step::*member, Dimension dimension, const std::string& example) {
  const Format<double> time = quantity(Dimension::time, at_least(0.0));
  const Format<double> value = quantity(dimension);
  Document either = Document::map();
  either.set("anyOf", Document::list({time.schema, value.schema}));
  Document schema = Document::map();
  schema.set("type", Document::text("array"))
      .set("items", std::move(either))
      .set("minItems", Document::number(2))
      .set("maxItems", Document::number(2));
  const auto read = [=](const Input& input, Step& step) {
    if (!expect_list(input, 2)) return;
    if (input.node().children.size() > 2) {
      input.problem(fmt::format("expected {}", example));
      return;
    }
    time.read(input.item(0), step.time);
    value.read(input.item(1), step.*member);
  };
  const auto write = [=](const Step& step) {
    return Document::list({time.write(step.time), value.write(step.*member)});
  };
  return {read, write, std::move(schema)};
}

Format<RainStep> rain_step_format() {
  return step_format(&RainStep::intensity, Dimension::velocity, "[time, intensity], such as [2 h, 40 mm/h]");
}

/// Reports the steps that are not after the one before.
template <class Step>
void check_times(const Input& input, const std::vector<Step>& steps) {
  for (std::size_t i = 1; i < steps.size(); ++i) {
    if (steps[i].time > steps[i - 1].time) continue;
    input.item(i).problem("times must grow from step to step");
  }
}

/// One value, or points [time, value]; of these an example: "[time, level], such as [10 h, 5 m]".
Format<TimeSeries> time_series(Dimension dimension, const std::string& example) {
  const Format<double> constant = quantity(dimension);
  const auto points = list_of(step_format(&TimedValue::value, dimension, example), 1);
  Document schema = Document::map();
  schema.set("anyOf", Document::list({constant.schema, points.schema}));
  const auto read = [=](const Input& input, TimeSeries& series) {
    if (input.node().kind != Document::Kind::list) {
      series.points.assign(1, {});
      constant.read(input, series.points.front().value);
      return;
    }
    points.read(input, series.points);
    check_times(input, series.points);
  };
  const auto write = [=](const TimeSeries& series) {
    return series.points.size() == 1 ? constant.write(series.points.front().value) : points.write(series.points);
  };
  return {read, write, std::move(schema)};
}

/// A flag of which only "true" makes sense.
Format<bool> truth() {
  Format<bool> format = flag();
  format.schema = Document::map();
  format.schema.set("const", Document::flag(true));
  return format;
}

Format<Reservoir> reservoir_format() {
  Record<Reservoir> record;
  record.required("level", &Reservoir::level, time_series(Dimension::length, "[time, level], such as [10 h, 5 m]"),
                  "y of the water's surface: one level, or points [time, level] with straight lines between them, "
                  "constant before the first and after the last",
                  "[[0 h, 9 m], [10 h, 5 m]]");
  return record.format();
}

void read_table(const Input& input, const RainText& text, Rain& rain) {
  const auto path = std::filesystem::path(input.file()).parent_path() / text.file;
  const auto read = [&]() -> std::variant<RainTable, std::string> {
    try {
      return read_hyetograph(path);
    } catch (const FileError& error) {
      return error.what();
    }
  }();
  if (const auto* wrong = std::get_if<std::string>(&read)) {
    input.at("file").problem(*wrong);
    return;
  }
  const auto& table = std::get<RainTable>(read);
  for (const RainTable::Note& note : table.warnings)
    input.at("file").warning_in(path.string(), note.line, note.message);
  rain.hyetograph = table.steps;
  if (!text.dry_after_table || !*text.dry_after_table) return;
  if (table.steps.size() < 2) {
    input.at("after_table").problem("a table of one row does not say how long that lasts; add a row of 0 at its end");
    return;
  }
  rain.hyetograph.push_back({table.steps.back().time + usual_step(table.steps), 0.0});
}

void from_text(const Input& input, const RainText& text, Rain& rain) {
  rain = text.common;
  const int given = text.intensity.has_value() + !text.hyetograph.empty() + !text.file.empty();
  if (given != 1) {
    input.problem(fmt::format("needs one of {}, got {}; write for example \"intensity: 20 mm/h\"",
                              fmt::join(rain_conditions, ", "), given == 0 ? "none" : std::to_string(given)));
    return;
  }
  if (text.dry_after_table && text.file.empty()) {
    input.at("after_table").problem("has a meaning only with a file; remove it");
  }
  rain.hyetograph = text.hyetograph;
  if (text.intensity) rain.hyetograph = {{0.0, *text.intensity}};
  check_times(input.at("hyetograph"), text.hyetograph);
  for (std::size_t i = 0; i < rain.hyetograph.size(); ++i) {
    const auto doubt = doubt_about(rain.hyetograph[i].intensity);
    if (doubt) (text.intensity ? input.at("intensity") : input.at("hyetograph").item(i)).warning(*doubt);
  }
  if (!text.file.empty()) read_table(input, text, rain);
}

RainText to_text(const Rain& rain) {
  RainText text{rain, {}, {}, {}, {}};
  const bool constant = rain.hyetograph.size() == 1 && rain.hyetograph.front().time == 0.0;
  if (constant) {
    text.intensity = rain.hyetograph.front().intensity;
  } else {
    text.hyetograph = rain.hyetograph;
  }
  return text;
}

/// The branches of a schema of which exactly one holds: one of the keys is there.
Document exactly_one_of(const auto& keys) {
  std::vector<Document> branches;
  for (const char* key : keys) {
    Document branch = Document::map();
    branch.set("required", Document::list({Document::text(key)}));
    branches.push_back(std::move(branch));
  }
  return Document::list(std::move(branches));
}

Format<Rain> rain_format() {
  const auto common = [](auto member) {
    return [member](auto& text) -> auto& {
      return text.common.*member;
    };
  };
  Record<RainText> record;
  record
      .optional(
          "intensity", &RainText::intensity, maybe(quantity(Dimension::velocity)),
          "rain per horizontal metre, the same all the time; negative: what the air could evaporate; 0: water may "
          "leave, nothing more")
      .optional("hyetograph", &RainText::hyetograph, list_of(rain_step_format(), 1),
                "steps [time, intensity], each from its time on; before the first there is none")
      .optional("file", &RainText::file, path_text(),
                "CSV file of such steps, path from the file it stands in, with a header that names the units, such as "
                "time_h,intensity_mm_per_h")
      .optional("after_table", &RainText::dry_after_table, maybe(choice<bool>({{"dry", true}, {"last_row", false}})),
                "what comes after the last row of the file, which lasts as long as most others, if it is not 0 and the "
                "run goes on: dry, or last_row: the same for ever")
      .optional("ponding_depth", common(&Rain::ponding_depth), quantity(Dimension::length, at_least(0.0)),
                "of the water that stays on the ground while rain runs off")
      .optional("evaporation_limit", common(&Rain::evaporation_limit), quantity(Dimension::pressure, above(0.0)),
                "suction to which negative rain dries the surface at most")
      .optional("before_start", common(&Rain::before_start), maybe(quantity(Dimension::velocity)),
                "intensity in the steady seepage before the start, with \"initial: true\"; without it the first one");
  Format<Rain> format = converted<RainText, Rain>(
      record.format(), [](const Input& input, const RainText& text, Rain& rain) { from_text(input, text, rain); },
      [](const Rain& rain) { return to_text(rain); });
  format.schema.set("oneOf", exactly_one_of(rain_conditions));
  return format;
}

void from_text(const Input& input, const WaterBoundaryText& text, WaterBoundary& boundary) {
  boundary = text.common;
  const int given = text.pressure.has_value() + text.total_head.has_value() + text.flux.has_value() +
                    text.free_drainage.has_value() + text.rain.has_value() + text.reservoir.has_value();
  if (given != 1) {
    input.problem(fmt::format("needs one of {}, got {}; write for example \"pressure: 0 kPa\"",
                              fmt::join(water_conditions, ", "), given == 0 ? "none" : std::to_string(given)));
    return;
  }
  if (text.free_drainage) {
    boundary.condition = FreeDrainage{};
    const auto refuse = [&](const char* key) {
      input.at(key).problem("free drainage knows only a beginning; remove this key");
    };
    if (!*text.free_drainage) input.at("free_drainage").problem("must be true; without it remove this boundary");
    if (boundary.where.place != Place::base) input.at("at").problem("drains at the base only; write \"at: base\"");
    if (text.at_face) refuse("applied_to");
    if (boundary.ramp > 0.0) refuse("ramp");
    return;
  }
  const bool on_surface = text.rain || text.reservoir;
  if ((boundary.where.place == Place::free_surface) != on_surface) {
    input.at("at").problem(text.rain        ? "rain falls on the free surface; write \"at: free_surface\""
                           : text.reservoir ? "a reservoir stands on the free surface; write \"at: free_surface\""
                                            : "the free surface takes rain or a reservoir; write \"at: "
                                              "ground_surface\"");
    return;
  }
  if (text.rain) {
    boundary.condition = *text.rain;
    if (text.at_face) input.at("applied_to").problem("rain always enters through the face; remove this key");
    return;
  }
  if (text.reservoir) {
    boundary.condition = *text.reservoir;
    const auto refuse = [&](const char* key) {
      input.at(key).problem("a reservoir has its level and no more; remove this key");
    };
    if (text.at_face) refuse("applied_to");
    if (boundary.start > 0.0) refuse("start");
    if (boundary.ramp > 0.0) refuse("ramp");
    return;
  }
  if (text.flux) {
    boundary.condition = PrescribedFlux{*text.flux};
    if (text.at_face) input.at("applied_to").problem("a flux always enters through the face; remove this key");
    return;
  }
  boundary.condition =
      PrescribedPressure{text.pressure.value_or(TimeSeries{}), text.total_head, text.at_face.value_or(true)};
}

WaterBoundaryText to_text(const WaterBoundary& boundary) {
  WaterBoundaryText text{boundary, {}, {}, {}, {}, {}, {}, {}};
  if (const auto* rain = std::get_if<Rain>(&boundary.condition)) {
    text.rain = *rain;
    return text;
  }
  if (const auto* reservoir = std::get_if<Reservoir>(&boundary.condition)) {
    text.reservoir = *reservoir;
    return text;
  }
  if (std::holds_alternative<FreeDrainage>(boundary.condition)) {
    text.free_drainage = true;
    return text;
  }
  if (const auto* flux = std::get_if<PrescribedFlux>(&boundary.condition)) {
    text.flux = flux->flux;
    return text;
  }
  const auto& held = std::get<PrescribedPressure>(boundary.condition);
  text.at_face = held.at_face;
  text.total_head = held.total_head;
  if (!held.total_head) text.pressure = held.pressure;
  return text;
}

}  // namespace

Format<InitialWater> initial_water_format() {
  const Format<double> height = quantity(Dimension::length);
  const Format<double> cap = quantity(Dimension::pressure, at_least(0.0));
  const std::string cap_meaning = "suction that is not exceeded above the water table; without it there is no limit";
  Record<HydrostaticWater> hydrostatic;
  hydrostatic.required("water_table", &HydrostaticWater::water_table, height, "y of the water table", "3 m")
      .optional("maximum_suction", &HydrostaticWater::maximum_suction, cap, cap_meaning);
  Record<WaterTable> water_table;
  water_table
      .required("points", &WaterTable::points, list_of(pair_of(Dimension::length), 2),
                "the water table from left to right, level beyond its ends", "[[0 m, 3 m], [36 m, 6 m]]")
      .optional("maximum_suction", &WaterTable::maximum_suction, cap, cap_meaning)
      .check([](const Input& input, WaterTable& table) {
        for (std::size_t i = 1; i < table.points.size(); ++i) {
          if (table.points[i][0] > table.points[i - 1][0]) continue;
          input.at("points").item(i).problem(fmt::format("x must be above that of the point before, {}, got {}",
                                                         length_text(table.points[i - 1][0]),
                                                         length_text(table.points[i][0])));
        }
      });
  Record<UniformWater> uniform;
  uniform.required("pressure", &UniformWater::pressure, quantity(Dimension::pressure),
                   "pore-water pressure, positive in compression", "0 kPa");
  Record<SteadyWater> steady;
  steady.required("water_table", &SteadyWater::water_table, height, "y of the water table in the first guess", "3 m");
  return Alternatives<InitialWater>("type")
      .add("hydrostatic", "at rest under a level water table, with suction above it", itself, hydrostatic)
      .add("water_table",
           "hydrostatic below and above a water table given as a line; an inclined one begins to flow at the start",
           itself, water_table)
      .add("uniform", "the same pressure everywhere", itself, uniform)
      .add("steady", "steady seepage under the water boundaries with \"initial: true\"", itself, steady)
      .format();
}

Format<WaterBoundary> water_boundary_format() {
  const auto common = [](auto& text) -> auto& {
    return text.common;
  };
  Record<WaterBoundaryText> record;
  record.required(
      "name", [](auto& text) -> auto& { return text.common.name; }, name_text(),
      "by which the summary and --set call it", "rain");
  Places places = particle_places();
  places.emplace_back("free_surface", Place::free_surface);
  add_place(
      record, [](auto& text) -> auto& { return text.common.where; }, std::move(places),
      "the uppermost or lowest particle of each column, or the outermost of each row; free_surface, for rain "
      "and reservoirs: where soil meets air or water, found anew as it moves");
  record
      .optional(
          "pressure", &WaterBoundaryText::pressure,
          maybe(time_series(Dimension::pressure, "[time, pressure], such as [10 h, -5 kPa]")),
          "prescribed pore-water pressure, positive in compression, one or points [time, pressure]; zero at the ground "
          "is the upper bound of any rain that does not pond")
      .optional("total_head", &WaterBoundaryText::total_head,
                maybe(time_series(Dimension::length, "[time, head], such as [10 h, 5 m]")),
                "prescribed total head, pressure head plus y, one or points [time, head]")
      .optional("flux", &WaterBoundaryText::flux,
                maybe(time_series(Dimension::velocity, "[time, flux], such as [10 h, 5 mm/h]")),
                "prescribed flux per area of the surface, positive into the soil, one or points [time, flux]")
      .optional(
          "free_drainage", &WaterBoundaryText::free_drainage, maybe(truth()),
          "true: at the base, water leaves by its own weight, with the conductivity that the soil has there, as if "
          "the soil went on below and the water table were far down")
      .optional("rain", &WaterBoundaryText::rain, maybe(rain_format()),
                "rain or evaporation on the free surface, which water may leave but never enters by suction")
      .optional("reservoir", &WaterBoundaryText::reservoir, maybe(reservoir_format()),
                "water that stands on the free surface with its pressure and its weight; above its level the surface "
                "takes the rain that another boundary has there, or lets water out")
      .optional("applied_to", &WaterBoundaryText::at_face, maybe(choice<bool>({{"particle", false}, {"face", true}})),
                "where a pressure or head holds: at the face (default), which is the ground as it is drawn, or in the "
                "particle, half "
                "a spacing inside");
  add_times(record, common);
  record.optional(
      "initial", [](auto& text) -> auto& { return text.common.initial; }, flag(),
      "holds in the steady seepage before the start too, with what it is at the start; of a reservoir also the weight, "
      "in "
      "the initial stress");
  Format<WaterBoundary> format = converted<WaterBoundaryText, WaterBoundary>(
      record.format(),
      [](const Input& input, const WaterBoundaryText& text, WaterBoundary& boundary) {
        from_text(input, text, boundary);
      },
      [](const WaterBoundary& boundary) { return to_text(boundary); });
  format.schema.set("oneOf", exactly_one_of(water_conditions));
  return format;
}

Format<Traction> traction_format() {
  Record<Traction> record;
  record.required("name", &Traction::name, name_text(), "by which messages and --set call it", "fill");
  add_place(
      record, [](auto& load) -> auto& { return load.where; }, particle_places(),
      "the uppermost or lowest particle of each column, or the outermost of each row");
  record.required(
      "traction", &Traction::traction, pair_of(Dimension::pressure),
      "x and y components of the force per horizontal metre on ground_surface and base, whatever their "
      "inclination, and per vertical metre on left and right; a surcharge of 10 kPa is [0 kPa, -10 kPa]; it "
      "stays on its particles as they move",
      "[0 kPa, -10 kPa]");
  add_times(record, itself);
  return record.format();
}

Format<Seismic> seismic_format() {
  Record<Seismic> record;
  record
      .optional(
          "horizontal_coefficient", &Seismic::horizontal_coefficient, quantity(Dimension::number),
          "k_h, horizontal body force on soil and water over their weight, positive towards +x; without start and "
          "ramp it is in the initial stress")
      .optional("vertical_coefficient", &Seismic::vertical_coefficient, quantity(Dimension::number),
                "k_v, vertical body force over the weight, positive upwards");
  add_times(record, itself);
  return record.format();
}

}  // namespace slope::couple
