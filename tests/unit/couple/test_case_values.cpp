#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "case_folder.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

class ShippedCase : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(ShippedCase, ResolvedReadsBackTheSame) {
  Case input = read_case(GetParam());
  const CaseFolder folder;
  if (!input.figures.profile_reference.empty()) {
    folder.write("reference.csv", "z_m,suction_head_m_t300\n");
    input.figures.profile_reference = "reference.csv";
  }
  const std::string resolved = resolved_yaml(input);
  const Case again = read_case(folder.write("case.yaml", resolved));
  EXPECT_EQ(resolved_yaml(again), resolved);
  EXPECT_EQ(again.soils.size(), input.soils.size());
  EXPECT_EQ(again.stop.displacement, input.stop.displacement);
  EXPECT_EQ(again.output.snapshots, input.output.snapshots);
  EXPECT_EQ(again.initial_water.index(), input.initial_water.index());
}

INSTANTIATE_TEST_SUITE_P(All, ShippedCase, testing::ValuesIn(shipped_case_files()), [](const auto& instance) {
  std::string name = instance.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

TEST(CaseValues, TheSlopeIsTheOneOfThePapersTable2) {
  const Case input = read_case(shipped_cases() / "paper/slope-w2.yaml");
  const Soil& soil = input.soils.at(0);
  const auto& strength = std::get<solid::DruckerPrager>(soil.solid.strength);
  const auto& retention = std::get<seepage::VanGenuchten>(soil.seepage.retention);
  EXPECT_EQ(soil.solid.elastic.youngs_modulus, 10.0e6);
  EXPECT_EQ(soil.solid.elastic.poissons_ratio, 0.33);
  EXPECT_EQ(soil.porosity, 0.35);
  EXPECT_EQ(soil.solid.grain_density, 2700.0);
  EXPECT_EQ(input.water.density, 1000.0);
  EXPECT_EQ(input.water.bulk_modulus, 2.0e9);
  EXPECT_EQ(strength.cohesion, 1.0e3);
  EXPECT_EQ(strength.friction_angle, 25.0 * std::numbers::pi / 180.0);
  EXPECT_EQ(strength.maximum_cohesion_increase, 100.0e3);
  EXPECT_EQ(strength.friction_angle_suction_rate, 0.0);
  EXPECT_EQ(strength.cohesion_suction_rate, 0.07);
  EXPECT_EQ(soil.seepage.hydraulic_conductivity, 1.0e-5);
  EXPECT_EQ(retention.alpha, 0.05);
  EXPECT_EQ(retention.n, 3.0);
  EXPECT_EQ(std::get<seepage::HillelPower>(soil.seepage.relative_permeability.law).exponent, 2.0);
  EXPECT_EQ(std::get<HydrostaticWater>(input.initial_water).water_table, 3.0);
  EXPECT_EQ(input.mixture_density, MixtureDensity::saturated);
  const auto& rain = std::get<PrescribedPressure>(input.water_boundaries.at(0).condition);
  EXPECT_EQ(rain.pressure.at(0.0), 0.0);
  EXPECT_FALSE(rain.at_face);
  EXPECT_EQ(input.points.size(), 7u);
}

/// A slope of the paper's Tables 3 and 4, and the time in which it does what W2 does in one.
struct PaperSlope {
  const char* name;
  double alpha;
  double hydraulic_conductivity;
  double times;
};

TEST(CaseValues, TheSlopesDifferAsInThePapersTables3And4) {
  const Case base = read_case(shipped_cases() / "paper/slope-w2.yaml");
  for (const PaperSlope& slope : std::vector<PaperSlope>{{"w1", 0.025, 1.0e-5, 1.0},
                                                         {"w2", 0.05, 1.0e-5, 1.0},
                                                         {"w3", 0.074, 1.0e-5, 1.0},
                                                         {"h1", 0.05, 1.0e-4, 0.1},
                                                         {"h2", 0.05, 1.0e-5, 1.0},
                                                         {"h3", 0.05, 1.0e-6, 10.0}}) {
    SCOPED_TRACE(slope.name);
    Case input = read_case(shipped_cases() / "paper" / (std::string("slope-") + slope.name + ".yaml"));
    seepage::Soil& soil = input.soils.at(0).seepage;
    auto& retention = std::get<seepage::VanGenuchten>(soil.retention);
    WaterBoundary& rain = input.water_boundaries.at(0);
    EXPECT_EQ(retention.alpha, slope.alpha);
    EXPECT_EQ(soil.hydraulic_conductivity, slope.hydraulic_conductivity);
    EXPECT_EQ(rain.ramp, 5.0 * slope.times);
    EXPECT_EQ(input.stop.time, 2400.0 * slope.times);
    EXPECT_EQ(input.output.snapshot_interval, 60.0 * slope.times);
    EXPECT_EQ(input.output.history_interval, slope.times);
    std::string capital = slope.name;
    capital.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(capital.front())));
    EXPECT_EQ(input.title, "Slope " + capital + " under rain");

    input.title = base.title;
    retention.alpha = 0.05;
    soil.hydraulic_conductivity = 1.0e-5;
    rain.ramp = base.water_boundaries.at(0).ramp;
    input.stop.time = base.stop.time;
    input.output = base.output;
    EXPECT_EQ(resolved_yaml(input), resolved_yaml(base)) << "nothing else differs";
  }
}

