#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "case_folder.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

std::vector<Problem> problems_of(const std::filesystem::path& file, const std::vector<std::string>& overrides = {}) {
  try {
    (void)read_case(file, overrides);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

/// A mistake in the shipped slope: the text that it replaces, and all that the reader must say about it.
struct Mistake {
  const char* what;
  const char* text;
  const char* replacement;
  const char* key;
  const char* message;
  int lines_below = 0;  ///< between the replaced text and the line that is blamed
};

std::ostream& operator<<(std::ostream& out, const Mistake& mistake) {
  return out << mistake.what;
}

class OneMistake : public testing::TestWithParam<Mistake> {};

TEST_P(OneMistake, GetsOneMessageWithFileLineKeyAndRemedy) {
  const Mistake& mistake = GetParam();
  const ChangedCase changed = slope_with(mistake.text, mistake.replacement);
  const CaseFolder folder;
  const auto file = folder.write("slope.yaml", changed.content);
  const auto problems = problems_of(file);
  ASSERT_EQ(problems.size(), 1u) << (problems.empty() ? "" : InputError(problems).what());
  EXPECT_EQ(problems[0].text(), file.string() + ":" + std::to_string(changed.line + mistake.lines_below) + ": " +
                                    mistake.key + ": " + mistake.message);
}

const Mistake keys_and_units[] = {
    {"UnknownKey", "cohesion: 1 kPa", "cohesoin: 1 kPa", "soils.sandy_clay.strength.cohesoin",
     R"(unknown key, did you mean "cohesion"?)"},
    {"UnknownKeyUnlikeAnyOther", "residual_saturation: 0\n", "residual_saturation: 0\n      wetness: 1\n",
     "soils.sandy_clay.retention.wetness",
     "unknown key; choose one of: model, alpha, n, air_entry, residual_saturation, maximum_saturation", 1},
    {"NegativeAirEntry", "residual_saturation: 0\n", "residual_saturation: 0\n      air_entry: -1 cm\n",
     "soils.sandy_clay.retention.air_entry", "must be at least 0 m, got -1 cm", 1},
    {"KeyGivenTwice", "porosity: 0.35\n", "porosity: 0.35\n    porosity: 0.4\n", "soils.sandy_clay.porosity",
     "given twice, first in line 31; keep one", 1},
    {"MissingKey", "    porosity: 0.35\n", "", "soils.sandy_clay.porosity",
     R"(missing; write for example "porosity: 0.35")", -3},
    {"MissingUnit", "youngs_modulus: 10 MPa", "youngs_modulus: 10", "soils.sandy_clay.youngs_modulus",
     R"(expected a pressure with its unit, such as "10 kPa" (units: Pa, kPa, MPa, GPa, N/m2, kN/m2, MN/m2), got 10 without a unit)"},
    {"WrongUnit", "grain_density: 2700 kg/m3", "grain_density: 27 kN/m3", "soils.sandy_clay.grain_density",
     R"(expected a density with its unit, such as "2700 kg/m3" (units: kg/m3, g/cm3, t/m3), got "27 kN/m3", which is a unit weight)"},
    {"UnitOnANumber", "porosity: 0.35", "porosity: 0.35 m", "soils.sandy_clay.porosity",
     R"(expected a number without a unit, such as 0.35 (or in percent, "35 %"), got "0.35 m", which is a length)"},
    {"ListInsteadOfAValue", "porosity: 0.35", "porosity: [0.35]", "soils.sandy_clay.porosity",
     "expected one number, got a list"},
    {"ValueInsteadOfAMap", "walls: {left: roller, right: roller, base: fixed}", "walls: roller", "walls",
     R"(expected a map of keys, got "roller")"},
    {"UnknownChoice", "left: roller", "left: rollers", "walls.left",
     R"(unknown choice "rollers", did you mean "roller"?)"},
    {"UnknownModel", "model: hillel", "model: corey", "soils.sandy_clay.relative_permeability.model",
     R"(unknown model "corey"; choose one of: hillel, liakopoulos, exponential, van_genuchten_mualem)"},
    {"UnknownSoil", "soil: sandy_clay", "soil: sandy_caly", "geometry.0.soil",
     R"(there is no soil "sandy_caly", did you mean "sandy_clay"?)"},
    {"NameThatIsNone", "name: rain", "name: 1 rain", "water_boundaries.1 rain.name",
     R"(a name begins with a letter and has only letters, digits, _ and -; got "1 rain")"},
};
INSTANTIATE_TEST_SUITE_P(KeysAndUnits, OneMistake, testing::ValuesIn(keys_and_units),
                         [](const auto& instance) { return instance.param.what; });

const Mistake physics[] = {
    {"NegativePorosity", "porosity: 0.35", "porosity: -0.35", "soils.sandy_clay.porosity",
     "must be above 0 and below 1, got -0.35"},
    {"PorosityOfOne", "porosity: 0.35", "porosity: 100 %", "soils.sandy_clay.porosity",
     "must be above 0 and below 1, got 100 %"},
    {"FlatRetention", "n: 3\n", "n: 1\n", "soils.sandy_clay.retention.n", "must be above 1, got 1"},
    {"PoissonsRatio", "poissons_ratio: 0.33", "poissons_ratio: 0.5", "soils.sandy_clay.poissons_ratio",
     "must be above -1 and below 0.5, got 0.5"},
    {"NoStiffness", "youngs_modulus: 10 MPa", "youngs_modulus: 0 MPa", "soils.sandy_clay.youngs_modulus",
     "must be above 0 Pa, got 0 MPa"},
    {"NegativeWaterDensity", "density: 1000 kg/m3", "density: -1 kg/m3", "water.density",
     "must be above 0 kg/m3, got -1 kg/m3"},
    {"FrictionAngle", "friction_angle: 25 deg", "friction_angle: 90 deg", "soils.sandy_clay.strength.friction_angle",
     "must be at least 0 deg and below 90 deg, got 90 deg"},
    {"DilatancyAboveFriction", "dilatancy_angle: 0 deg", "dilatancy_angle: 30 deg",
     "soils.sandy_clay.strength.dilatancy_angle", "must not exceed the friction angle of 25 deg, got 30 deg"},
    {"CohesionRateAlone", "      maximum_cohesion_increase: 100 kPa\n", "",
     "soils.sandy_clay.strength.maximum_cohesion_increase",
     "missing, and cohesion_suction_rate has no effect without it; write for example \"maximum_cohesion_increase: 100 "
     "kPa\", or remove both",
     -5},
    {"SofteningBackwards", "cohesion: 1 kPa\n",
     "cohesion: 1 kPa\n      softening: {residual_cohesion: 0 kPa, residual_friction_angle: 20 deg, "
     "from_plastic_strain: 10 %, to_plastic_strain: 1 %}\n",
     "soils.sandy_clay.strength.softening.to_plastic_strain", "must be above from_plastic_strain, 0.1, got 0.01", 1},
    {"SofteningBelowZeroStrain", "cohesion: 1 kPa\n",
     "cohesion: 1 kPa\n      softening: {residual_cohesion: 0 kPa, residual_friction_angle: 20 deg, "
     "from_plastic_strain: -1 %, to_plastic_strain: 1 %}\n",
     "soils.sandy_clay.strength.softening.from_plastic_strain", "must be at least 0, got -1 %", 1},
    {"ResidualCohesionAbovePeak", "cohesion: 1 kPa\n",
     "cohesion: 1 kPa\n      softening: {residual_cohesion: 2 kPa, residual_friction_angle: 20 deg, "
     "from_plastic_strain: 0, to_plastic_strain: 1 %}\n",
     "soils.sandy_clay.strength.softening.residual_cohesion", "must not exceed cohesion, 1 kPa, got 2 kPa", 1},
    {"ResidualFrictionAbovePeak", "cohesion: 1 kPa\n",
     "cohesion: 1 kPa\n      softening: {residual_cohesion: 0 kPa, residual_friction_angle: 30 deg, "
     "from_plastic_strain: 0, to_plastic_strain: 1 %}\n",
     "soils.sandy_clay.strength.softening.residual_friction_angle",
     "must not exceed friction_angle, 25 deg, got 30 deg", 1},
    {"SofteningWithoutResidual", "cohesion: 1 kPa\n",
     "cohesion: 1 kPa\n      softening: {residual_cohesion: 0 kPa, from_plastic_strain: 0, "
     "to_plastic_strain: 1 %}\n",
     "soils.sandy_clay.strength.softening.residual_friction_angle",
     R"(missing; write for example "residual_friction_angle: 20 deg")", 1},
    {"UndrainedStrengthOfZero",
     "model: drucker_prager\n      cohesion: 1 kPa\n      friction_angle: 25 deg\n      dilatancy_angle: 0 deg\n      "
     "maximum_cohesion_increase: 100 kPa\n      cohesion_suction_rate: 0.07         # B of Eq. 15\n      "
     "friction_angle_suction_rate: 0 deg  # A of Eq. 16\n",
     "model: von_mises\n      undrained_strength: 0 kPa\n", "soils.sandy_clay.strength.undrained_strength",
     "must be above 0 Pa, got 0 kPa", 1},
    {"FrictionWithoutCoefficient", "base: fixed", "base: friction", "walls.base_friction",
     R"(missing; write for example "base_friction: 0.4")"},
    {"CoefficientWithoutFriction", "base: fixed", "base: fixed, left_friction: 0.4", "walls.left_friction",
     "has a meaning only for a wall of the kind friction; remove it"},
    {"NegativeFriction", "base: fixed", "base: friction, base_friction: -0.4", "walls.base_friction",
     "must be at least 0, got -0.4"},
    {"AbsorbingWithoutDepth", "base: fixed", "base: absorbing", "walls.absorbing_depth",
     R"(missing; write for example "absorbing_depth: 20 m")"},
    {"DepthWithoutAbsorbing", "base: fixed", "base: fixed, absorbing_depth: 20 m", "walls.absorbing_depth",
     "has a meaning only for a wall of the kind absorbing; remove it"},
    {"K0WithoutItsStress", "type: hydrostatic, water_table: 3 m}\n",
     "type: hydrostatic, water_table: 3 m}\n  k0_coefficient: 0.5\n", "initial.k0_coefficient",
     R"(has a meaning only with "stress: k0"; remove one or add the other)", 1},
    {"K0OfZero", "type: hydrostatic, water_table: 3 m}\n",
     "type: hydrostatic, water_table: 3 m}\n  k0_coefficient: 0\n", "initial.k0_coefficient", "must be above 0, got 0",
     1},
    {"SeismicCoefficientWithAUnit", "walls: {left", "seismic: {horizontal_coefficient: 1 m/s2}\nwalls: {left",
     "seismic.horizontal_coefficient",
     R"(expected a number without a unit, such as 0.35 (or in percent, "35 %"), got "1 m/s2", which is an acceleration)"},
    {"SeismicStartBeforeTheRun", "walls: {left", "seismic: {horizontal_coefficient: 0.1, start: -1 s}\nwalls: {left",
     "seismic.start", "must be at least 0 s, got -1 s"},
    {"ResidualAboveMaximum", "residual_saturation: 0\n      maximum_saturation: 1",
     "residual_saturation: 0.9\n      maximum_saturation: 0.8", "soils.sandy_clay.retention.residual_saturation",
     "must be below maximum_saturation, 0.8, got 0.9"},
    {"MualemWithoutRetentionToFollow",
     "retention:\n      model: van_genuchten\n      alpha: 0.05 1/m\n      n: 3\n      residual_saturation: 0\n"
     "      maximum_saturation: 1\n    relative_permeability: {model: hillel, exponent: 2}",
     "retention: {model: liakopoulos, coefficient: 0.1, exponent: 2}\n    relative_permeability: {model: "
     "van_genuchten_mualem}",
     "soils.sandy_clay.relative_permeability.n",
     R"(missing; the retention curve is no van Genuchten curve to take it from; write for example "n: 3")", 1},
    {"NegativeStart", "start: 0 s", "start: -1 s", "water_boundaries.rain.start", "must be at least 0 s, got -1 s"},
    {"NoTime", "time: 40 min", "time: 0 min", "stop.time", "must be above 0 s, got 0 min"},
    {"HistoryWithoutInterval", "history_interval: 1 s", "history_interval: 0 s", "output.history_interval",
     "must be above 0 s, got 0 s"},
};
INSTANTIATE_TEST_SUITE_P(Physics, OneMistake, testing::ValuesIn(physics),
                         [](const auto& instance) { return instance.param.what; });

const Mistake places[] = {
    {"DomainOfPartialCells", "upper: [36 m, 14 m]", "upper: [36.2 m, 14 m]", "domain.upper",
     "the width of 36.2 m is not a whole number of cells of 0.5 m; x = 36.5 m would be"},
    {"DomainUpsideDown", "upper: [36 m, 14 m]", "upper: [36 m, -1 m]", "domain.upper",
     "must be above lower, got (36 m, -1 m) and (0 m, 0 m)"},
    {"CellsBeyondCounting", "cell_size: 0.5 m", "cell_size: 0.5 mm", "domain.cell_size",
     "makes 2.02e+09 cells, at most 4e+06 are possible; choose a larger cell"},
    {"NoGeometry",
     "geometry:\n  - soil: sandy_clay\n    polygon: [[0 m, 0 m], [36 m, 0 m], [36 m, 12 m], [22.6 m, 12 m], [10 m, 5 "
     "m], [0 m, 5 m]]",
     "geometry: []", "geometry", "needs at least 1 item, got 0"},
    {"PolygonOfTwoCorners", "[36 m, 12 m], [22.6 m, 12 m], [10 m, 5 m], [0 m, 5 m]]", "]", "geometry.0.polygon",
     "needs at least 3 items, got 2"},
    {"PolygonOnALine", "[36 m, 12 m], [22.6 m, 12 m], [10 m, 5 m], [0 m, 5 m]]", "[20 m, 0 m]]", "geometry.0.polygon",
     "the polygon encloses no area; its corners lie on one line"},
    {"PolygonThatCrossesItself", "[36 m, 12 m], [22.6 m, 12 m], [10 m, 5 m], [0 m, 5 m]]", "[0 m, 5 m], [36 m, 12 m]]",
     "geometry.0.polygon",
     "the edges from (36 m, 0 m) and from (36 m, 12 m) cross each other; give the corners in order"},
    {"PolygonWithoutParticles", "[[0 m, 0 m], [36 m, 0 m], [36 m, 12 m], [22.6 m, 12 m], [10 m, 5 m], [0 m, 5 m]]",
     "[[0 m, 0 m], [10 cm, 0 m], [10 cm, 10 cm]]", "geometry.0.polygon",
     "no particle lies in the polygon; it is too small for cells of 0.5 m"},
    {"CornerOutsideOfTheDomain", "[36 m, 12 m], ", "[36 m, 15 m], ", "geometry.0.polygon.2",
     "the corner (36 m, 15 m) is outside of the domain, which goes from (0 m, 0 m) to (36 m, 14 m)"},
    {"PointInTheAir", "C2: [16.3 m, 7.75 m]", "C2: [16.3 m, 13 m]", "points.C2",
     "the point (16.3 m, 13 m) lies outside of the soil; move it into a region of geometry"},
    {"RainBesideTheSoil", "at: ground_surface,", "at: ground_surface, from: 40 m,", "water_boundaries.rain",
     R"(no particle lies there; check "at", "from" and "to")"},
    {"TwoPressuresInOnePlace", "water_boundaries:\n",
     "water_boundaries:\n  - {name: pond, at: ground_surface, to: 5 m, total_head: 6 m}\n", "water_boundaries.rain",
     R"(overlaps with "pond", and a pressure can be held only once; part them by "from" and "to")", 2},
    {"TwoBoundariesOfOneName", "water_boundaries:\n", "water_boundaries:\n  - {name: rain, at: left, pressure: 0 Pa}\n",
     "water_boundaries.rain.name", R"("rain" is the name of an earlier one; choose another)", 2},
    {"BoundaryWithoutCondition", "pressure: 0 kPa, applied_to: particle, ", "", "water_boundaries.rain",
     R"(needs one of pressure, total_head, flux, free_drainage, rain, reservoir, got none; write for example "pressure: 0 kPa")"},
    {"BoundaryWithTwoConditions", "pressure: 0 kPa,", "pressure: 0 kPa, flux: 1 mm/h,", "water_boundaries.rain",
     R"(needs one of pressure, total_head, flux, free_drainage, rain, reservoir, got 2; write for example "pressure: 0 kPa")"},
    {"RainInAFixedPlace", "pressure: 0 kPa, applied_to: particle", "rain: {intensity: 20 mm/h}",
     "water_boundaries.rain.at", R"(rain falls on the free surface; write "at: free_surface")"},
    {"PressureOnTheFreeSurface", "at: ground_surface", "at: free_surface", "water_boundaries.rain.at",
     R"(the free surface takes rain or a reservoir; write "at: ground_surface")"},
    {"RainWithoutIntensity", "at: ground_surface, pressure: 0 kPa, applied_to: particle",
     "at: free_surface, rain: {ponding_depth: 1 cm}", "water_boundaries.rain.rain",
     R"(needs one of intensity, hyetograph, file, got none; write for example "intensity: 20 mm/h")"},
    {"RainWithTwoIntensities", "at: ground_surface, pressure: 0 kPa, applied_to: particle",
     "at: free_surface, rain: {intensity: 1 mm/h, hyetograph: [[0 h, 1 mm/h]]}", "water_boundaries.rain.rain",
     R"(needs one of intensity, hyetograph, file, got 2; write for example "intensity: 20 mm/h")"},
    {"HyetographThatGoesBack", "at: ground_surface, pressure: 0 kPa, applied_to: particle",
     "at: free_surface, rain: {hyetograph: [[0 h, 1 mm/h], [2 h, 2 mm/h], [1 h, 0 mm/h]]}",
     "water_boundaries.rain.rain.hyetograph.2", "times must grow from step to step"},
    {"HyetographWithoutPairs", "at: ground_surface, pressure: 0 kPa, applied_to: particle",
     "at: free_surface, rain: {hyetograph: [[0 h, 1 mm/h, 2 h]]}", "water_boundaries.rain.rain.hyetograph.0",
     "expected [time, intensity], such as [2 h, 40 mm/h]"},
    {"HyetographWithoutUnits", "at: ground_surface, pressure: 0 kPa, applied_to: particle",
     "at: free_surface, rain: {hyetograph: [[0 h, 1 mm]]}", "water_boundaries.rain.rain.hyetograph.0.1",
     R"(expected a velocity with its unit, such as "1e-5 m/s" (units: m/s, cm/s, mm/s, m/h, cm/h, mm/h, m/d, cm/d, mm/d), got "1 mm", which is a length)"},
    {"NegativePondingDepth", "at: ground_surface, pressure: 0 kPa, applied_to: particle",
     "at: free_surface, rain: {intensity: 1 mm/h, ponding_depth: -1 cm}", "water_boundaries.rain.rain.ponding_depth",
     "must be at least 0 m, got -1 cm"},
    {"NoEvaporationLimit", "at: ground_surface, pressure: 0 kPa, applied_to: particle",
     "at: free_surface, rain: {intensity: -1 mm/d, evaporation_limit: 0 kPa}",
     "water_boundaries.rain.rain.evaporation_limit", "must be above 0 Pa, got 0 kPa"},
    {"RainInAParticle", "at: ground_surface, pressure: 0 kPa, applied_to: particle",
     "at: free_surface, rain: {intensity: 1 mm/h}, applied_to: particle", "water_boundaries.rain.applied_to",
     "rain always enters through the face; remove this key"},
    {"TwoRainsInOnePlace",
     "water_boundaries:\n  - {name: rain, at: ground_surface, pressure: 0 kPa, applied_to: particle",
     "water_boundaries:\n  - {name: hail, at: free_surface, to: 5 m, rain: {intensity: 1 mm/h}}\n"
     "  - {name: rain, at: free_surface, rain: {intensity: 1 mm/h}",
     "water_boundaries.rain", R"(overlaps with "hail", and rain can fall only once; part them by "from" and "to")", 2},
    {"FluxInAParticle", "pressure: 0 kPa, applied_to: particle", "flux: 1 mm/h, applied_to: particle",
     "water_boundaries.rain.applied_to", "a flux always enters through the face; remove this key"},
    {"SteadyWithoutBoundary", "type: hydrostatic", "type: steady", "initial.water",
     R"(steady seepage needs a water boundary with a pressure, total_head, rain or reservoir and "initial: true", )"
     "or free_drainage and a flux into the soil"},
    {"SteadyWithADrainAlone",
     "{type: hydrostatic, water_table: 3 m}\n  stress: self_weight\n\n# Rain that ponds nowhere: the pressure of the "
     "uppermost particle of every column goes to zero within 5 s.\n# Everything else is "
     "impermeable.\nwater_boundaries:\n",
     "{type: steady, water_table: 3 m}\n\nwater_boundaries:\n"
     "  - {name: drain, at: base, free_drainage: true, initial: true}\n",
     "initial.water",
     R"(steady seepage needs a water boundary with a pressure, total_head, rain or reservoir and "initial: true", )"
     "or free_drainage and a flux into the soil"},
    {"DrainOnTheGround", "at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: 5 s",
     "at: ground_surface, free_drainage: true", "water_boundaries.rain.at",
     R"(drains at the base only; write "at: base")"},
    {"DrainOnTheFreeSurface", "at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: 5 s",
     "at: free_surface, free_drainage: true", "water_boundaries.rain.at",
     R"(drains at the base only; write "at: base")"},
    {"TwoDrainsInOnePlace",
     "water_boundaries:\n  - {name: rain, at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: "
     "5 s}",
     "water_boundaries:\n  - {name: drain, at: base, free_drainage: true}\n"
     "  - {name: rain, at: base, from: 3 m, free_drainage: true}",
     "water_boundaries.rain", R"(overlaps with "drain", and water can drain only once; part them by "from" and "to")",
     2},
    {"DrainThatIsNone", "at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: 5 s",
     "at: base, free_drainage: false", "water_boundaries.rain.free_drainage",
     "must be true; without it remove this boundary"},
    {"DrainWithRamp", "at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: 5 s",
     "at: base, free_drainage: true, ramp: 5 s", "water_boundaries.rain.ramp",
     "free drainage knows only a beginning; remove this key"},
    {"DrainInAParticle", "at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: 5 s",
     "at: base, free_drainage: true, applied_to: face", "water_boundaries.rain.applied_to",
     "free drainage knows only a beginning; remove this key"},
    {"HeadWithTimesThatFall", "at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: 5 s",
     "at: left, total_head: [[1 h, 3 m], [1 h, 2 m]]", "water_boundaries.rain.total_head.1",
     "times must grow from step to step"},
    {"PressureOfAnotherUnit", "pressure: 0 kPa, applied_to: particle", "pressure: [[0 h, 1 kPa], [1 h, 2 m]]",
     "water_boundaries.rain.pressure.1.1",
     R"(expected a pressure with its unit, such as "10 kPa" (units: Pa, kPa, MPa, GPa, N/m2, kN/m2, MN/m2), got "2 m", which is a length)"},
    {"FluxPointOfThree", "pressure: 0 kPa, applied_to: particle", "flux: [[0 h, 1 mm/h, 2]]",
     "water_boundaries.rain.flux.0", "expected [time, flux], such as [10 h, 5 mm/h]"},
    {"InitialWithoutSteady", "ramp: 5 s}", "ramp: 5 s, initial: true}", "water_boundaries.rain.initial",
     "has a meaning only with initial.water of type steady; remove it"},
    {"ReservoirInAFixedPlace", "pressure: 0 kPa, applied_to: particle", "reservoir: {level: 3 m}",
     "water_boundaries.rain.at", R"(a reservoir stands on the free surface; write "at: free_surface")"},
    {"ReservoirWithRamp", "at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: 5 s",
     "at: free_surface, reservoir: {level: 3 m}, ramp: 5 s", "water_boundaries.rain.ramp",
     "a reservoir has its level and no more; remove this key"},
    {"LevelWithTimesThatFall", "at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: 5 s",
     "at: free_surface, reservoir: {level: [[1 h, 3 m], [1 h, 2 m]]}", "water_boundaries.rain.reservoir.level.1",
     "times must grow from step to step"},
    {"LevelPointOfThree", "at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: 5 s",
     "at: free_surface, reservoir: {level: [[1 h, 3 m, 2 m]]}", "water_boundaries.rain.reservoir.level.0",
     "expected [time, level], such as [10 h, 5 m]"},
    {"GroundBelowTheLevelBeyondTheRange",
     "at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: 5 s",
     "at: free_surface, from: 12 m, reservoir: {level: 6.5 m}", "water_boundaries.rain",
     R"(the ground at x = 0.125 m, y = 5 m lies beyond "from" and "to", but below the highest level, 6.5 m; widen the )"
     R"(range, give that side a reservoir of its own, or move the water alone with "coupling: {scheme: seepage}")"},
    {"TwoReservoirsOnOneParticle",
     "water_boundaries:\n  - {name: rain, at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: "
     "5 "
     "s}",
     "water_boundaries:\n  - {name: lake, at: free_surface, reservoir: {level: 3 m}}\n"
     "  - {name: rain, at: free_surface, reservoir: {level: 4 m}}",
     "water_boundaries.rain", R"(overlaps with "lake", and water can stand only once; part them by "from" and "to")",
     2},
    {"TwoReservoirsWithoutGroundBetween",
     "water_boundaries:\n  - {name: rain, at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: "
     "5 s}",
     "water_boundaries:\n  - {name: lake, at: free_surface, to: 24 m, reservoir: {level: 6 m}}\n"
     "  - {name: pond, at: free_surface, from: 24.5 m, reservoir: {level: 11 m}}",
     "water_boundaries.lake",
     "ends 0.5 m before the next reservoir begins; leave at least 1 m of ground between them, higher than both", 1},
    {"GroundBetweenTwoReservoirsBelowOneLevel",
     "water_boundaries:\n  - {name: rain, at: ground_surface, pressure: 0 kPa, applied_to: particle, start: 0 s, ramp: "
     "5 s}",
     "water_boundaries:\n  - {name: lake, at: free_surface, from: 14 m, reservoir: {level: 5.5 m}}\n"
     "  - {name: rain, at: free_surface, to: 9 m, reservoir: {level: 4 m}}",
     "water_boundaries.lake",
     R"(the ground at x = 9.125 m, y = 5 m lies beyond "from" and "to", but below the highest level, 5.5 m; widen the )"
     R"(range, give that side a reservoir of its own, or move the water alone with "coupling: {scheme: seepage}")",
     1},
    {"RainOnAGroundWhosePressureIsHeld", "water_boundaries:\n",
     "water_boundaries:\n  - {name: storm, at: free_surface, from: 9 m, rain: {intensity: 1 mm/h}}\n",
     "water_boundaries.rain",
     R"(overlaps with "storm": what is prescribed at the ground_surface takes the place of rain and reservoirs on the )"
     R"(free_surface; part them by "from" and "to", or remove one)",
     2},
    {"WaterTableInTheAir", "water_table: 3 m", "water_table: 7 m", "initial.water.water_table",
     R"(stands 2 m above the ground at x = 0.125 m; add a reservoir of that level with "initial: true" to )"
     "water_boundaries, or lower it"},
    {"WaterTableLineInTheAir", "type: hydrostatic, water_table: 3 m",
     "type: water_table, points: [[0 m, 3 m], [36 m, 16 m]]", "initial.water.points",
     R"(stands 0.302083 m above the ground at x = 6.375 m; add a reservoir of that level with "initial: true" to )"
     "water_boundaries, or lower it"},
    {"TooManySnapshots", "snapshot_interval: 1 min", "snapshot_interval: 1e-3 s", "output.snapshot_interval",
     "makes 2.4e+06 particle files until stop.time = 2400 s, at most 10000 are possible; choose 0.24 s or more"},
    {"TooManyRows", "history_interval: 1 s", "history_interval: 1e-6 s", "output.history_interval",
     "makes 2.4e+09 rows until stop.time = 2400 s, at most 1e+06 are possible; choose 0.0024 s or more"},
    {"LoadBesideTheSoil", "coupling:\n",
     "loads:\n  - {name: fill, at: base, to: -1 m, traction: [0 Pa, 1 kPa]}\n\ncoupling:\n", "loads.fill",
     R"(no particle lies there; check "at", "from" and "to")", 1},
    {"SnapshotAfterTheEnd", "history_interval: 1 s", "snapshots: [1 min, 1 h]", "output.snapshots.1",
     "3600 s is after the end of the run, stop.time = 2400 s"},
};
INSTANTIATE_TEST_SUITE_P(Places, OneMistake, testing::ValuesIn(places),
                         [](const auto& instance) { return instance.param.what; });

TEST(CaseProblems, AReferenceThatIsNotThereIsTold) {
  const CaseFolder folder;
  const ChangedCase changed = slope_with("output:\n", "figures: {profile_reference: measured.csv}\noutput:\n");
  const auto file = folder.write("slope.yaml", changed.content);
  const auto problems = problems_of(file);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].text(), file.string() + ":" + std::to_string(changed.line) +
                                    ": figures.profile_reference: there is no file " +
                                    (folder.path() / "measured.csv").string());
}

