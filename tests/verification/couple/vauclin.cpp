// Recharge of a water table by a strip of rain (Vauclin et al. 1979): the shipped case against the measured points and
// an independent solution.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "run_case.hpp"
#include "slope/testing/curve.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::testing {
namespace {

// Height of zero pressure over x: between the particles of each column, from below.
Curve water_table(const couple::ParticleTable& now) {
  std::map<long, std::vector<std::size_t>> columns;
  for (std::size_t p = 0; p < now.position.size(); ++p) columns[std::lround(1.0e6 * now.position[p][0])].push_back(p);
  Curve curve;
  for (auto& [x, column] : columns) {
    std::ranges::sort(column, {}, [&](std::size_t p) { return now.position[p][1]; });
    for (std::size_t k = 0; k + 1 < column.size(); ++k) {
      const double below = now.pore_pressure[column[k]], above = now.pore_pressure[column[k + 1]];
      if (above > 0.0) continue;
      const double low = now.position[column[k]][1], high = now.position[column[k + 1]][1];
      curve.x.push_back(now.position[column[k]][0]);
      curve.y.push_back(low + (high - low) * below / (below - above));
      break;
    }
  }
  return curve;
}

struct Distance {
  double from_measured = 0.0, from_solution = 0.0;  // m
  couple::WaterBudget water;
};

Distance distance_of(const std::vector<std::string>& overrides) {
  const Table measured = reference("vauclin/vauclin1979_water_table.csv");
  const Table solution = reference("vauclin/vauclin_own2d_water_table.csv");
  couple::Simulation simulation = start_shipped_case("rain/vauclin.yaml", overrides);
  Distance distance;
  run(simulation, [&](const couple::ParticleTable& now) {
    const double hours = std::round(now.time / 3600.0);
    const Curve table = water_table(now);
    for (std::size_t i = 0; i < measured.rows(); ++i) {
      if (measured.column("t_h")[i] != hours) continue;
      const double x = std::max(measured.column("x_m")[i], table.x.front());
      distance.from_measured =
          std::max(distance.from_measured, std::abs(interpolate(table, x) - measured.column("height_m")[i]));
    }
    const Curve exact{solution.column("x_m"), solution.column("vgm_" + time_text(hours) + "h")};
    for (std::size_t i = 0; i < table.x.size(); ++i) {
      if (table.x[i] < exact.x.front() || table.x[i] > exact.x.back()) continue;
      distance.from_solution = std::max(distance.from_solution, std::abs(table.y[i] - interpolate(exact, table.x[i])));
    }
  });
  distance.water = simulation.summary().water;
  return distance;
}

TEST(Vauclin, WaterTableRisesAsMeasuredAndAsComputedElsewhere) {
  const Distance fine = distance_of({});
  EXPECT_TRUE(record("vauclin-1",
                     "Vauclin et al. 1979, water table at 2, 3, 4 and 8 h, 60 x 40 particles: from the measured points",
                     at_most(0.05), fine.from_measured, "m"));
  EXPECT_TRUE(record("vauclin-2", "- from an independent solution", at_most(0.03), fine.from_solution, "m"));
  EXPECT_NEAR(fine.water.rain, 0.5 * 0.148 * 8.0, 1e-9) << "14.8 cm/h on half a metre";
  EXPECT_LT(std::abs(fine.water.infiltration - fine.water.outflow - fine.water.storage), 1e-3 * fine.water.rain);
  EXPECT_EQ(fine.water.run_off, 0.0);

  const Distance coarse = distance_of({"domain.cell_size=0.2 m"});
  EXPECT_TRUE(record("vauclin-3", "- error on 30 x 20 over that on 60 x 40 particles", at_least(1.3),
                     coarse.from_solution / fine.from_solution, ""));
}

}  // namespace
}  // namespace slope::testing
