// Terzaghi's consolidation of a saturated column: the undrained start, then pressure and settlement in time.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "run_case.hpp"
#include "slope/testing/curve.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::testing {
namespace {

constexpr double height = 1.0;              // m
constexpr double load = 10.0e3;             // Pa
constexpr double drain_start = 1.0;         // s
constexpr double unit_weight = 9810.0;      // N/m3
constexpr double early_time_factor = 0.01;  // when the pressure's front has crossed one cell of 2 x 20
const std::vector<double> time_factors{0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0};

struct Figures {
  double undrained = 0.0;  // P / q at mid-height, when the load has just been placed
  double pressure = 0.0;   // largest error over all times
  double settlement = 0.0;
  double step = 0.0;  // how much of the pressure gradient is missing within cells, when the drain has just opened
};

// Pressures act on the soil through their averages over a cell, two rows of particles. 0: the pressure grows as much
// from row to row within the cells as from cell to cell; 1: each cell has one pressure, the profile is a staircase.
double missing_within_cells(std::vector<std::pair<double, double>> depth_and_pressure) {
  std::ranges::sort(depth_and_pressure);
  std::vector<double> rows;
  for (std::size_t p = 0; p + 1 < depth_and_pressure.size(); p += 2) {
    rows.push_back(0.5 * (depth_and_pressure[p].second + depth_and_pressure[p + 1].second));
  }
  double within = 0.0, across = 0.0;
  for (std::size_t r = 2; r + 3 < rows.size(); r += 2) {
    const double slope = 0.125 * (rows[r + 2] + rows[r + 3] - rows[r - 2] - rows[r - 1]);
    within += slope * (rows[r + 1] - rows[r]);
    across += slope * slope;
  }
  return 1.0 - within / across;
}

// Settlement at the depth Z (over the height) since the drain opened, over the final settlement of the top (Terzaghi):
// 1 - Z less the integral of the pressure that is left below.
double settlement_share(double depth, double time_factor) {
  double share = 1.0 - depth;
  for (int k = 0; k < 200; ++k) {
    const double m = std::numbers::pi * (2 * k + 1) / 2.0;
    share -= 2.0 / (m * m) * std::cos(m * depth) * std::exp(-m * m * time_factor);
  }
  return share;
}

Figures run_terzaghi(const std::string& cell_size, const std::string& width) {
  // c_v and the undrained start with the water's own compressibility in (header of terzaghi_profiles.csv)
  const solid::Elastic elastic{10.0e6, 0.33};
  const double modulus = elastic.constrained_modulus();
  const double water_storage = 0.35 / 2.0e9;
  const double consolidation_coefficient = 1.0e-5 / (unit_weight * (1.0 / modulus + water_storage));
  const double start = load / (1.0 + modulus * water_storage);

  std::string times = "output.snapshots=[0.55 s, 0.99 s";
  const auto add_time = [&](double t) {
    times += ", " + std::to_string(drain_start + t * height * height / consolidation_coefficient) + " s";
  };
  add_time(early_time_factor);
  for (const double t : time_factors) add_time(t);
  const std::string right = width + " m";
  couple::Simulation simulation = start_case(
      "terzaghi.yaml", {times + "]", "domain.cell_size=" + cell_size, "domain.upper=[" + right + ", 1.2 m]",
                        "geometry.0.polygon=[[0 m, 0 m], [" + right + ", 0 m], [" + right + ", 1 m], [0 m, 1 m]]"});
  const Table profiles = reference("terzaghi/terzaghi_profiles.csv");
  Figures figures;
  std::vector<double> first_settlement;
  run(simulation, [&](const couple::ParticleTable& now) {
    Curve pressure;
    std::vector<double> settlement;
    // the drain, and with it the water level, settles with the top
    const double level = height + now.displacement.back()[1];
    for (std::size_t p = 0; p < now.position.size(); ++p) {
      const double y = now.position[p][1] - now.displacement[p][1];
      pressure.x.push_back(1.0 - y / height);
      pressure.y.push_back((now.pore_pressure[p] - unit_weight * (level - now.position[p][1])) / start);
      settlement.push_back(-now.displacement[p][1]);
    }
    if (now.time < drain_start) {
      if (now.time < 0.6) figures.undrained = pressure.y[pressure.y.size() / 2] * start / load;
      first_settlement = settlement;
      return;
    }
    const double time_factor = (now.time - drain_start) * consolidation_coefficient / height / height;
    if (std::abs(time_factor - early_time_factor) < 1e-4) {
      std::vector<std::pair<double, double>> points;
      for (std::size_t p = 0; p < pressure.x.size(); ++p) points.emplace_back(pressure.x[p], pressure.y[p]);
      figures.step = missing_within_cells(points);
    }
    const auto listed = std::ranges::find_if(time_factors, [&](double t) { return std::abs(t - time_factor) < 1e-4; });
    if (listed == time_factors.end()) return;
    std::string name = std::to_string(*listed);
    name.erase(name.find_last_not_of('0') + 1);
    if (name.back() == '.') name.pop_back();
    const Curve exact{profiles.column("Z"), profiles.column("p_Tv" + name)};
    figures.pressure = std::max(figures.pressure, max_relative_error(pressure, exact));
    const double final_settlement = start * height / modulus;
    for (std::size_t p = 0; p < settlement.size(); ++p) {
      const double share = (settlement[p] - first_settlement[p]) / final_settlement;
      figures.settlement = std::max(figures.settlement, std::abs(share - settlement_share(pressure.x[p], *listed)) /
                                                            settlement_share(0.0, *listed));
    }
  });
  return figures;
}

TEST(Terzaghi, ConsolidatesAndConverges) {
  const Figures coarse = run_terzaghi("0.1 m", "0.1");
  const Figures fine = run_terzaghi("0.05 m", "0.05");
  EXPECT_TRUE(record("terzaghi-1", "Terzaghi column, 2 x 40 particles: undrained start P/q", near(0.9974, 1.0e-3),
                     fine.undrained, ""));
  EXPECT_TRUE(record("terzaghi-2", "- pressure, T = 0.05 to 1", at_most(0.01), fine.pressure, "%"));
  EXPECT_TRUE(record("terzaghi-3", "- settlement, T = 0.05 to 1", at_most(0.01), fine.settlement, "%"));
  EXPECT_TRUE(record("terzaghi-4", "- pressure error on 2 x 20 over that on 2 x 40 particles", at_least(1.5),
                     coarse.pressure / fine.pressure, ""));
  EXPECT_TRUE(record("terzaghi-5", "- share of the pressure gradient that is missing within cells, T = 0.01, 2 x 20",
                     at_most(0.05), coarse.step, "%"));
  EXPECT_TRUE(record("terzaghi-6", "- the same on 2 x 40 particles", at_most(0.05), fine.step, "%"));
}

}  // namespace
}  // namespace slope::testing
