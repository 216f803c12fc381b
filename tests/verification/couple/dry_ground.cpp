// Rain on dry ground and evaporation from it on cells as large as a slope's. The right values are those of independent
// finite-volume solutions of Richards' equation on cells of a centimetre and less.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

struct Ground {
  const char* soil;      // of cases/soils.yaml
  const char* height;    // m
  const char* pressure;  // at the start (kPa)
  const char* rain;
  const char* time;
  double right;  // infiltrated or evaporated (m)
};

const Ground sand{"sand", "3", "-9.81", "{intensity: 600 mm/h}", "1800 s", 0.1683};
const Ground silt_loam{"silt_loam", "3", "-19.62", "{intensity: 15 mm/h}", "43200 s", 0.0632};
const Ground dry_loam{"loam", "2", "-150", "{intensity: 60 mm/h}", "2 h", 0.0366};

// 20 mm of rain in 4 h every 8 days, in between 5 mm/d down to 1000 kPa.
constexpr const char* showers =
    "{hyetograph: [[0 d, 5 mm/h], [4 h, -5 mm/d], [8 d, 5 mm/h], [196 h, -5 mm/d], [16 d, 5 mm/h], [388 h, -5 mm/d], "
    "[24 d, 5 mm/h], [580 h, -5 mm/d], [32 d, 5 mm/h], [772 h, -5 mm/d]], evaporation_limit: 1000 kPa}";
const Ground drying_sand{"sand", "2", "-3.924", showers, "40 d", 0.018};
const Ground drying_silt_loam{"silt_loam", "2", "-29.43", showers, "40 d", 0.0845};

// On cells of a size (m), two of which are as wide as the column.
couple::WaterBudget water_of(const Ground& ground, double cell, const std::vector<std::string>& overrides = {}) {
  const std::string width = std::to_string(2.0 * cell), height = ground.height;
  const double top = cell * (std::round(std::stod(height) / cell) + 1.0);
  std::vector<std::string> all{
      std::string("soils.ground={from: ") + SLOPE_CASES_DIR + "/soils.yaml, soil: " + ground.soil +
          ", youngs_modulus: 20 MPa, poissons_ratio: 0.3, grain_density: 2650 kg/m3, strength: {model: elastic}}",
      "domain.cell_size=" + std::to_string(cell) + " m",
      "domain.upper=[" + width + " m, " + std::to_string(top) + " m]",
      "geometry=[{soil: ground, polygon: [[0 m, 0 m], [" + width + " m, 0 m], [" + width + " m, " + height +
          " m], [0 m, " + height + " m]]}]",
      std::string("initial.water.pressure=") + ground.pressure + " kPa",
      std::string("water_boundaries.0.rain=") + ground.rain,
      std::string("stop.time=") + ground.time,
      std::string("output.history_interval=") + (ground.rain == showers ? "1 d" : "90 s")};
  all.insert(all.end(), overrides.begin(), overrides.end());
  couple::Simulation simulation = start_case("dry_ground.yaml", all);
  run(simulation, [](const couple::ParticleTable&) {});
  couple::WaterBudget water = simulation.summary().water;
  water.rain_infiltration /= 2.0 * cell;
  water.evaporation /= 2.0 * cell;
  return water;
}

// The furthest off the right value, of the three.
double infiltration_error(double cell, const std::vector<std::string>& overrides = {}) {
  double worst = 0.0;
  for (const Ground& ground : {sand, silt_loam, dry_loam}) {
    worst = std::max(worst, std::abs(water_of(ground, cell, overrides).rain_infiltration / ground.right - 1.0));
  }
  return worst;
}

TEST(DryGround, TakesInWhatFineGridsSay) {
  EXPECT_TRUE(record("dry-ground-1",
                     "Rain above k on sand, silt loam and dry loam: infiltration off finite volumes, cells of 0.5 m",
                     at_most(0.08), infiltration_error(0.5), "%"));
  EXPECT_TRUE(record("dry-ground-2", "- cells of 0.25 m", at_most(0.05), infiltration_error(0.25), "%"));
  EXPECT_TRUE(record("dry-ground-3", "- cells of 0.1 m", at_most(0.03), infiltration_error(0.1), "%"));
}

TEST(DryGround, TakesInTheSameInTheCoupledScheme) {
  EXPECT_TRUE(record("dry-ground-4", "- cells of 0.5 m, coupled with stiff soil", at_most(0.08),
                     infiltration_error(0.5, {"coupling.scheme=semi_implicit", "soils.ground.youngs_modulus=2 GPa"}),
                     "%"));
}

TEST(DryGround, Evaporates) {
  const auto error = [](const Ground& ground, double cell) {
    return std::abs(water_of(ground, cell).evaporation / ground.right - 1.0);
  };
  EXPECT_TRUE(record("evaporation-1", "Showers and drying of sand, 40 days: evaporation off 0.018 m, cells of 0.02 m",
                     at_most(0.15), error(drying_sand, 0.02), "%"));
  EXPECT_TRUE(record("evaporation-2", "- cells of 0.1 m", at_most(0.4), error(drying_sand, 0.1), "%"));
  EXPECT_TRUE(record("evaporation-3", "- silt loam, off 0.0845 m, cells of 0.02 m", at_most(0.03),
                     error(drying_silt_loam, 0.02), "%"));
  EXPECT_TRUE(record("evaporation-4", "- cells of 0.1 m", at_most(0.08), error(drying_silt_loam, 0.1), "%"));
}

}  // namespace
}  // namespace slope::testing
