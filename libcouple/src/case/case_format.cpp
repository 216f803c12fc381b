#include "case_format.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "profile.hpp"
#include "units.hpp"

namespace slope::couple {

namespace {

constexpr auto whole = [](auto& value) -> auto& {
  return value;
};

/// A region as it stands in the file: with the name of its soil.
struct RegionText {
  std::string soil;
  std::vector<Point> polygon;
  std::optional<ProfileText> surface;
  std::optional<double> base;
};

Format<Domain> domain_format() {
  return Record<Domain>()
      .required("lower", &Domain::lower, pair_of(Dimension::length), "lower left corner", "[0 m, 0 m]")
      .required("upper", &Domain::upper, pair_of(Dimension::length), "upper right corner, a whole number of cells away",
                "[36 m, 14 m]")
      .required("cell_size", &Domain::cell_size, quantity(Dimension::length, above(0.0)),
                "side of the square grid cells", "0.5 m")
      .required("particles_per_cell", &Domain::particles_per_cell,
                choice<int>({{"1", 1}, {"4", 4}, {"9", 9}, {"16", 16}}), "in a square lattice", "4")
      .optional(
          "surface_particles", &Domain::surface_particles,
          choice<SurfaceParticles>({{"lattice", SurfaceParticles::lattice}, {"clipped", SurfaceParticles::clipped}}),
          "clipped: volumes and centroids of what the polygons cut out of the lattice, exact in area; lattice: whole "
          "particles whose centre lies in a polygon, inclined surfaces are stair-steps")
      .format();
}

void check_walls(const Input& input, Walls& walls) {
  const auto check = [&input](const char* key, bool given, bool needed, const char* kind, const char* example) {
    if (given && !needed) {
      input.at(key).problem(fmt::format("has a meaning only for a wall of the kind {}; remove it", kind));
    } else if (needed && !given) {
      input.problem_with(key, fmt::format("missing; write for example \"{}: {}\"", key, example));
    }
  };
  const auto one_is = [&walls](Wall wall) { return walls.left == wall || walls.right == wall || walls.base == wall; };
  check("left_friction", walls.left_friction.has_value(), walls.left == Wall::friction, "friction", "0.4");
  check("right_friction", walls.right_friction.has_value(), walls.right == Wall::friction, "friction", "0.4");
  check("base_friction", walls.base_friction.has_value(), walls.base == Wall::friction, "friction", "0.4");
  check("absorbing_depth", walls.absorbing_depth.has_value(), one_is(Wall::absorbing), "absorbing", "20 m");
}

Format<Walls> walls_format() {
  const auto wall = choice<Wall>({{"free", Wall::free},
                                  {"roller", Wall::roller},
                                  {"fixed", Wall::fixed},
                                  {"friction", Wall::friction},
                                  {"absorbing", Wall::absorbing}});
  const auto coefficient = maybe(quantity(Dimension::number, at_least(0.0)));
  return Record<Walls>()
      .required("left", &Walls::left, wall,
                "free: none, roller: no motion across it, fixed: no motion at all, friction: no motion into it, and "
                "along it only against friction, absorbing: waves pass it, loads at rest are borne",
                "roller")
      .required("right", &Walls::right, wall, "as the left wall", "roller")
      .required("base", &Walls::base, wall, "as the left wall", "fixed")
      .optional("left_friction", &Walls::left_friction, coefficient,
                "shear over effective normal stress at which the soil slides along a left wall with friction")
      .optional("right_friction", &Walls::right_friction, coefficient, "as left_friction")
      .optional("base_friction", &Walls::base_friction, coefficient, "as left_friction")
      .optional("absorbing_depth", &Walls::absorbing_depth, maybe(quantity(Dimension::length, above(0.0))),
                "how far the soil goes on behind absorbing walls until it is fixed: the spring that bears changes of "
                "load")
      .check(check_walls)
      .format();
}

Format<seepage::Water> water_format() {
  using seepage::Water;
  return Record<Water>()
      .optional("density", &Water::density, quantity(Dimension::density, above(0.0)), "rho_w")
      .optional("bulk_modulus", &Water::bulk_modulus, quantity(Dimension::pressure, above(0.0)), "K_w")
      .format();
}

/// A case is merged with its base before it is read. What is still there was added by --set.
Field<Case> include_field() {
  const std::string description =
      "another case file, path from this one: its keys hold where this one does not give them";
  return {{include_key, false, "", described(include_format().schema, description)},
          [](const Input& input, Case&) {
            input.problem("stands in a case file only; write it there, or take the base itself");
          },
          [](const Case&) { return Document{}; }};
}

Format<ProfileText> profile_format() {
  return Record<ProfileText>()
      .required("file", &ProfileText::file, path_text(),
                "CSV file, path from the file that names it; x ascends and covers the domain, # begins a comment",
                "profile.csv")
      .optional("x", &ProfileText::x, text(), "name of the column of x, with its unit at the end: x_m, x [cm]")
      .optional("y", &ProfileText::y, text(), "name of the column of the heights, with its unit at the end")
      .optional("depth", &ProfileText::depth, quantity(Dimension::length, at_least(0.0)),
                "how far below the line the soil begins, measured vertically")
      .format();
}

Format<RegionText> region_format() {
  Format<RegionText> format =
      Record<RegionText>()
          .required("soil", &RegionText::soil, text(), "name of one of the soils", "sandy_clay")
          .optional("polygon", &RegionText::polygon, list_of(pair_of(Dimension::length), 3),
                    "corners in order, in either sense")
          .optional("surface", &RegionText::surface, maybe(profile_format()),
                    "instead of a polygon: a line from a file, with soil from there down to the base")
          .optional("base", &RegionText::base, maybe(quantity(Dimension::length)),
                    "y of the lower side of what has a surface; the base of the domain without it")
          .check([](const Input& input, RegionText& region) {
            if (input.has("polygon") == input.has("surface")) {
              input.problem(
                  fmt::format("needs one of polygon and surface, got {}; write for example \"polygon: [[0 m, 0 "
                              "m], [36 m, 0 m], [36 m, 12 m]]\"",
                              input.has("polygon") ? "both" : "none"));
            } else if (region.base && input.has("polygon")) {
              input.at("base").problem("has a meaning only with a surface; remove it");
            }
          })
          .format();
  std::vector<Document> branches;
  for (const char* key : {"polygon", "surface"}) {
    Document branch = Document::map();
    branch.set("required", Document::list({Document::text(key)}));
    branches.push_back(std::move(branch));
  }
  format.schema.set("oneOf", Document::list(std::move(branches)));
  return format;
}

/// What a region with a surface fills; nothing, and a problem, if the line does not cover the domain.
std::vector<Point> polygon_below(const Input& region, const RegionText& text, const Domain& domain) {
  const Input surface = region.at("surface");
  const std::vector<Point> line = read_profile(surface, *text.surface);
  if (line.empty()) return {};
  const double tolerance = 1.0e-9 * domain.cell_size;
  if (line.front()[0] > domain.lower[0] + tolerance || line.back()[0] < domain.upper[0] - tolerance) {
    surface.at("file").problem(fmt::format(
        "{} goes from x = {} to {} and does not cover the domain, from {} to {}; add points or make the domain smaller",
        text.surface->file, length_text(line.front()[0]), length_text(line.back()[0]), length_text(domain.lower[0]),
        length_text(domain.upper[0])));
    return {};
  }
  return region_below(line, text.surface->depth, text.base.value_or(domain.lower[1]), domain);
}

/// The regions, whose soils go by name.
Field<Case> geometry_field() {
  const auto format = list_of(region_format(), 1);
  const auto read = [format](const Input& input, Case& result) {
    std::vector<RegionText> texts;
    format.read(input, texts);
    const bool sound = input.clean("geometry") && input.clean("domain") && result.domain.cell_size > 0.0;
    std::vector<std::string> names;
    for (const Soil& soil : result.soils) names.push_back(soil.name);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const auto found = std::find(names.begin(), names.end(), texts[i].soil);
      const Input region = input.item(i);
      if (sound && texts[i].surface) texts[i].polygon = polygon_below(region, texts[i], result.domain);
      result.regions.push_back({static_cast<std::size_t>(found - names.begin()), std::move(texts[i].polygon)});
      if (found != names.end() || names.empty() || !region.has("soil")) continue;
      region.at("soil").problem(
          fmt::format("there is no soil \"{}\"{}", shortened(texts[i].soil), suggestion(texts[i].soil, names)));
    }
  };
  const auto write = [format](const Case& input) {
    std::vector<RegionText> texts;
    for (const Region& region : input.regions) {
      texts.push_back({input.soils.at(region.soil).name, region.polygon, {}, {}});
    }
    return format.write(texts);
  };
  const std::string description = "regions filled with a soil; where two overlap, the later one holds";
  return {{"geometry", true, "[{soil: sandy_clay, polygon: [[0 m, 0 m], [36 m, 0 m], [36 m, 12 m]]}]",
           described(format.schema, description)},
          read,
          write};
}

Format<Case> initial_format() {
  return Record<Case>()
      .required("water", &Case::initial_water, initial_water_format(), "pore-water pressure before the start",
                "{type: hydrostatic, water_table: 3 m}")
      .optional(
          "stress", &Case::initial_stress,
          choice<InitialStress>(
              {{"self_weight", InitialStress::self_weight}, {"k0", InitialStress::k0}, {"none", InitialStress::none}}),
          "effective stress before the start: as if the weight came on an elastic soil that then yields; k0: from "
          "the weight of the soil above and k0_coefficient, then brought into balance; or none")
      .optional("k0_coefficient", &Case::k0_coefficient, maybe(quantity(Dimension::number, above(0.0))),
                "horizontal over vertical effective stress; without it 1 - sin(phi') (Jaky 1944)")
      .format();
}

Format<Case> coupling_format() {
  return Record<Case>()
      .optional("scheme", &Case::scheme,
                choice<Scheme>({{"semi_implicit", Scheme::semi_implicit},
                                {"explicit", Scheme::explicit_two_pass},
                                {"seepage", Scheme::seepage}}),
                "semi_implicit: stiff water at the soil's own time step; explicit: the paper's own cycle (section 2.6) "
                "with its two-pass operator, for reference on short runs; seepage: the water alone in unmoved soil, in "
                "long steps")
      .optional("skeleton", &Case::skeleton,
                choice<Skeleton>({{"deformable", Skeleton::deformable}, {"rigid", Skeleton::rigid}}),
                "whether the pore water feels the volume change of the skeleton")
      .optional("mixture_density", &Case::mixture_density,
                choice<MixtureDensity>(
                    {{"by_saturation", MixtureDensity::by_saturation}, {"saturated", MixtureDensity::saturated}}),
                "by_saturation: (1 - n) rho_s + n S_r rho_w; saturated: (1 - n) rho_s + n rho_w, as in the paper")
      .format();
}

Format<Numerics> numerics_format() {
  return Record<Numerics>()
      .optional("shape_function", &Numerics::shape_function,
                choice<ShapeFunction>(
                    {{"quadratic_bspline", ShapeFunction::quadratic_bspline}, {"linear", ShapeFunction::linear}}),
                "of the background grid")
      .optional("flip_fraction", &Numerics::flip_fraction, maybe(quantity(Dimension::number, from_to(0.0, 1.0))),
                "FLIP share of a FLIP/PIC blend; without this key the transfer is APIC")
      .optional("courant_number", &Numerics::courant_number, quantity(Dimension::number, between(0.0, 1.0)),
                "time step over the time in which a compression wave crosses a cell")
      .optional("pressure_tolerance", &Numerics::pressure_tolerance, quantity(Dimension::number, between(0.0, 1.0)),
                "how far each pressure step reduces its residual")
      .optional("smoothing_length", &Numerics::smoothing_length, quantity(Dimension::number, from_to(1.0, 2.0)),
                "SPH smoothing length over particle spacing")
      .format();
}

Format<Clock> clock_format() {
  return Record<Clock>()
      .optional("adaptive", &Clock::adaptive, flag(),
                "true: faster than real time while the soil is quiet; false: real time")
      .optional("unbalanced_limit", &Clock::unbalanced_limit, quantity(Dimension::number, above(0.0)),
                "unbalanced forces over the weight above which the clock slows down, because the soil does not follow "
                "the water; once pore pressures have changed since the start by more than 1 % of the overburden in the "
                "mean, it grows with their change")
      .optional("maximum_factor", &Clock::maximum_factor, quantity(Dimension::number, at_least(1.0)),
                "largest clock factor")
      .format();
}

Format<Case> failure_format() {
  return Record<Case>()
      .optional(
          "onset", &Case::onset, choice<Onset>({{"displacement", Onset::displacement}, {"runaway", Onset::runaway}}),
          "displacement: when the largest displacement passes onset_displacement; runaway: the kink from which on "
          "it grew by onset_displacement at five times the mean rate before, without slowing down; both "
          "times are told, this one drives stop.after_onset, stop.at_rest and the snapshot of the onset")
      .optional("onset_displacement", &Case::onset_displacement, quantity(Dimension::length, above(0.0)),
                "the slope has failed when the largest displacement passes this; what has moved by more has slid")
      .optional("zone_deviatoric_strain", &Case::failure_zone_strain, quantity(Dimension::number, above(0.0)),
                "the failure zone is where the deviatoric strain is above this")
      .format();
}

Format<Stop> stop_format() {
  return Record<Stop>()
      .required("time", &Stop::time, quantity(Dimension::time, above(0.0)), "the run ends at this time at the latest",
                "20 min")
      .optional("displacement", &Stop::displacement, quantity(Dimension::length, above(0.0)),
                "the run ends when the largest displacement passes this")
      .optional("after_onset", &Stop::after_onset, quantity(Dimension::time, at_least(0.0)),
                "the run ends this long after the onset of failure")
      .optional(
          "at_rest", &Stop::at_rest, flag(),
          "true: the run ends when the slide has come to rest: over the last third of the time since the onset, and "
          "five times sqrt(H/g), no particle moved by more than 2 % of what the largest displacement has grown by "
          "since the onset; soil that creeps on does not rest")
      .format();
}

Format<Output> output_format() {
  const Format<double> moment = quantity(Dimension::time, at_least(0.0));
  return Record<Output>()
      .optional("snapshots", &Output::snapshots, list_of(moment),
                "times of the particle files; start, onset, end and the times of the figures come on top")
      .optional("snapshot_interval", &Output::snapshot_interval, quantity(Dimension::time, above(0.0)),
                "particle files at every multiple of this as well")
      .optional(
          "history_interval", &Output::history_interval, quantity(Dimension::time, above(0.0)),
          "between the rows of the history table, at which steps end; without it a thousandth of stop.time, but 1 s at "
          "least")
      .format();
}

Format<Figures> figures_format() {
  const Format<double> moment = quantity(Dimension::time, at_least(0.0));
  return Record<Figures>()
      .optional("profile_times", &Figures::profile_times, list_of(moment),
                "times of the profiles of suction against height")
      .optional(
          "profile_reference", &Figures::profile_reference, path_text(),
          "CSV file with columns z_m and suction_head_m_t<time>, path from the file it stands in, drawn beside the "
          "profiles")
      .optional("contour_times", &Figures::contour_times, list_of(moment),
                "times of the contour pictures; without them: start, onset and end")
      .format();
}

Format<SafetyQuestions> safety_format() {
  return Record<SafetyQuestions>()
      .optional("times", &SafetyQuestions::times, list_of(quantity(Dimension::time, at_least(0.0))),
                "at which it is found; particle files are written then too")
      .optional("interval", &SafetyQuestions::interval, quantity(Dimension::time, above(0.0)),
                "and at the start and every multiple of this")
      .optional("tolerance", &SafetyQuestions::tolerance, quantity(Dimension::number, between(0.0, 1.0)),
                "width of the bracket in which the factor lies, over the factor")
      .optional("within", &SafetyQuestions::within, list_of(pair_of(Dimension::length), 3),
                "polygon in which the strength is reduced, by positions at the start; without it everywhere, at walls "
                "with friction too")
      .format();
}

}  // namespace