TEST(CaseProblems, AreAllToldAtOnceInTheOrderOfTheFile) {
  const CaseFolder folder;
  std::string content = slope_with("porosity: 0.35", "porosity: 2").content;
  for (const auto& [text, replacement] :
       std::vector<std::pair<std::string, std::string>>{{"title:", "titel:"},
                                                        {"cell_size: 0.5 m", "cell_size: 0.5"},
                                                        {"  time: 40 min\n", ""},
                                                        {"n: 3\n", "n: 0.5\n"}}) {
    content.replace(content.find(text), text.size(), replacement);
  }
  const auto problems = problems_of(folder.write("slope.yaml", content));
  std::vector<std::string> keys;
  for (const Problem& problem : problems) keys.push_back(problem.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"titel", "domain.cell_size", "soils.sandy_clay.porosity",
                                            "soils.sandy_clay.retention.n", "stop.time"}));
  EXPECT_TRUE(
      std::is_sorted(problems.begin(), problems.end(), [](const auto& a, const auto& b) { return a.line < b.line; }));
}

TEST(CaseProblems, AnEmptyCaseIsToldEveryKeyThatItNeeds) {
  const CaseFolder folder;
  const auto problems = problems_of(folder.write("case.yaml", "title: nothing yet\n"));
  std::vector<std::string> keys;
  for (const Problem& problem : problems) {
    keys.push_back(problem.key);
    EXPECT_TRUE(problem.message.starts_with("missing; write for example \"" + problem.key + ": ")) << problem.message;
  }
  EXPECT_EQ(keys, (std::vector<std::string>{"domain", "walls", "soils", "geometry", "initial", "stop"}));
}

