#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include "case_format.hpp"
#include "frame.hpp"
#include "hyetograph_file.hpp"
#include "initial_values.hpp"
#include "polygon.hpp"
#include "slope/couple/geometry.hpp"
#include "slope/couple/text_file.hpp"
#include "standing_water_share.hpp"
#include "units.hpp"

namespace slope::couple {

namespace {

/// More cells than this are taken for a slip of the unit.
constexpr double most_cells = 4.0e6, most_particles = 4.0e6;
/// Corners of all regions together, and these times the lines of the particle lattice.
constexpr std::size_t most_corners = 50'000;
constexpr double most_cuts = 1.0e9;
/// Of water boundaries, and of loads.
constexpr std::size_t most_conditions = 1000;
/// Between two reservoirs, so that the grid can carry the difference of their pressures.
constexpr double least_gap_cells = 2.0;

std::string text_of(const Point& point) {
  return fmt::format("({}, {})", length_text(point[0]), length_text(point[1]));
}

void check_domain(const Input& place, const Domain& domain) {
  double cells = 1.0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double side = domain.upper[axis] - domain.lower[axis];
    const char* direction = axis == 0 ? "right of" : "above";
    if (side <= 0.0) {
      place.at("upper").problem(
          fmt::format("must be {} lower, got {} and {}", direction, text_of(domain.upper), text_of(domain.lower)));
      return;
    }
    const double along = side / domain.cell_size;
    cells *= along;
    if (std::abs(along - std::round(along)) < 1.0e-6 && along > 0.5) continue;
    const double fitting = domain.lower[axis] + std::max(1.0, std::ceil(along)) * domain.cell_size;
    place.at("upper").problem(fmt::format("the {} of {} is not a whole number of cells of {}; {} = {} would be",
                                          axis == 0 ? "width" : "height", length_text(side),
                                          length_text(domain.cell_size), axis == 0 ? "x" : "y", length_text(fitting)));
  }
  if (cells > most_cells) {
    place.at("cell_size")
        .problem(fmt::format("makes {:.3g} cells, at most {:g} are possible; choose a larger cell", cells, most_cells));
  }
}

void check_region(const Input& place, const Domain& domain, const Region& region) {
  const bool drawn = place.has("polygon");
  const Input outline = place.at(drawn ? "polygon" : "surface");
  const double tolerance = 1.0e-9 * domain.cell_size;
  for (std::size_t i = 0; i < region.polygon.size(); ++i) {
    const Point& corner = region.polygon[i];
    const bool inside = corner[0] >= domain.lower[0] - tolerance && corner[0] <= domain.upper[0] + tolerance &&
                        corner[1] >= domain.lower[1] - tolerance && corner[1] <= domain.upper[1] + tolerance;
    if (inside) continue;
    (drawn ? outline.item(i) : outline)
        .problem(fmt::format("the corner {} is outside of the domain, which goes from {} to {}", text_of(corner),
                             text_of(domain.lower), text_of(domain.upper)));
  }
  if (const auto edges = crossing_edges(region.polygon)) {
    outline.problem(fmt::format("the edges from {} and from {} cross each other; give the corners in order",
                                text_of(region.polygon[edges->first]), text_of(region.polygon[edges->second])));
  } else if (std::abs(signed_area(region.polygon)) < 1.0e-9 * domain.cell_size * domain.cell_size) {
    outline.problem("the polygon encloses no area; its corners lie on one line");
  } else if (const auto corner = drawn ? turning_corner(region.polygon) : std::nullopt) {
    outline.item(*corner).problem(fmt::format("the outline turns back on itself at {}; leave out what has no area",
                                              text_of(region.polygon[*corner])));
  } else if (!holds_lattice_point(domain, region)) {
    outline.problem(
        fmt::format("no particle lies in the polygon; it is too small for cells of {}", length_text(domain.cell_size)));
  }
}

/// Says what is more than a run can hold, before any of it is made.
void check_size(const Input& root, const Case& input) {
  const double per_side = std::sqrt(input.domain.particles_per_cell);
  const auto lines = [&](std::size_t axis) {
    return per_side * (input.domain.upper[axis] - input.domain.lower[axis]) / input.domain.cell_size;
  };
  const double spacing = input.domain.cell_size / per_side;
  double area = 0.0;
  std::size_t corners = 0;
  for (const Region& region : input.regions) {
    area += std::abs(signed_area(region.polygon));
    corners += region.polygon.size();
  }
  const double particles = std::min(area / (spacing * spacing), lines(0) * lines(1));
  const Input geometry = root.at("geometry");
  if (particles > most_particles) {
    root.at("domain")
        .at("cell_size")
        .problem(fmt::format("makes about {:.2g} particles, at most {:g} are possible; choose a larger cell or fewer "
                             "particles_per_cell",
                             particles, most_particles));
  }
  if (corners > most_corners) {
    geometry.problem(fmt::format("has {} corners, at most {} are possible; thin the lines out", corners, most_corners));
  } else if (static_cast<double>(corners) * (lines(0) + lines(1)) > most_cuts) {
    geometry.problem(
        fmt::format("has {} corners, too many for {:.2g} columns and rows of particles; thin the lines "
                    "out, or choose a larger cell",
                    corners, lines(0) + lines(1)));
  }
}

void check_points(const Input& root, const Case& input) {
  const double spacing = input.domain.cell_size / std::sqrt(input.domain.particles_per_cell);
  for (const VerificationPoint& point : input.points) {
    const bool inside = std::any_of(input.regions.begin(), input.regions.end(), [&](const Region& region) {
      return contains(region.polygon, point.position, spacing);
    });
    if (inside) continue;
    root.at("points")
        .at(point.name)
        .problem(fmt::format("the point {} lies outside of the soil; move it into a region of geometry",
                             text_of(point.position)));
  }
}

template <class Condition>
void check_names(const Input& place, const std::vector<Condition>& conditions) {
  if (conditions.size() > most_conditions) {
    place.problem(fmt::format("has {} items, at most {} are possible", conditions.size(), most_conditions));
    return;
  }
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

bool overlap(const PlaceRange& a, const PlaceRange& b) {
  return a.place == b.place && std::max(a.from, b.from) < std::min(a.to, b.to);
}

/// Whether the particles of one condition, given at the start, are those of the free surface on which another one acts.
bool takes_surface_of(const WaterBoundary& fixed, const WaterBoundary& surface) {
  return fixed.where.place == Place::ground_surface && surface.where.place == Place::free_surface &&
         std::max(fixed.where.from, surface.where.from) < std::min(fixed.where.to, surface.where.to);
}

/// A particle whose pressure is held, or on which rain falls or water stands, takes no second such condition of that
/// place. Rain may fall on a reservoir, and fluxes add to each other and to free drainage.
void check_overlaps(const Input& place, const std::vector<WaterBoundary>& boundaries) {
  const auto flux = [](const WaterBoundary& boundary) {
    return std::holds_alternative<PrescribedFlux>(boundary.condition);
  };
  const auto drain = [](const WaterBoundary& boundary) {
    return std::holds_alternative<FreeDrainage>(boundary.condition);
  };
  if (boundaries.size() > most_conditions) return;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const WaterBoundary &a = boundaries[i], &b = boundaries[j];
      if (takes_surface_of(a, b) || takes_surface_of(b, a)) {
        place.item(i).problem(
            fmt::format("overlaps with \"{}\": what is prescribed at the ground_surface takes the place of rain and "
                        "reservoirs on the free_surface; part them by \"from\" and \"to\", or remove one",
                        b.name));
      }
      const bool add_up = (flux(a) && (flux(b) || drain(b))) || (drain(a) && flux(b));
      if (!overlap(a.where, b.where) || add_up) continue;
      const bool surface = a.where.place == Place::free_surface;
      const bool rain = std::holds_alternative<Rain>(a.condition);
      if (surface && rain != std::holds_alternative<Rain>(b.condition)) continue;
      const char* what = drain(a) && drain(b) ? "water can drain"
                         : !surface           ? "a pressure can be held"
                         : rain               ? "rain can fall"
                                              : "water can stand";
      place.item(i).problem(
          fmt::format("overlaps with \"{}\", and {} only once; part them by \"from\" and \"to\"", b.name, what));
    }
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

/// Standing water weighs on the soil up to where its share fades out (see StandingWaterShare): there must be room.
void check_reservoirs(const Input& place, const Case& input) {
  if (input.scheme == Scheme::seepage) return;
  const StandingWaterShare share(input.water_boundaries);
  for (std::size_t i = 0; i < input.water_boundaries.size(); ++i) {
    const auto* reservoir = std::get_if<Reservoir>(&input.water_boundaries[i].condition);
    if (reservoir == nullptr) continue;
    if (share.gap_after(i) < least_gap_cells * input.domain.cell_size) {
      place.item(i).problem(
          fmt::format("ends {} before the next reservoir begins; leave at least {} of ground between them, higher than "
                      "both",
                      length_text(share.gap_after(i)), length_text(least_gap_cells * input.domain.cell_size)));
    }
  }
}

/// Beyond the range of a reservoir the ground must be higher than its level, or its weight would stand in the air.
void check_shores(const Input& place, const Case& input, const InitialParticles& particles, const Frame& frame) {
  if (input.scheme == Scheme::seepage) return;
  const StandingWaterShare share(input.water_boundaries);
  for (std::size_t i = 0; i < input.water_boundaries.size(); ++i) {
    const auto* reservoir = std::get_if<Reservoir>(&input.water_boundaries[i].condition);
    if (reservoir == nullptr || share.gap_after(i) < least_gap_cells * input.domain.cell_size) continue;
    const PlaceRange& where = input.water_boundaries[i].where;
    const double level = reservoir->level.highest();
    for (const Face& face : faces_at({}, input, particles)) {
      const double x = particles.x[face.particle], ground = particles.y[face.particle] + face.outwards;
      if ((x >= where.from && x <= where.to) || ground >= level || share.of(i, x).value == 0.0) continue;
      place.item(i).problem(fmt::format(
          "the ground at x = {}, y = {} lies beyond \"from\" and \"to\", but below the highest level, {}; "
          "widen the range, give that side a reservoir of its own, or move the water alone with \"coupling: {{scheme: "
          "seepage}}\"",
          length_text(frame.position({x, ground})[0]), length_text(frame.height(ground)),
          length_text(frame.height(level))));
      break;
    }
  }
}

/// The last row of a table of rain holds for ever. Gauges write what fell in each of their intervals: a run that goes
/// on after the last of them must be told what comes then.
void check_rain_ends(const Input& place, const Case& input) {
  for (std::size_t i = 0; i < input.water_boundaries.size(); ++i) {
    const auto* rain = std::get_if<Rain>(&input.water_boundaries[i].condition);
    if (rain == nullptr) continue;
    const Input where = place.item(i).at("rain");
    const RainStep& last = rain->hyetograph.back();
    if (!where.has("file") || where.has("after_table") || last.intensity == 0.0) continue;
    const double end = last.time + usual_step(rain->hyetograph);
    if (end < never && input.stop.time <= end * (1.0 + 1.0e-9)) continue;
    where.at("file").problem(
        fmt::format("the last row, {:.4g} mm/h from {:g} h on, would hold until stop.time, {:g} h; end the table with "
                    "a row of 0, or "
                    "say \"after_table: dry\" or \"after_table: last_row\"",
                    last.intensity * 3.6e6, last.time / 3600.0, input.stop.time / 3600.0));
  }
}

void check_steady(const Input& root, const Case& input) {
  const bool steady = std::holds_alternative<SteadyWater>(input.initial_water);
  const Input place = root.at("water_boundaries");
  bool held = false, drained = false, fed = false;
  for (std::size_t i = 0; i < input.water_boundaries.size(); ++i) {
    const WaterBoundary& boundary = input.water_boundaries[i];
    if (boundary.initial) {
      const auto* flux = std::get_if<PrescribedFlux>(&boundary.condition);
      const bool drain = std::holds_alternative<FreeDrainage>(boundary.condition);
      if (flux != nullptr) {
        fed = fed || flux->flux.at(0.0) > 0.0;
      } else {
        (drain ? drained : held) = true;
      }
    }
    if (boundary.initial && !steady && !std::holds_alternative<Reservoir>(boundary.condition)) {
      place.item(i).at("initial").problem("has a meaning only with initial.water of type steady; remove it");
    }
  }
  if (steady && !held && !(drained && fed)) {
    root.at("initial").at("water").problem(
        "steady seepage needs a water boundary with a pressure, total_head, rain or reservoir and \"initial: true\", "
        "or "
        "free_drainage and a flux into the soil");
  }
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

void check_times(const Input& list, const std::vector<double>& times, double end) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] > end)
      list.item(i).problem(fmt::format("{:g} s is after the end of the run, stop.time = {:g} s", times[i], end));
  }
}

