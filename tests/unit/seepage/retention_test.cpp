#include "slope/seepage/retention.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

namespace slope::seepage {
namespace {

struct Curve {
  std::string name;
  Retention law;
  double driest;  // suction head (m) up to which the slope is smooth
};

void PrintTo(const Curve& curve, std::ostream* out) {
  *out << curve.name;
}

class EveryRetention : public ::testing::TestWithParam<Curve> {
 protected:
  [[nodiscard]] static Saturation at(double suction_head) {
    return std::visit([&](const auto& law) { return law.evaluate(suction_head); }, GetParam().law);
  }
};

TEST_P(EveryRetention, SlopeIsTheDerivative) {
  const int states = 4000;
  for (int i = 0; i < states; ++i) {
    const double h = 1.0e-3 * std::pow(GetParam().driest / 1.0e-3, (i + 0.5) / states);
    const double dh = 1.0e-5 * h;
    const double slope = (at(h + dh).saturation - at(h - dh).saturation) / (2.0 * dh);
    // differences of numbers near 1 are good to about 1e-16 / dh
    EXPECT_NEAR(at(h).slope, slope, 1.0e-6 * std::abs(slope) + 1.0e-15 / dh) << "suction head " << h << " m";
  }
}

TEST_P(EveryRetention, FallsFromItsMaximumWithinItsRange) {
  const double wettest = at(0.0).saturation;
  double before = wettest;
  for (double h = 1.0e-4; h < 1.0e6; h *= 1.05) {
    const Saturation s = at(h);
    EXPECT_TRUE(std::isfinite(s.slope));
    EXPECT_LE(s.slope, 0.0);
    EXPECT_LE(s.saturation, before);
    EXPECT_GE(s.saturation, 0.0);
    before = s.saturation;
  }
}

TEST_P(EveryRetention, IsSteepestWhereItSays) {
  const double steepest = std::visit([](const auto& law) { return law.steepest(); }, GetParam().law);
  ASSERT_GT(steepest, 0.0);
  for (double h = 1.0e-3; h < 1.0e4; h *= 1.01) EXPECT_LE(-at(h).slope, -at(steepest).slope * (1.0 + 1.0e-5)) << h;
}

TEST_P(EveryRetention, IsSaturatedBelowTheWaterLevel) {
  for (const double h : {0.0, -1.0e-9, -3.0, -1.0e6}) {
    EXPECT_EQ(at(h).saturation, at(0.0).saturation);
    EXPECT_EQ(at(h).slope, 0.0);
  }
  EXPECT_NEAR(at(1.0e-12).saturation, at(0.0).saturation, 1e-9) << "continuous at zero suction";
}

INSTANTIATE_TEST_SUITE_P(
    Laws, EveryRetention,
    ::testing::Values(Curve{"VanGenuchtenW2", VanGenuchten{.alpha = 0.05, .n = 3.0, .range = {}}, 1.0e3},
                      Curve{"VanGenuchtenClay", VanGenuchten{.alpha = 0.8, .n = 1.09, .range = {0.068, 0.98}}, 1.0e3},
                      Curve{"VanGenuchtenAirEntry",
                            VanGenuchten{.alpha = 0.8, .n = 1.09, .range = {0.068, 0.98}, .air_entry = 0.02}, 1.0e3},
                      Curve{"Liakopoulos", LiakopoulosRetention{}, 2.5},
                      Curve{"LiakopoulosFloor", LiakopoulosRetention{.floor = 0.2}, 2.3},
                      Curve{"Exponential", ExponentialRetention{.alpha = 2.0, .range = {0.15, 1.0}}, 10.0}),
    [](const auto& curve) { return curve.param.name; });

TEST(VanGenuchtenRetention, IsThePapersFormula) {
  const VanGenuchten law{.alpha = 0.074, .n = 3.0, .range = {}};
  const double m = 1.0 - 1.0 / 3.0;
  for (double h = 0.05; h < 60.0; h *= 1.3) {
    const double expected = std::pow(1.0 + std::pow(0.074 * h, 3.0), -m);
    EXPECT_NEAR(law.evaluate(h).saturation, expected, 1e-14);
    const double root = std::pow(expected, 1.0 / m);  // Eq. 9 over n / gamma_w
    EXPECT_NEAR(-law.evaluate(h).slope, 0.074 * 2.0 * root * std::pow(1.0 - root, m), 1e-12);
  }
}

TEST(VanGenuchtenRetention, GivesTheSaturationsOfThePapersCases) {
  // at the crest of the slope, 9 m above the water table: W1, W2, W3
  EXPECT_NEAR((VanGenuchten{.alpha = 0.025, .n = 3.0, .range = {}}).evaluate(9.0).saturation, 0.992, 1e-3);
  EXPECT_NEAR((VanGenuchten{.alpha = 0.05, .n = 3.0, .range = {}}).evaluate(9.0).saturation, 0.944, 1e-3);
  EXPECT_NEAR((VanGenuchten{.alpha = 0.074, .n = 3.0, .range = {}}).evaluate(9.0).saturation, 0.842, 1e-3);
}

TEST(VanGenuchtenRetention, KeepsToItsResidualAndMaximum) {
  const VanGenuchten law{.alpha = 1.0, .n = 2.0, .range = {0.1, 0.9}};
  EXPECT_EQ(law.evaluate(-1.0).saturation, 0.9);
  EXPECT_NEAR(law.evaluate(1.0e9).saturation, 0.1, 1e-8);
  EXPECT_TRUE(std::isfinite(law.evaluate(1.0e300).slope));
}

TEST(VanGenuchtenRetention, StaysWetUpToItsAirEntry) {
  const VanGenuchten plain{.alpha = 0.8, .n = 1.3, .range = {}};
  VanGenuchten law = plain;
  law.air_entry = 0.05;
  EXPECT_EQ(law.evaluate(0.05).saturation, 1.0);
  EXPECT_EQ(law.evaluate(0.05).slope, 0.0);
  EXPECT_NEAR(law.evaluate(0.05 + 1e-9).saturation, 1.0, 1e-8) << "continuous";
  EXPECT_NEAR(law.entry_saturation(), plain.evaluate(0.05).saturation, 1e-14);
  EXPECT_NEAR(law.evaluate(3.0).saturation, plain.evaluate(3.0).saturation / law.entry_saturation(), 1e-14);
  EXPECT_EQ(plain.entry_saturation(), 1.0);
}

TEST(LiakopoulosRetentionCurve, StaysOnItsFloor) {
  const LiakopoulosRetention law{.floor = 0.2};
  EXPECT_NEAR(law.evaluate(1.0).saturation, 1.0 - 0.10152, 1e-15);
  EXPECT_EQ(law.evaluate(2.6).saturation, 0.2);
  EXPECT_EQ(law.evaluate(2.6).slope, 0.0);
}

}  // namespace
}  // namespace slope::seepage