TEST(CaseProblems, JakysFormulaNeedsAFrictionAngle) {
  const auto file = shipped_cases() / "quick.yaml";
  EXPECT_TRUE(problems_of(file, {"initial.stress=k0"}).empty());
  const auto problems = problems_of(
      file, {"initial.stress=k0", "soils.silty_sand.strength={model: von_mises, undrained_strength: 9 kPa}"});
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].key, "initial.k0_coefficient");
  EXPECT_EQ(problems[0].message,
            R"(missing; the soil "silty_sand" has no friction angle for Jaky's formula; write for example )"
            R"("k0_coefficient: 0.5")");
}

/// Files that hold no case at all.
struct NoCase {
  const char* what;
  std::string content;
  const char* rest;  ///< of the message, after the file's name
};

std::ostream& operator<<(std::ostream& out, const NoCase& file) {
  return out << file.what;
}

class NoCaseAtAll : public testing::TestWithParam<NoCase> {};

TEST_P(NoCaseAtAll, GetsOneMessage) {
  const CaseFolder folder;
  const auto file = folder.write("case.yaml", GetParam().content);
  const auto problems = problems_of(file);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].text(), file.string() + GetParam().rest);
}

const NoCase no_cases[] = {
    {"Empty", "", ": the file is empty"},
    {"OnlyComments", "# nothing\n", ": the file is empty"},
    {"OpenBracket", "title: [1, 2\nwalls: x\n", ":2: not YAML: end of sequence flow not found"},
    {"Tab", "title: x\n\twalls: y\n", ":2: not YAML: illegal tab when looking for indentation"},
    {"Words", "a slope\n", ":1: expected a map of keys, got \"a slope\""},
    {"List", "- 1\n", ":1: expected a map of keys, got a list"},
    {"Bytes",
     std::string("\x7f"
                 "ELF\0\1",
                 6),
     ": not YAML: it has bytes that no text has"},
    {"TwoDocuments", "title: x\n---\ntitle: y\n", ":3: a second YAML document begins here; a case is one document"},
    {"AnchorInItself", "title: &a [*a]\n", ":1: nested too deeply for a case file"},
};
INSTANTIATE_TEST_SUITE_P(Files, NoCaseAtAll, testing::ValuesIn(no_cases),
                         [](const auto& instance) { return instance.param.what; });