constexpr std::size_t most_reference_bytes = 100'000'000;
constexpr const char* reference_column = "suction_head_m_t";

/// More files or rows than this are taken for a slip of the unit.
constexpr double most_snapshots = 1.0e4, most_rows = 1.0e6;

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
  if (const auto edges = crossing_edges(asked.within)) {
    place.at("within").problem(fmt::format("the edges from {} and from {} cross each other; give the corners in order",
                                           text_of(asked.within[edges->first]), text_of(asked.within[edges->second])));
  }
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

/// Height to which water stands in the ground's pores at a place, if one looks into them from above (m); none for
/// steady flow, which finds it.
std::optional<double> water_level_at(const Case& input, const Point& ground) {
  if (const auto* hydrostatic = std::get_if<HydrostaticWater>(&input.initial_water)) return hydrostatic->water_table;
  if (const auto* table = std::get_if<WaterTable>(&input.initial_water)) return table->height_at(ground[0]);
  if (const auto* uniform = std::get_if<UniformWater>(&input.initial_water)) {
    return ground[1] + uniform->pressure / (input.water.density * input.gravity);
  }
  return std::nullopt;
}

/// Whether water stands there up to that level at the start: under a reservoir, or under a pressure or head that is
/// prescribed. A uniform pressure may also meet a prescribed one at which it drains, as in a test of consolidation.
bool is_held(const Case& input, const Point& ground, double level) {
  return std::any_of(input.water_boundaries.begin(), input.water_boundaries.end(), [&](const WaterBoundary& boundary) {
    if (ground[0] < boundary.where.from || ground[0] > boundary.where.to) return false;
    if (const auto* reservoir = std::get_if<Reservoir>(&boundary.condition)) {
      return (boundary.initial || input.scheme == Scheme::seepage) && level <= reservoir->level.at(0.0);
    }
    const auto* held = std::get_if<PrescribedPressure>(&boundary.condition);
    if (held == nullptr || boundary.where.place != Place::ground_surface || boundary.start > 0.0) return false;
    if (std::holds_alternative<UniformWater>(input.initial_water)) return true;
    const double unit_weight = input.water.density * input.gravity;
    return level <= (held->total_head ? held->total_head->at(0.0) : ground[1] + held->pressure.at(0.0) / unit_weight);
  });
}