namespace {

/// The path of a file, which is more than a number.
Format<std::string> file_format(const std::string& expected) {
  Format<std::string> format = text();
  format.read = [expected](const Input& input, std::string& value) {
    const auto path = expect_value(input, expected);
    if (!path) return;
    value = *path;
    if (!is_text(input.node())) input.problem(fmt::format("expected {}, got \"{}\"", expected, value));
  };
  format.schema.set("minLength", Document::number(1));
  return format;
}

}  // namespace

Format<std::string> include_format() {
  return file_format("the path of a case file, such as \"base.yaml\"");
}

Format<std::string> library_format() {
  return file_format("the path of a soil library, such as \"soils.yaml\"");
}

Format<Case> case_format() {
  const auto points = named(part<VerificationPoint>(&VerificationPoint::position, pair_of(Dimension::length)));
  Record<Case> record;
  record.field(include_field())
      .required("title", &Case::title, text(), "what the case is about", "A slope under rain")
      .optional("gravity", &Case::gravity, quantity(Dimension::acceleration, above(0.0)), "downwards")
      .required("domain", &Case::domain, domain_format(),
                "the background grid; its sides and base are walls, its top is open",
                "{lower: [0 m, 0 m], upper: [36 m, 14 m], cell_size: 0.5 m, particles_per_cell: 4}")
      .required("walls", &Case::walls, walls_format(), "the sides and the base of the domain",
                "{left: roller, right: roller, base: fixed}")
      .optional("water", &Case::water, water_format(), "the pore water")
      .required("soils", &Case::soils, named(soil_format(), 1), "each soil by its name",
                "{sandy_clay: {youngs_modulus: 10 MPa, …}}")
      .field(geometry_field())
      .required("initial", whole, initial_format(), "the state before the start",
                "{water: {type: hydrostatic, water_table: 3 m}}")
      .optional("water_boundaries", &Case::water_boundaries, list_of(water_boundary_format()),
                "what the water meets at the boundary; without one a boundary is impermeable")
      .optional("loads", &Case::tractions, list_of(traction_format()), "tractions on the boundary, such as a surcharge")
      .optional("seismic", &Case::seismic, seismic_format(), "a pseudo-static earthquake")
      .optional("coupling", whole, coupling_format(), "between skeleton and pore water")
      .optional("numerics", &Case::numerics, numerics_format(), "of the two solvers")
      .optional("clock", &Case::clock, clock_format(), "how much faster than real time the run may go")
      .optional("failure", whole, failure_format(), "what counts as failure")
      .required("stop", &Case::stop, stop_format(), "when the run ends; the first that is met", "{time: 20 min}")
      .optional("points", &Case::points, points, "verification points: the particle nearest to each is followed")
      .optional("output", &Case::output, output_format(), "what is written, and when")
      .optional("figures", &Case::figures, figures_format(), "what slope-render draws beside the standard pictures")
      .optional("safety", &Case::safety, safety_format(),
                "the factor of safety by strength reduction: what all strength can be divided by until the slope no "
                "longer finds balance, with its water as it is then")
      .check([](const Input&, Case& result) { result.water.gravity = result.gravity; });
  return record.format();
}

}  // namespace slope::couple