TEST(CaseProblems, AFileThatCannotBeReadIsAFileError) {
  const CaseFolder folder;
  EXPECT_THROW((void)read_case(folder.path() / "none.yaml"), FileError);
  EXPECT_THROW((void)read_case(folder.path()), FileError);
  try {
    (void)read_case(folder.path() / "none.yaml");
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), (folder.path() / "none.yaml").string() + ": cannot be read: No such file or directory");
  }
}

/// Water above the ground is held by a reservoir of that level or by a pressure there, whatever moves.
TEST(WaterTable, AboveTheGroundIsHeldOrRefused) {
  const auto problems = [](const std::string& water, const std::string& boundary, const std::string& scheme) {
    std::vector<std::string> keys;
    try {
      (void)read_case(shipped_cases() / "paper/slope-w2.yaml",
                      {"initial.water=" + water, "water_boundaries=[" + boundary + "]", "coupling.scheme=" + scheme});
    } catch (const InputError& error) {
      for (const Problem& problem : error.problems()) keys.push_back(problem.key);
    }
    return keys;
  };
  using Keys = std::vector<std::string>;
  const std::string level = "{type: hydrostatic, water_table: 7 m}";
  const std::string line = "{type: water_table, points: [[0 m, 7 m], [36 m, 7 m]]}";
  const std::string uniform = "{type: uniform, pressure: 15 kPa}";
  const std::string lake = "{name: lake, at: free_surface, initial: true, reservoir: {level: ";
  const std::string ground = "{name: ground, at: ground_surface, ";
  for (const std::string scheme : {"semi_implicit", "seepage"}) {
    for (const auto& [water, key] : {std::pair(level, "water_table"), std::pair(line, "points")}) {
      EXPECT_EQ(problems(water, "", scheme), Keys{std::string("initial.water.") + key});
      EXPECT_EQ(problems(water, lake + "7 m}}", scheme), Keys{});
      EXPECT_EQ(problems(water, lake + "6 m}}", scheme).size(), 1u) << "a lower lake";
      EXPECT_EQ(problems(water, ground + "total_head: 7 m}", scheme), Keys{});
      EXPECT_EQ(problems(water, ground + "pressure: 0 kPa}", scheme).size(), 1u);
    }
    EXPECT_EQ(problems(uniform, "", scheme), Keys{"initial.water.pressure"});
    EXPECT_EQ(problems(uniform, ground + "pressure: 0 kPa}", scheme), Keys{}) << "consolidation";
    EXPECT_EQ(problems("{type: uniform, pressure: -15 kPa}", "", scheme), Keys{});
  }
}

