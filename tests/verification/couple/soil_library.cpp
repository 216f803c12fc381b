// Every USDA texture of cases/soils.yaml bears a wet day: from nearly dry to ponding, and drying again.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "run_case.hpp"

namespace slope::testing {
namespace {

class SoilLibrary : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(SoilLibrary, TakesRainAndDries) {
  const auto& [soil, scheme] = GetParam();
  const std::string cases = SLOPE_CASES_DIR;
  couple::Simulation simulation = start_shipped_case(
      "quick.yaml",
      {"soils.silty_sand={from: " + cases + "/soils.yaml, soil: " + soil +
           ", youngs_modulus: 10 MPa, poissons_ratio: 0.33, grain_density: 2.7 g/cm3, strength: {model: elastic}}",
       "initial.water.maximum_suction=30 kPa",
       "water_boundaries=[{name: rain, at: free_surface, rain: {hyetograph: [[0 h, 50 mm/h], [3 h, 0 mm/h], [4 h, -5 "
       "mm/d]]}}, {name: ditch, at: left, to: 0.5 m, total_head: 0.5 m}]",
       "coupling.scheme=" + scheme, "stop={time: 8 h}", "output.history_interval=1 h"});
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::WaterBudget water = simulation.summary().water;
  EXPECT_NEAR(water.rain, 11.0 * 0.15, 1e-9);
  const double conductivity = simulation.input().soils.front().seepage.hydraulic_conductivity;
  const double by_weight_alone = 11.0 * conductivity * 3.0 * 3600.0;
  // the ground before the face, a quarter of the width, fills up and takes no more
  EXPECT_GT(water.rain_infiltration, 0.7 * std::min(by_weight_alone, water.rain));
  EXPECT_NEAR(water.rain_infiltration + water.run_off, water.rain, 1e-9 * water.rain);
  EXPECT_GT(water.evaporation, 0.0);
  EXPECT_LT(std::abs(water.infiltration - water.outflow - water.storage), 1e-4 * water.rain);
}

std::string name_of(const ::testing::TestParamInfo<SoilLibrary::ParamType>& info) {
  return std::get<0>(info.param) + "_" + std::get<1>(info.param);
}

INSTANTIATE_TEST_SUITE_P(Seepage, SoilLibrary,
                         ::testing::Combine(::testing::Values("sand", "loamy_sand", "sandy_loam", "loam", "silt",
                                                              "silt_loam", "sandy_clay_loam", "clay_loam",
                                                              "silty_clay_loam", "sandy_clay", "silty_clay", "clay"),
                                            ::testing::Values("seepage")),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Coupled, SoilLibrary,
                         ::testing::Combine(::testing::Values("sandy_loam", "silt", "clay_loam", "clay"),
                                            ::testing::Values("semi_implicit")),
                         name_of);

}  // namespace
}  // namespace slope::testing
