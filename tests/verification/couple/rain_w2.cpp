// Rain of twice the saturated conductivity on a column of the W2 soil, against independent one-dimensional solutions:
// before, at and after ponding.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_case.hpp"
#include "slope/testing/curve.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::testing {
namespace {

struct Figures {
  double ponding = 0.0;   // s
  double pressure = 0.0;  // largest error over the largest pressure of the profile (-)
  double volume = 0.0;    // largest error of the infiltrated water (-)
  couple::WaterBudget water;
};

Figures figures_of(const std::string& skeleton, const std::string& times, const std::string& end) {
  couple::Simulation simulation =
      start_case("rain_w2.yaml", {"coupling.skeleton=" + skeleton, "output.snapshots=" + times, "stop.time=" + end});
  const Table profiles = reference("rain_w2/infiltration_flux_W2_D5_" + skeleton + ".csv");
  const Table history = reference("rain_w2/infiltration_flux_W2_D5_" + skeleton + "_history.csv");
  const Curve cumulative{history.column("t_s"), history.column("cumulative_m")};
  const double width = 0.1;
  Figures figures;
  for (couple::Event event; !event.finished;) {
    event = simulation.advance();
    const couple::WaterBudget water = simulation.summary().water;
    if (figures.ponding == 0.0 && water.run_off > 0.0) figures.ponding = simulation.progress().time;
    if (!event.snapshot) continue;
    const couple::ParticleTable now = simulation.particles();
    Curve pressure;
    for (std::size_t p = 0; p < now.position.size(); ++p) {
      pressure.x.push_back(8.0 - (now.position[p][1] - now.displacement[p][1]));
      pressure.y.push_back(now.pore_pressure[p] / 1000.0);
    }
    const Curve exact{profiles.column("depth_m"), profiles.column("p_kPa_t" + time_text(now.time))};
    figures.pressure = std::max(figures.pressure, max_relative_error(pressure, exact));
    const double volume = interpolate(cumulative, now.time);
    figures.volume = std::max(figures.volume, std::abs(water.infiltration / width - volume) / volume);
  }
  figures.water = simulation.summary().water;
  return figures;
}

void expect_closed_books(const couple::WaterBudget& water) {
  EXPECT_NEAR(water.rain_infiltration + water.run_off, water.rain, 1e-6 * water.rain);
  EXPECT_LT(std::abs(water.infiltration - water.outflow - water.storage), 1e-3 * water.rain);
}

TEST(RainW2, Deformable) {
  const Figures figures = figures_of("deformable", "[100 s, 300 s, 553 s, 800 s, 1200 s]", "2000 s");
  EXPECT_TRUE(record("rain-2-deformable-ponding", "Rain of 2 k on W2, deformable, 2 x 160 particles: ponding (552.8 s)",
                     near(552.8, 0.03 * 552.8), figures.ponding, "s"));
  EXPECT_TRUE(record("rain-2-deformable-pressure", "- pressure, 100 to 2000 s", at_most(0.02), figures.pressure, "%"));
  EXPECT_TRUE(record("rain-2-deformable-volume", "- cumulative infiltration", at_most(0.02), figures.volume, "%"));
  expect_closed_books(figures.water);
}

TEST(RainW2, Rigid) {
  const Figures figures = figures_of("rigid", "[50 s, 100 s, 225 s, 300 s]", "350 s");
  EXPECT_TRUE(record("rain-3-rigid-ponding",
                     "Rain of 2 k on W2, rigid, in the coupled scheme, 2 x 160 particles: ponding (225.2 s)",
                     near(225.2, 0.03 * 225.2), figures.ponding, "s"));
  EXPECT_TRUE(record("rain-3-rigid-pressure", "- pressure, 50 to 350 s", at_most(0.02), figures.pressure, "%"));
  EXPECT_TRUE(record("rain-3-rigid-volume", "- cumulative infiltration", at_most(0.02), figures.volume, "%"));
  expect_closed_books(figures.water);
}

}  // namespace
}  // namespace slope::testing