/// Water above the ground that nothing holds there would fall on the soil as pressure without weight.
void check_water_table(const Input& place, const Case& input, const InitialParticles& particles, const Frame& frame) {
  const double tolerance = particles.spacing;
  for (const Face& face : faces_at({}, input, particles)) {
    const Point ground{particles.x[face.particle], particles.y[face.particle] + face.outwards};
    const auto level = water_level_at(input, ground);
    if (!level || *level <= ground[1] + tolerance || is_held(input, ground, *level - tolerance)) continue;
    const bool uniform = std::holds_alternative<UniformWater>(input.initial_water);
    const bool line = std::holds_alternative<WaterTable>(input.initial_water);
    place.at(uniform ? "pressure"
             : line  ? "points"
                     : "water_table")
        .problem(
            fmt::format("{} {} above the ground at x = {}; add a reservoir of that level with \"initial: true\" to "
                        "water_boundaries, or lower it",
                        uniform ? "is that of water which stands" : "stands", length_text(*level - ground[1]),
                        length_text(frame.position(ground)[0])));
    return;
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

/// Soil that hangs in the air falls at once.
void doubt_hanging_soil(const Input& place, const InitialParticles& particles, const Frame& frame, int columns) {
  constexpr int reach = 2;  // squares; slivers leave gaps of one
  std::map<std::array<int, 2>, std::size_t> waiting;
  for (std::size_t p = 0; p < particles.x.size(); ++p) waiting[{particles.column[p], particles.row[p]}] = p;
  std::vector<std::array<int, 2>> held;
  for (auto entry = waiting.begin(); entry != waiting.end();) {
    const auto [column, row] = entry->first;
    const bool at_wall = column < reach || column >= columns - reach || row < reach;
    if (at_wall) held.push_back(entry->first);
    entry = at_wall ? waiting.erase(entry) : std::next(entry);
  }
  while (!held.empty()) {
    const auto [column, row] = held.back();
    held.pop_back();
    for (int i = -reach; i <= reach; ++i) {
      for (int j = -reach; j <= reach; ++j) {
        const auto found = waiting.find({column + i, row + j});
        if (found == waiting.end()) continue;
        held.push_back(found->first);
        waiting.erase(found);
      }
    }
  }
  if (waiting.empty()) return;
  const std::size_t p = waiting.begin()->second;
  place.warning(fmt::format("the soil around {} touches neither a wall nor what stands on one: it hangs in the air",
                            text_of(frame.position({particles.x[p], particles.y[p]}))));
}

}  // namespace

void check_case(const Input& root, const Case& input) {
  // A key that is misspelt is told as such, and has no value.
  const auto given = [&root](const char* key) { return root.has(key) && root.clean(key); };
  if (given("domain")) check_domain(root.at("domain"), input.domain);
  const Input geometry = root.at("geometry");
  if (given("domain") && given("geometry")) check_size(root, input);
  if (given("domain") && given("geometry")) {
    for (std::size_t i = 0; i < input.regions.size(); ++i)
      check_region(geometry.item(i), input.domain, input.regions[i]);
  }
  const bool soil_is_known = given("domain") && given("geometry") && !input.soils.empty();
  if (soil_is_known && root.clean("points")) check_points(root, input);
  const Input water = root.at("water_boundaries");
  if (root.clean("water_boundaries")) {
    check_names(water, input.water_boundaries);
    check_overlaps(water, input.water_boundaries);
    if (given("initial")) check_steady(root, input);
    if (root.clean("coupling") && root.clean("water_boundaries")) check_reservoirs(water, input);
    if (given("stop")) check_rain_ends(water, input);
  }
  if (root.clean("loads")) check_names(root.at("loads"), input.tractions);
  if (root.clean("coupling") && root.clean("loads") && root.clean("seismic")) check_loads_are_felt(root, input);
  if (soil_is_known) {
    const Frame frame(input);
    const Case placed = frame.place(input);
    const InitialParticles particles = fill_regions(placed.domain, placed.regions);
    if (root.clean("water_boundaries")) {
      check_places(water, placed.water_boundaries, particles);
      if (root.clean("coupling")) check_shores(water, placed, particles, frame);
    }
    if (root.clean("loads")) check_places(root.at("loads"), placed.tractions, particles);
    if (input.scheme != Scheme::seepage) {
      const double columns = std::sqrt(placed.domain.particles_per_cell) *
                             (placed.domain.upper[0] - placed.domain.lower[0]) / placed.domain.cell_size;
      doubt_hanging_soil(geometry, particles, frame, static_cast<int>(std::lround(columns)));
    }
    if (root.clean("water_boundaries") && given("initial") && root.clean("coupling")) {
      check_water_table(root.at("initial").at("water"), placed, particles, frame);
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
