#include <fmt/format.h>
#include <fmt/ranges.h>

#include "case_format.hpp"

namespace slope::couple {

namespace {

constexpr auto itself = [](auto& value) -> auto& {
  return value;
};

/// A water boundary as it stands in the file: one of three conditions.
struct WaterBoundaryText {
  WaterBoundary common;  ///< all but the condition
  std::optional<double> pressure, total_head, flux;
  std::optional<bool> at_face;
};

/// The fields that say where a condition holds.
template <class Condition>
void add_place(Record<Condition>& record, auto where) {
  const auto place = choice<Place>({{"ground_surface", Place::ground_surface},
                                    {"base", Place::base},
                                    {"left", Place::left},
                                    {"right", Place::right}});
  const auto part_of = [where](auto member) {
    return [ where, member ](auto& condition) -> auto& {
      return where(condition).*member;
    };
  };
  record
      .required("at", part_of(&PlaceRange::place), place,
                "the uppermost or lowest particle of each column, or the outermost of each row", "ground_surface")
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

void from_text(const Input& input, const WaterBoundaryText& text, WaterBoundary& boundary) {
  boundary = text.common;
  const int given = text.pressure.has_value() + text.total_head.has_value() + text.flux.has_value();
  if (given != 1) {
    input.problem(
        fmt::format("needs one of pressure, total_head and flux, got {}; write for example \"pressure: 0 kPa\"",
                    given == 0 ? "none" : std::to_string(given)));
    return;
  }
  if (text.flux) {
    boundary.condition = PrescribedFlux{*text.flux};
    if (text.at_face) input.at("applied_to").problem("a flux always enters through the face; remove this key");
    return;
  }
  boundary.condition = PrescribedPressure{text.pressure.value_or(0.0), text.total_head, text.at_face.value_or(false)};
}

WaterBoundaryText to_text(const WaterBoundary& boundary) {
  WaterBoundaryText text{boundary, {}, {}, {}, {}};
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

/// The branches of a schema of which exactly one holds: one of the conditions is there.
Document exactly_one_condition() {
  std::vector<Document> branches;
  for (const char* key : water_conditions) {
    Document branch = Document::map();
    branch.set("required", Document::list({Document::text(key)}));
    branches.push_back(std::move(branch));
  }
  return Document::list(std::move(branches));
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
          input.at("points").item(i).problem(fmt::format("x must be above that of the point before, {:g} m, got {:g} m",
                                                         table.points[i - 1][0], table.points[i][0]));
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
  add_place(
      record, [](auto& text) -> auto& { return text.common.where; });
  record
      .optional("pressure", &WaterBoundaryText::pressure, maybe(quantity(Dimension::pressure)),
                "prescribed pore-water pressure, positive in compression")
      .optional("total_head", &WaterBoundaryText::total_head, maybe(quantity(Dimension::length)),
                "prescribed total head, pressure head plus y")
      .optional("flux", &WaterBoundaryText::flux, maybe(quantity(Dimension::velocity)),
                "prescribed flux per area of the surface, positive into the soil")
      .optional(
          "applied_to", &WaterBoundaryText::at_face, maybe(choice<bool>({{"particle", false}, {"face", true}})),
          "where a pressure or head holds: in the particle (default) or at the face half a spacing outside of it");
  add_times(record, common);
  record.optional(
      "initial", [](auto& text) -> auto& { return text.common.initial; }, flag(),
      "holds in the steady seepage before the start too");
  Format<WaterBoundary> format = converted<WaterBoundaryText, WaterBoundary>(record.format(), from_text, to_text);
  format.schema.set("oneOf", exactly_one_condition());
  return format;
}

Format<Traction> traction_format() {
  Record<Traction> record;
  record.required("name", &Traction::name, name_text(), "by which messages and --set call it", "fill");
  add_place(
      record, [](auto& load) -> auto& { return load.where; });
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
      .optional("horizontal_coefficient", &Seismic::horizontal_coefficient, quantity(Dimension::number),
                "k_h, horizontal body force on soil and water over their weight, positive towards +x")
      .optional("vertical_coefficient", &Seismic::vertical_coefficient, quantity(Dimension::number),
                "k_v, vertical body force over the weight, positive upwards");
  add_times(record, itself);
  return record.format();
}

}  // namespace slope::couple
