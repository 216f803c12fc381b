// Consolidation under a strip load, against an independent finite element solution.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_case.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::testing {
namespace {

constexpr double unit_weight = 9810.0;  // N/m3
constexpr double layer = 2.0;           // m
constexpr double node_spacing = 0.1;    // m, of the reference
constexpr std::size_t node_columns = 41;
constexpr std::size_t node_rows = 21;

double bilinear(const std::vector<double>& nodes, double x, double y) {
  const auto i = std::min(static_cast<std::size_t>(x / node_spacing), node_columns - 2);
  const auto j = std::min(static_cast<std::size_t>(y / node_spacing), node_rows - 2);
  const double a = x / node_spacing - static_cast<double>(i), b = y / node_spacing - static_cast<double>(j);
  const double* low = &nodes[j * node_columns + i];
  const double* high = low + node_columns;
  return (1.0 - b) * ((1.0 - a) * low[0] + a * low[1]) + b * ((1.0 - a) * high[0] + a * high[1]);
}

// Largest error of the excess pore pressure over the largest of the reference, at 2, 4 and 8 s.
double error_on(const std::string& cell_size) {
  couple::Simulation simulation = start_case("strip_load.yaml", {"domain.cell_size=" + cell_size});
  const Table reference_field = reference("strip_load/strip_load.csv");
  double largest = 0.0;
  run(simulation, [&](const couple::ParticleTable& now) {
    const std::vector<double>& nodes = reference_field.column("p_t" + time_text(now.time));
    const double scale = *std::ranges::max_element(nodes);
    for (std::size_t p = 0; p < now.position.size(); ++p) {
      const double x = now.position[p][0] - now.displacement[p][0], y = now.position[p][1] - now.displacement[p][1];
      const double excess = now.pore_pressure[p] - unit_weight * (layer - y);
      largest = std::max(largest, std::abs(excess - bilinear(nodes, x, y)) / scale);
    }
  });
  return largest;
}

TEST(StripLoad, ConsolidatesAndConverges) {
  const double coarse = error_on("0.2 m"), fine = error_on("0.1 m");
  EXPECT_TRUE(record("strip-load-1", "Strip load on a layer, 80 x 40 particles: excess pore pressure", at_most(0.03),
                     fine, "%"));
  EXPECT_TRUE(
      record("strip-load-2", "- error on 40 x 20 over that on 80 x 40 particles", at_least(1.5), coarse / fine, ""));
}

}  // namespace
}  // namespace slope::testing