TEST(CaseValues, TheColumnIsTheOneOfThePapersTable1) {
  const Case input = read_case(shipped_cases() / "paper/liakopoulos.yaml");
  const Soil& soil = input.soils.at(0);
  EXPECT_EQ(soil.solid.elastic.youngs_modulus, 1.3e6);
  EXPECT_EQ(soil.solid.elastic.poissons_ratio, 0.4);
  EXPECT_EQ(soil.porosity, 0.2975);
  EXPECT_EQ(soil.solid.grain_density, 2000.0);
  EXPECT_EQ(soil.seepage.hydraulic_conductivity, 4.41e-6);
  EXPECT_EQ(std::get<seepage::LiakopoulosRetention>(soil.seepage.retention).coefficient, 0.10152);
  EXPECT_EQ(std::get<seepage::LiakopoulosRetention>(soil.seepage.retention).exponent, 2.4279);
  EXPECT_EQ(std::get<seepage::LiakopoulosPermeability>(soil.seepage.relative_permeability.law).coefficient, 2.207);
  EXPECT_TRUE(std::get<PrescribedPressure>(input.water_boundaries.at(0).condition).at_face);
  EXPECT_EQ(input.output.snapshots, (std::vector<double>{60, 120, 300, 600, 1200, 1800, 3600, 7200}));
}

/// The shipped slope with everything that it leaves out, each in its other form.
std::string full_case() {
  std::string content = slope_with("type: hydrostatic, water_table: 3 m", "type: steady, water_table: 3 m").content;
  const auto replace = [&content](const std::string& text, const std::string& replacement) {
    content.replace(content.find(text), text.size(), replacement);
  };
  replace("title:", "gravity: 3.71 m/s2\ntitle:");
  replace(
      "water_boundaries:\n",
      "loads:\n"
      "  - {name: fill, at: ground_surface, from: 30 m, traction: [0 kPa, -10 kPa], start: 1 h, ramp: 10 s}\n"
      "water_boundaries:\n"
      "  - {name: river, at: left, to: 2 m, total_head: [[0 h, 2.5 m], [1 h, 2 m]], applied_to: face, initial: true}\n"
      "  - {name: drain, at: base, free_drainage: true, start: 2 min}\n"
      "  - {name: drizzle, at: right, from: 11 m, flux: 36 mm/h, start: 3 min}\n"
      "  - {name: storm, at: free_surface, to: 9 m, rain: {hyetograph: [[1 h, 36 mm/h], [2 h, -3.6 mm/h]], "
      "ponding_depth: 5 mm, evaporation_limit: 50 kPa, before_start: 3.6 mm/h}}\n");
  replace("at: ground_surface, pressure: 0 kPa", "at: ground_surface, from: 9 m, pressure: 0 kPa");
  replace("left: roller, right: roller, base: fixed",
          "left: friction, right: roller, base: absorbing, left_friction: 0.3, absorbing_depth: 20 m");
  replace("stress: self_weight", "stress: k0\n  k0_coefficient: 0.6");
  replace("skeleton: deformable", "skeleton: rigid");
  replace("model: drucker_prager\n",
          "model: mohr_coulomb\n      softening: {residual_cohesion: 0.5 kPa, residual_friction_angle: 20 deg, "
          "from_plastic_strain: 1 %, to_plastic_strain: 10 %, characteristic_length: 0.25 m}\n");
  replace("relative_permeability: {model: hillel, exponent: 2}",
          "relative_permeability: {model: van_genuchten_mualem, floor: 1e-7}");
  replace("      n: 3\n", "      n: 3\n      air_entry: 2 cm\n");
  content +=
      "  snapshots: [3 s, 1 s, 3 s]\n"
      "seismic: {horizontal_coefficient: 0.1, vertical_coefficient: -5 %, start: 2 s, ramp: 3 s}\n"
      "numerics: {shape_function: linear, flip_fraction: 95 %, courant_number: 0.3, pressure_tolerance: 0.1, "
      "smoothing_length: 1.3}\n"
      "clock: {adaptive: false, unbalanced_limit: 0.1, maximum_factor: 10}\n"
      "figures: {profile_times: [2 s], contour_times: [1 s, 40 min]}\n"
      "safety: {times: [5 s, 1 min], interval: 2 min, tolerance: 1 %, within: [[0 m, 0 m], [9 m, 0 m], [9 m, 5 m]]}\n";
  return content;
}