/// A mistake in a file of rain, and what is said about it after the file's name.
TEST(Hyetograph, FileGetsOneMessageWithItsLine) {
  const std::string header =
      "expected a header such as \"time_h,intensity_mm_per_h\" (time in s, min, h or d; intensity in mm or m per s, h "
      "or d)";
  const std::string parted = ", columns parted by a comma, decimals by a point; got ";
  const auto numbers = [&](int line) {
    return ":" + std::to_string(line) + ": expected two numbers, a time and the intensity from then on" + parted;
  };
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"", ": holds no row; " + header},
      {"0,1\n", ":1: " + header + parted + "\"0,1\""},
      {"# rain\ntime_h,intensity_mm\n0,1\n", ":2: " + header + parted + "\"time_h,intensity_mm\""},
      {"time_h;intensity_mm_per_h\n0;1\n", ":1: " + header + parted + "\"time_h;intensity_mm_per_h\""},
      {"time_h,intensity_mm_per_h\n0,1\n2\n", numbers(3) + "\"2\""},
      {"time_h,intensity_mm_per_h\n0,0,5\n", numbers(2) + "\"0,0,5\""},
      {"time_h,intensity_mm_per_h\n0,a lot\n", numbers(2) + "\"0,a lot\""},
      {"time_h,intensity_mm_per_h\n0,1\n2,3\n2,4\n", ":4: times must grow from row to row"},
      {"time_h,intensity_mm_per_h\n0,1\n1,-999\n2,0\n",
       ":3: \"-999\" stands for a missing value; write what fell then, 0 if nothing did"},
      {"time_h,intensity_mm_per_h\n0,1\n1,\n2,0\n",
       ":3: \"\" stands for a missing value; write what fell then, 0 if nothing did"},
      {"time_h,intensity_mm_per_h\n0,NaN\n2,0\n",
       ":2: \"NaN\" stands for a missing value; write what fell then, 0 if nothing did"}};
  const CaseFolder folder;
  const auto file = folder.write("slope.yaml", slope_with("at: ground_surface, pressure: 0 kPa, applied_to: particle",
                                                          "at: free_surface, rain: {file: storm.csv}")
                                                   .content);
  const std::string path = (folder.path() / "storm.csv").string();
  auto problems = problems_of(file);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].key, "water_boundaries.rain.rain.file");
  EXPECT_EQ(problems[0].message, "the file " + path + " cannot be read; the path counts from the case's folder");
  for (const auto& [content, message] : mistakes) {
    folder.write("storm.csv", content);
    problems = problems_of(file);
    ASSERT_EQ(problems.size(), 1u) << content;
    EXPECT_EQ(problems[0].message, path + message);
  }
}

