// Where two soils meet: the table of a soil's conductivity, the mean along a known curve, and the path with a seam.

#include "slope/seepage/seam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "particles.hpp"
#include "slope/seepage/head_operator.hpp"

namespace slope::seepage {
namespace {

using testing::lattice;

Soil van_genuchten(double conductivity, double alpha, double n, double air_entry = 0.0) {
  VanGenuchten retention{.alpha = alpha, .n = n, .range = {.residual = 0.1}, .air_entry = air_entry};
  Soil soil;
  soil.retention = retention;
  soil.relative_permeability = {
      .law = VanGenuchtenMualem{.n = n, .range = retention.range, .entry_saturation = retention.entry_saturation()},
      .floor = 1.0e-30};
  soil.hydraulic_conductivity = conductivity;
  return soil;
}

Soil exponential(double conductivity, double alpha) {
  Soil soil;
  soil.retention = ExponentialRetention{.alpha = alpha, .range = {}};
  soil.relative_permeability = {.law = ExponentialPermeability{.alpha = alpha}, .floor = 1.0e-30};
  soil.hydraulic_conductivity = conductivity;
  return soil;
}

// Carsel and Parrish's sand, loam, silt and clay, a gravel, and two other laws.
std::vector<Soil> soils() {
  std::vector<Soil> all{van_genuchten(8.25e-5, 14.5, 2.68), van_genuchten(2.89e-6, 3.6, 1.56),
                        van_genuchten(6.9e-7, 1.6, 1.37),   van_genuchten(5.6e-7, 0.8, 1.09, 0.02),
                        van_genuchten(1.0e-2, 50.0, 4.0),   exponential(1.0e-5, 10.0)};
  all.push_back(van_genuchten(1.0e-5, 0.05, 3.0));
  all.back().relative_permeability.law = HillelPower{.exponent = 2.0};
  return all;
}

double law_at(const Soil& soil, double pressure_head) {
  const double saturation = evaluate(soil.retention, -pressure_head).saturation;
  return soil.hydraulic_conductivity * soil.relative_permeability.evaluate(-pressure_head, saturation);
}

PotentialAt state_at(const ConductivityCurve& curve, double pressure_head) {
  const ConductivityCurve::Value value = curve.at(pressure_head);
  return {value.conductivity, pressure_head, value.potential};
}

SeamLeg leg_at(const ConductivityCurve& curve, double pressure_head, double share, double drop) {
  return {state_at(curve, pressure_head), &curve, share, share * drop};
}

TEST(ConductivityCurve, IsTheSoilsOwn) {
  for (const Soil& soil : soils()) {
    const ConductivityCurve curve(soil);
    EXPECT_DOUBLE_EQ(curve.at(1.0).conductivity, law_at(soil, 1.0));
    EXPECT_DOUBLE_EQ(curve.at(0.0).conductivity, law_at(soil, 0.0));
    for (double suction = 1.0e-6; suction < 1.0e3; suction *= 1.0173) {
      const double law = law_at(soil, -suction);
      if (law < 1.0e-25 * soil.hydraulic_conductivity) continue;
      EXPECT_NEAR(curve.at(-suction).conductivity, law, 1.0e-4 * law) << suction;
    }
  }
}

TEST(ConductivityCurve, HasItsSlopeAndItsIntegral) {
  for (const Soil& soil : soils()) {
    const ConductivityCurve curve(soil);
    for (double suction = 1.0e-3; suction < 50.0; suction *= 1.0519) {
      if (std::abs(suction - 0.02) < 1.0e-3) continue;  // air enters the clay: a kink
      const double step = 1.0e-5 * suction;
      const auto here = curve.at(-suction), wetter = curve.at(step - suction), drier = curve.at(-suction - step);
      const double slope = (wetter.conductivity - drier.conductivity) / (2.0 * step);
      EXPECT_NEAR(here.slope, slope, 1.0e-3 * slope + 1.0e-8 * here.conductivity / suction) << suction;
      if (here.conductivity < 1.0e-9 * soil.hydraulic_conductivity) continue;
      double integral = 0.0;
      for (int i = 0; i < 200; ++i) integral += curve.at(-suction * (0.9 + 0.2 * (i + 0.5) / 200)).conductivity / 200;
      const double gain = curve.at(-0.9 * suction).potential - curve.at(-1.1 * suction).potential;
      EXPECT_NEAR(gain, 0.2 * suction * integral, 1e-3 * gain) << suction;
    }
    const double saturated = curve.at(0.0).conductivity;
    EXPECT_NEAR(curve.at(2.0).potential - curve.at(0.5).potential, 1.5 * saturated, 1e-12 * saturated);
  }
}

// The exact steady flow from a to b, z down, is K_b z + (K_a - K_b) z / (1 - e^(-alpha z)) over the length.
TEST(KirchhoffMean, IsTheExponentialsInExponentialSoil) {
  const ConductivityCurve curve(exponential(1.0e-5, 10.0));
  for (const double drop : {-0.7, -0.05, 0.0, 0.02, 0.5}) {
    for (const double first : {-0.01, -0.2, -0.5}) {
      for (const double second : {-0.035, -0.4, -1.0}) {
        const PotentialAt a = state_at(curve, first), b = state_at(curve, second);
        const double weight = drop == 0.0 ? 0.1 : drop / -std::expm1(-10.0 * drop);
        const double flow = b.conductivity * drop + (a.conductivity - b.conductivity) * weight;
        const double exact = flow / (first - second + drop);
        EXPECT_NEAR(kirchhoff_mean(a, b, drop), exact, 1e-4 * exact) << drop << " " << first << " " << second;
      }
    }
  }
}

TEST(KirchhoffMean, LevelIsTheIntegralOfTheCurve) {
  for (const Soil& soil : soils()) {
    const ConductivityCurve curve(soil);
    const PotentialAt wet = state_at(curve, 0.1), dry = state_at(curve, -0.7);
    double integral = 0.0;
    constexpr int parts = 200000;
    for (int i = 0; i < parts; ++i) integral += law_at(soil, 0.1 - 0.8 * (i + 0.5) / parts) / parts;
    EXPECT_NEAR(kirchhoff_mean(wet, dry, 0.0), integral, 1e-4 * integral);
    EXPECT_NEAR(kirchhoff_mean(dry, wet, 0.0), integral, 1e-4 * integral);
  }
}

TEST(KirchhoffMean, IsTheSameInBothDirectionsAndBetweenTheEnds) {
  for (const Soil& soil : soils()) {
    const ConductivityCurve curve(soil);
    for (const double drop : {-0.3, 0.0, 0.01, 0.2, 30.0}) {
      for (const double dry : {-0.05, -1.0, -30.0}) {
        const PotentialAt a = state_at(curve, -0.002), b = state_at(curve, dry);
        const double mean = kirchhoff_mean(a, b, drop);
        EXPECT_NEAR(mean, kirchhoff_mean(b, a, -drop), 1e-10 * mean);
        EXPECT_GE(mean, b.conductivity);
        EXPECT_LE(mean, a.conductivity);
      }
    }
  }
}

TEST(KirchhoffMean, HasItsSlope) {
  for (const Soil& soil : soils()) {
    const ConductivityCurve curve(soil);
    for (const double drop : {-0.3, -0.01, 0.0, 0.02, 0.5}) {
      for (const double other : {0.3, -0.03, -0.4, -1.5}) {
        for (double here = -1.2; here < 0.4; here += 0.0917) {
          const PotentialAt b = state_at(curve, other);
          const auto mean = [&](double psi) { return kirchhoff_mean(state_at(curve, psi), b, drop); };
          const ConductivityCurve::Value at_here = curve.at(here);
          if (std::abs(std::log(at_here.conductivity / b.conductivity)) < 0.11) continue;
          const double step = 1e-6, difference = (mean(here + step) - mean(here - step)) / (2.0 * step);
          EXPECT_NEAR(kirchhoff_mean_slope(state_at(curve, here), b, drop, at_here.slope), difference,
                      1e-3 * std::abs(difference) + 1e-5 * mean(here))
              << drop << " " << other << " " << here;
        }
      }
    }
  }
}

TEST(Seam, SaturatedIsTheHarmonicMean) {
  const ConductivityCurve sand(soils()[0]), clay(soils()[3]);
  for (const double share : {0.25, 0.5, 0.75}) {
    for (const double drop : {-0.3, 0.0, 0.3}) {
      const SeamMean mean = seam_mean(leg_at(sand, 2.0, share, drop), leg_at(clay, 1.6, 1.0 - share, -drop), -5.0);
      const double harmonic = 1.0 / (share / sand.saturated() + (1.0 - share) / clay.saturated());
      EXPECT_NEAR(mean.conductivity, harmonic, 1e-12 * harmonic);
    }
  }
}

// Of one soil on both sides it is what it would be without a seam, where the mean is exact.
TEST(Seam, OfOneSoilIsNone) {
  const ConductivityCurve curve(exponential(1.0e-5, 10.0));
  for (const double drop : {-0.2, 0.0, 0.3}) {
    for (const double share : {0.2, 0.6}) {
      const PotentialAt a = state_at(curve, -0.1), b = state_at(curve, -0.7);
      const double whole = kirchhoff_mean(a, b, drop);
      const SeamMean mean = seam_mean(leg_at(curve, -0.1, share, drop), leg_at(curve, -0.7, 1.0 - share, -drop), 0.0);
      EXPECT_NEAR(mean.conductivity, whole, 1e-3 * whole) << drop << " " << share;
    }
  }
}

TEST(Seam, IsTheSameFromBothSidesAndFromAnyGuess) {
  const std::vector<Soil> all = soils();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> head(-2.0, 0.5), part(0.2, 0.8), rise(-0.4, 0.4);
  for (int trial = 0; trial < 400; ++trial) {
    const ConductivityCurve first(all[random() % all.size()]), second(all[random() % all.size()]);
    const double share = part(random), drop = rise(random);
    const SeamLeg a = leg_at(first, head(random), share, drop), b = leg_at(second, head(random), 1.0 - share, -drop);
    const SeamMean mean = seam_mean(a, b, 0.0), back = seam_mean(b, a, -1.0);
    EXPECT_NEAR(mean.conductivity, back.conductivity, 1e-6 * mean.conductivity) << trial;
    EXPECT_NEAR(mean.first_reach, 1.0 - back.first_reach, 1e-4) << trial;
  }
}

// Also through saturation and where the flow turns.
TEST(Seam, ChangesSteadilyWithItsSlope) {
  const std::vector<Soil> all = soils();
  for (const auto& [i, j] :
       {std::array{0, 3}, std::array{3, 0}, std::array{4, 1}, std::array{1, 4}, std::array{2, 0}}) {
    const ConductivityCurve first(all[i]), second(all[j]);
    for (const double drop : {-0.1, 0.0, 0.15}) {
      for (const double other : {0.2, -0.02, -0.5}) {
        const SeamLeg b = leg_at(second, other, 0.5, -drop);
        const auto flow = [&](double psi, double guess) {
          return seam_mean(leg_at(first, psi, 0.5, drop), b, guess).conductivity * (psi + drop - other);
        };
        double guess = -0.8;
        for (double psi = -0.8; psi < 0.3; psi += 0.00137) {
          const SeamLeg a = leg_at(first, psi, 0.5, drop);
          const SeamMean mean = seam_mean(a, b, guess);
          guess = mean.pressure_head;
          const double step = 1e-5;
          const double before = flow(psi - step, guess), after = flow(psi + step, guess);
          const double slope = seam_flow_slope(a, mean.pressure_head, mean.first_reach, first.at(psi).slope);
          // the curves bend sharply, and ends that are equal to 1e-6 count as equal
          EXPECT_NEAR((after - before) / (2.0 * step), slope, 0.25 * std::abs(slope) + 0.3 * mean.conductivity)
              << i << " " << j << " " << drop << " " << other << " " << psi;
        }
      }
    }
  }
}

// Layers whose heads are linear in each, under the flow that this drives through all of them in series.
class LayeredBlock : public ::testing::TestWithParam<int> {};

TEST_P(LayeredBlock, ConductsInSeriesExactly) {
  const int rows = GetParam();  // in the seam
  constexpr int side = 8;
  const double spacing = 0.1;
  for (const double contrast : {1.0e-6, 0.05, 2.0, 1.0e6}) {
    const std::array layers{exponential(1.0e-5, 5.0), exponential(1.0e-5 / contrast, 9.0)};
    const auto block = lattice(6, 2 * side + rows, spacing);
    std::vector<std::uint16_t> soil;
    std::vector<double> head;
    std::vector<PotentialAt> at;
    const std::array curves{ConductivityCurve(layers[0]), ConductivityCurve(layers[1])};
    const double bottom = spacing * side, top = spacing * (side + rows);
    const auto resistance = [&](double y) {
      const double inside = std::clamp(y, bottom, top) - bottom;
      return (y - inside) / 1.0e-5 + inside * contrast / 1.0e-5;
    };
    const double flux = 1.0 / resistance(spacing * (2 * side + rows));
    for (std::size_t p = 0; p < block.size(); ++p) {
      soil.push_back(block.y[p] > bottom && block.y[p] < top ? 1 : 0);
      head.push_back(10.0 + flux * resistance(block.y[p]));
      const double pressure_head = head[p] - block.y[p];
      at.push_back({layers[soil[p]].hydraulic_conductivity, pressure_head, curves[soil[p]].potential(pressure_head)});
    }
    HeadOperator op(spacing, 1.2, {.left = 0.0, .right = 6 * spacing, .base = 0.0, .top = (2 * side + rows) * spacing},
                    1);
    op.set_soils(soil, {curves[0], curves[1]});
    op.update(block.skeleton());
    for (std::size_t p = 0; p < block.size(); ++p) op.set_conductivity(p, at[p]);
    op.find_conductances();
    for (int line = side - 2; line <= side + rows + 2; ++line) {
      double flow = 0.0;
      for (std::size_t p = 0; p < block.size(); ++p) {
        if (block.y[p] > line * spacing) continue;
        const auto row = op.neighbours().of(p);
        for (std::size_t s = 0; s < row.size(); ++s) {
          if (block.y[row[s]] > line * spacing) {
            flow += op.conductance()[op.neighbours().start[p] + s] * (head[row[s]] - head[p]);
          }
        }
      }
      EXPECT_NEAR(flow / (6 * spacing * flux), 1.0, 2e-3) << rows << " rows, " << contrast << ", line " << line;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, LayeredBlock, ::testing::Values(2, 3, 4, 8));

}  // namespace
}  // namespace slope::seepage