TEST(CaseValues, EveryKeyReachesTheCase) {
  const CaseFolder folder;
  const Case input = read_case(folder.write("slope.yaml", full_case()));
  EXPECT_EQ(input.gravity, 3.71);
  EXPECT_EQ(input.water.gravity, 3.71);
  EXPECT_EQ(std::get<SteadyWater>(input.initial_water).water_table, 3.0);
  ASSERT_EQ(input.water_boundaries.size(), 5u);
  const WaterBoundary& river = input.water_boundaries[0];
  EXPECT_EQ(river.where.place, Place::left);
  EXPECT_EQ(river.where.from, -never);
  EXPECT_EQ(river.where.to, 2.0);
  EXPECT_TRUE(river.initial);
  const TimeSeries& head = std::get<PrescribedPressure>(river.condition).total_head.value();
  EXPECT_EQ(head.at(0.0), 2.5);
  EXPECT_EQ(head.at(1800.0), 2.25);
  EXPECT_EQ(head.at(9999.0), 2.0);
  EXPECT_TRUE(std::get<PrescribedPressure>(river.condition).at_face);
  EXPECT_TRUE(std::holds_alternative<FreeDrainage>(input.water_boundaries[1].condition));
  EXPECT_EQ(input.water_boundaries[1].start, 120.0);
  EXPECT_EQ(std::get<PrescribedFlux>(input.water_boundaries[2].condition).flux.at(0.0), 1.0e-5);
  EXPECT_EQ(input.water_boundaries[2].start, 180.0);
  EXPECT_EQ(input.water_boundaries[3].where.place, Place::free_surface);
  const auto& storm = std::get<Rain>(input.water_boundaries[3].condition);
  ASSERT_EQ(storm.hyetograph.size(), 2u);
  EXPECT_EQ(storm.hyetograph[0].time, 3600.0);
  EXPECT_EQ(storm.hyetograph[0].intensity, 1.0e-5);
  EXPECT_EQ(storm.hyetograph[1].intensity, -1.0e-6);
  EXPECT_EQ(storm.ponding_depth, 0.005);
  EXPECT_EQ(storm.evaporation_limit, 5.0e4);
  EXPECT_EQ(storm.before_start, 1.0e-6);
  ASSERT_EQ(input.tractions.size(), 1u);
  EXPECT_EQ(input.tractions[0].traction, (Point{0.0, -1.0e4}));
  EXPECT_EQ(input.tractions[0].start, 3600.0);
  EXPECT_EQ(input.skeleton, Skeleton::rigid);
  const auto& strength = std::get<solid::MohrCoulomb>(input.soils.at(0).solid.strength);
  EXPECT_EQ(strength.cohesion, 1.0e3);
  ASSERT_TRUE(strength.softening.has_value());
  EXPECT_EQ(strength.softening->residual_cohesion, 500.0);
  EXPECT_NEAR(strength.softening->residual_friction_angle, 20.0 * std::numbers::pi / 180.0, 1e-15);
  EXPECT_EQ(strength.softening->range.from, 0.01);
  EXPECT_EQ(strength.softening->range.to, 0.1);
  EXPECT_EQ(strength.softening->range.characteristic_length, 0.25);
  EXPECT_EQ(input.walls.left, Wall::friction);
  EXPECT_EQ(input.walls.left_friction, 0.3);
  EXPECT_EQ(input.walls.right_friction, std::nullopt);
  EXPECT_EQ(input.walls.base, Wall::absorbing);
  EXPECT_EQ(input.walls.absorbing_depth, 20.0);
  EXPECT_EQ(input.seismic.horizontal_coefficient, 0.1);
  EXPECT_EQ(input.seismic.vertical_coefficient, -0.05);
  EXPECT_EQ(input.seismic.start, 2.0);
  EXPECT_EQ(input.seismic.ramp, 3.0);
  EXPECT_EQ(input.initial_stress, InitialStress::k0);
  EXPECT_EQ(input.k0_coefficient, 0.6);
  const auto& permeability = input.soils.at(0).seepage.relative_permeability;
  EXPECT_EQ(std::get<seepage::VanGenuchtenMualem>(permeability.law).n, 3.0);
  EXPECT_EQ(permeability.floor, 1.0e-7);
  const auto& curve = std::get<seepage::VanGenuchten>(input.soils.at(0).seepage.retention);
  EXPECT_EQ(curve.air_entry, 0.02);
  EXPECT_EQ(std::get<seepage::VanGenuchtenMualem>(permeability.law).entry_saturation, curve.entry_saturation());
  EXPECT_EQ(input.numerics.shape_function, ShapeFunction::linear);
  EXPECT_EQ(input.numerics.flip_fraction, 0.95);
  EXPECT_EQ(input.safety.times, (std::vector<double>{5.0, 60.0}));
  EXPECT_EQ(input.safety.interval, 120.0);
  EXPECT_EQ(input.safety.tolerance, 0.01);
  EXPECT_EQ(input.safety.within, (std::vector<Point>{{0.0, 0.0}, {9.0, 0.0}, {9.0, 5.0}}));
  EXPECT_EQ(input.numerics.courant_number, 0.3);
  EXPECT_EQ(input.numerics.pressure_tolerance, 0.1);
  EXPECT_EQ(input.numerics.smoothing_length, 1.3);
  EXPECT_FALSE(input.clock.adaptive);
  EXPECT_EQ(input.clock.unbalanced_limit, 0.1);
  EXPECT_EQ(input.clock.maximum_factor, 10.0);
  EXPECT_EQ(input.onset_displacement, 0.02);
  EXPECT_EQ(input.failure_zone_strain, 0.02);
  EXPECT_EQ(input.output.snapshots, (std::vector<double>{1, 2, 3, 2400}))
      << "sorted, once each, with the figures' times";
}