class RainTables : public testing::Test {
 protected:
  /// The problems, or else the warnings, of the slope under the rain of a table.
  std::vector<std::string> told_of(const std::string& rows, const std::string& more = "",
                                   const std::string& stop = "40 min") {
    folder_.write("gauge.csv", "time_min,intensity_mm_per_h\n" + rows);
    const auto file =
        folder_.write("slope.yaml", slope_with("at: ground_surface, pressure: 0 kPa, applied_to: particle",
                                               "at: free_surface, rain: {file: gauge.csv" + more + "}")
                                        .content);
    std::vector<Problem> found;
    try {
      read_ = read_case(file, {"stop.time=" + stop}, &found);
    } catch (const InputError& error) {
      found = error.problems();
    }
    std::vector<std::string> texts;
    for (const Problem& problem : found) texts.push_back(problem.text().substr(folder_.path().string().size() + 1));
    return texts;
  }
  [[nodiscard]] const std::vector<RainStep>& steps() const {
    return std::get<Rain>(read_.water_boundaries.at(0).condition).hyetograph;
  }

  CaseFolder folder_;
  Case read_;
};

using Texts = std::vector<std::string>;

TEST_F(RainTables, MustSayWhatComesAfterALastRowThatIsWet) {
  const std::string wet = "0,2\n10,2\n20,4\n";
  const auto told = told_of(wet);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("water_boundaries.rain.rain.file: the last row, 4 mm/h from 0.333333 h on, would hold until "
                         "stop.time, 0.666667 h; end the table with a row of 0, or say \"after_table: dry\" or "
                         "\"after_table: last_row\""),
            std::string::npos)
      << told[0];
  EXPECT_EQ(told_of(wet, ", after_table: last_row"), Texts{});
  EXPECT_EQ(steps().size(), 3u);
  EXPECT_EQ(told_of(wet, ", after_table: dry"), Texts{});
  ASSERT_EQ(steps().size(), 4u);
  EXPECT_EQ(steps()[3].time, 1800.0) << "the last row lasts as long as the others";
  EXPECT_EQ(steps()[3].intensity, 0.0);
  EXPECT_EQ(told_of(wet + "30,0\n"), Texts{});
  EXPECT_EQ(told_of(wet, "", "30 min"), Texts{}) << "the run ends with the row";
  EXPECT_EQ(told_of(wet, "", "31 min").size(), 1u);
  EXPECT_EQ(told_of("0,2\n").size(), 1u) << "nobody knows how long";
  EXPECT_EQ(told_of("0,-0.1\n10,-0.2\n").size(), 1u) << "evaporation too";
  EXPECT_NE(told_of("0,2\n", ", after_table: dry").at(0).find("a table of one row does not say how long that lasts"),
            std::string::npos);
}

