#include "water_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "hyetograph_file.hpp"
#include "standing_water_share.hpp"
#include "units.hpp"

namespace slope::couple {

namespace {

/// Between two reservoirs, so that the grid can carry the difference of their pressures.
constexpr double least_gap_cells = 2.0;

bool overlap(const PlaceRange& a, const PlaceRange& b) {
  return a.place == b.place && std::max(a.from, b.from) < std::min(a.to, b.to);
}

/// Whether the particles of one condition, given at the start, are those of the free surface on which another one acts.
bool takes_surface_of(const WaterBoundary& fixed, const WaterBoundary& surface) {
  return fixed.where.place == Place::ground_surface && surface.where.place == Place::free_surface &&
         std::max(fixed.where.from, surface.where.from) < std::min(fixed.where.to, surface.where.to);
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

}  // namespace

void check_overlaps(const Input& place, const std::vector<WaterBoundary>& boundaries) {
  const auto flux = [](const WaterBoundary& boundary) {
    return std::holds_alternative<PrescribedFlux>(boundary.condition);
  };
  const auto drain = [](const WaterBoundary& boundary) {
    return std::holds_alternative<FreeDrainage>(boundary.condition);
  };
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

void doubt_levels(const Input& place, const Case& input, const InitialParticles& particles, const Frame& frame) {
  const double tolerance = particles.spacing;
  for (std::size_t i = 0; i < input.water_boundaries.size(); ++i) {
    const WaterBoundary& boundary = input.water_boundaries[i];
    const auto* reservoir = std::get_if<Reservoir>(&boundary.condition);
    if (reservoir == nullptr || !boundary.initial || input.scheme == Scheme::seepage) continue;
    const double outside = reservoir->level.at(0.0);
    for (const Face& face : faces_at({}, input, particles)) {
      const Point ground{particles.x[face.particle], particles.y[face.particle] + face.outwards};
      if (ground[0] < boundary.where.from || ground[0] > boundary.where.to || ground[1] > outside - tolerance) continue;
      const auto inside = water_level_at(input, ground);
      if (!inside || std::abs(*inside - outside) <= tolerance) continue;
      place.item(i)
          .at("reservoir")
          .warning(
              fmt::format("stands at {} at the start, but the water in the ground under it, at x = {}, at {}; with "
                          "initial.water of type steady it is what belongs to the reservoir",
                          length_text(frame.height(outside)), length_text(frame.position(ground)[0]),
                          length_text(frame.height(*inside))));
      break;
    }
  }
}

}  // namespace slope::couple