TEST(CaseValues, EveryKeyIsWrittenBack) {
  const CaseFolder folder;
  const std::string resolved = resolved_yaml(read_case(folder.write("slope.yaml", full_case())));
  EXPECT_EQ(resolved_yaml(read_case(folder.write("resolved.yaml", resolved))), resolved);
  for (const char* line : {"gravity: 3.71 m/s2", "type: steady", "total_head: [[0 s, 2.5 m], [3600 s, 2 m]]",
                           "free_drainage: true", "flux: 1e-05 m/s", "flip_fraction: 0.95", "applied_to: face",
                           "initial: true", "evaporation_limit: 50 kPa", "at: free_surface", "model: mohr_coulomb",
                           "to_plastic_strain: 0.1", "youngs_modulus: 10 MPa", "friction_angle: 25 deg"}) {
    EXPECT_NE(resolved.find(line), std::string::npos) << line << "\n" << resolved;
  }
}

TEST(CaseValues, ModifiedCamClayHasItsOwnStiffness) {
  const CaseFolder folder;
  const std::string clay =
      "soils.sandy_clay.strength={model: modified_cam_clay, critical_state_friction_angle: 25 deg, lambda: 0.16, "
      "kappa: "
      "0.04, minimum_mean_stress: 2 kPa, pre_overburden_pressure: 30 kPa}";
  std::vector<Problem> warnings;
  const auto stiff = folder.write("stiff.yaml", slope_with("", "").content);
  const Case input = read_case(stiff, {clay}, &warnings);
  const auto& law = std::get<solid::ModifiedCamClay>(input.soils[0].solid.strength);
  const double sine = std::sin(25.0 * std::numbers::pi / 180.0);
  EXPECT_NEAR(law.critical_state_ratio, 6.0 * sine / (3.0 - sine), 1e-12);
  EXPECT_EQ(law.lambda, 0.16);
  EXPECT_EQ(law.kappa, 0.04);
  EXPECT_EQ(law.minimum_mean_stress, 2.0e3);
  EXPECT_EQ(law.pre_overburden_pressure, 30.0e3);
  EXPECT_FALSE(law.overconsolidation_ratio);
  EXPECT_FALSE(law.preconsolidation_pressure);
  EXPECT_EQ(input.soils[0].solid.elastic.youngs_modulus, 0.0);
  EXPECT_EQ(input.soils[0].solid.elastic.poissons_ratio, 0.33);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "soils.sandy_clay.youngs_modulus");
  EXPECT_EQ(warnings[0].message,
            "has no effect with the strength model modified_cam_clay, whose stiffness comes from kappa and the mean "
            "stress");

  const auto soft = folder.write("soft.yaml", slope_with("    youngs_modulus: 10 MPa\n", "").content);
  warnings.clear();
  EXPECT_EQ(read_case(soft, {clay}, &warnings).soils[0].solid.elastic.youngs_modulus, 0.0);
  EXPECT_TRUE(warnings.empty());
  EXPECT_THROW((void)read_case(soft), InputError) << "the other laws need it";
}