TEST_F(RainTables, AreWarnedOfGapsThatHoldRain) {
  const std::string even = "0,0\n1,2\n2,3\n3,1\n4,1\n5,0\n6,0\n";
  EXPECT_EQ(told_of(even), Texts{});
  EXPECT_EQ(told_of(even + "7,0\r\n"), Texts{});
  const auto told = told_of("0,0\n1,2\n2,3\n3,1\n4,1\n9,2\n10,0\n");
  ASSERT_EQ(told.size(), 1u);
  EXPECT_TRUE(
      told[0].starts_with("gauge.csv:7: water_boundaries.rain.rain.file: comes 0.0833333 h after the row before, "
                          "where 0.0166667 h are usual, and what fell then, 1 mm/h, is held all the time"))
      << told[0];
  EXPECT_EQ(told_of("0,0\n1,2\n2,3\n3,1\n4,0\n9,2\n10,0\n"), Texts{}) << "a gap that holds no rain";
  EXPECT_EQ(told_of("0,1\n6,2\n8,3\n20,4\n22,1\n30,0\n"), Texts{}) << "steps, not intervals of a gauge";
}

TEST_F(RainTables, AreWarnedOfWhatNoSkyAndNoAirDo) {
  EXPECT_EQ(told_of("0,499\n1,0\n"), Texts{});
  EXPECT_TRUE(
      told_of("0,501\n1,0\n")
          .at(0)
          .starts_with(
              "gauge.csv:2: water_boundaries.rain.rain.file: 501 mm/h is more than any rain; is the unit right?"));
  EXPECT_NE(told_of("0,2\n1,-1\n2,0\n").at(0).find("gauge.csv:3"), std::string::npos);
  EXPECT_NE(told_of("0,2\n1,-1\n2,0\n").at(0).find("evaporates 24 mm/d, more than any air does"), std::string::npos);
  EXPECT_EQ(told_of("0,2\n1,-0.5\n2,0\n"), Texts{});
}

TEST_F(RainTables, KeepTheirKeysForTables) {
  const auto file =
      folder_.write("slope.yaml", slope_with("at: ground_surface, pressure: 0 kPa, applied_to: particle",
                                             "at: free_surface, rain: {intensity: 1 mm/h, after_table: dry}")
                                      .content);
  const auto problems = problems_of(file);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].message, "has a meaning only with a file; remove it");
  std::vector<Problem> warnings;
  const auto odd =
      folder_.write("odd.yaml", slope_with("at: ground_surface, pressure: 0 kPa, applied_to: particle",
                                           "at: free_surface, rain: {hyetograph: [[0 h, 1 m/h], [1 h, 0 mm/h]]}")
                                    .content);
  (void)read_case(odd, {}, &warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "water_boundaries.rain.rain.hyetograph.0");
}

}  // namespace
}  // namespace slope::couple::test