TEST(CaseValues, TheHistoryHasAThousandRowsUnlessTheCaseSays) {
  const CaseFolder folder;
  std::string content = slope_with("  history_interval: 1 s\n", "").content;
  EXPECT_EQ(read_case(folder.write("slope.yaml", content)).output.history_interval, 2.4);
  content.replace(content.find("time: 40 min"), 12, "time: 1 min");
  EXPECT_EQ(read_case(folder.write("short.yaml", content)).output.history_interval, 1.0);
  content.replace(content.find("  time: 1 min"), 13, "  time: 100 d");
  content.replace(content.find("snapshot_interval: 1 min"), 24, "snapshot_interval: 1 d");
  EXPECT_EQ(read_case(folder.write("long.yaml", content)).output.history_interval, 8640.0)
      << "beyond a million seconds";
}

TEST(CaseValues, SuctionAddsNoStrengthUnlessTheCaseSays) {
  const CaseFolder folder;
  std::string content = slope_with("cohesion: 1 kPa\n", "cohesion: 1 kPa\n").content;
  for (const char* key : {"maximum_cohesion_increase", "cohesion_suction_rate", "friction_angle_suction_rate"}) {
    const auto begin = content.rfind('\n', content.find(key)) + 1;
    content.erase(begin, content.find('\n', begin) + 1 - begin);
  }
  const Case input = read_case(folder.write("slope.yaml", content));
  const auto& strength = std::get<solid::DruckerPrager>(input.soils[0].solid.strength);
  EXPECT_EQ(strength.maximum_cohesion_increase, 0.0);
  EXPECT_EQ(strength.cohesion_suction_rate, 0.0);
  EXPECT_EQ(strength.friction_angle_suction_rate, 0.0);
}

TEST(CaseValues, RainComesFromAFileBesideTheCaseOrItsBase) {
  const CaseFolder folder;
  folder.write("storm.csv", "\xEF\xBB\xBF# a storm\ntime_h,intensity_mm_per_h\n0, 36\r\n0.5,0\n");
  const auto base = folder.write("base.yaml", slope_with("at: ground_surface, pressure: 0 kPa, applied_to: particle",
                                                         "at: free_surface, rain: {file: storm.csv}")
                                                  .content);
  const Case input = read_case(base);
  const auto& storm = std::get<Rain>(input.water_boundaries[0].condition);
  ASSERT_EQ(storm.hyetograph.size(), 2u);
  EXPECT_EQ(storm.hyetograph[0].intensity, 1.0e-5);
  EXPECT_EQ(storm.hyetograph[1].time, 1800.0);
  EXPECT_EQ(storm.hyetograph[1].intensity, 0.0);
  const std::string resolved = resolved_yaml(input);
  EXPECT_EQ(resolved_yaml(read_case(folder.write("resolved.yaml", resolved))), resolved) << "stands without the file";

  const auto over = folder.write("over.yaml",
                                 "include: base.yaml\n"
                                 "water_boundaries: [{name: rain, rain: {intensity: 3.6 mm/h}}]\n");
  const Case steady = read_case(over);
  EXPECT_EQ(std::get<Rain>(steady.water_boundaries[0].condition).hyetograph.at(0).intensity, 1.0e-6);
}

}  // namespace
}  // namespace slope::couple::test
