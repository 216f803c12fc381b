#include "slope/seepage/permeability.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slope/seepage/retention.hpp"

namespace slope::seepage {
namespace {

TEST(HillelPermeability, IsAPowerOfTheSaturation) {
  for (double s = 0.0; s <= 1.0; s += 0.001) {
    EXPECT_DOUBLE_EQ(HillelPower{.exponent = 2.0}.evaluate(0.0, s), s * s);
    EXPECT_DOUBLE_EQ(HillelPower{.exponent = 3.5}.evaluate(0.0, s), std::pow(s, 3.5));
  }
}

TEST(LiakopoulosRelativePermeability, IsThePapersFormula) {
  EXPECT_DOUBLE_EQ(LiakopoulosPermeability{}.evaluate(0.0, 1.0), 1.0);
  for (double s = 0.0; s <= 1.0; s += 0.001) {
    EXPECT_NEAR(LiakopoulosPermeability{}.evaluate(0.0, s), 1.0 - 2.207 * (1.0 - s), 1e-15);
    EXPECT_NEAR((LiakopoulosPermeability{.coefficient = 2.207, .exponent = 1.0121}.evaluate(0.0, s)),
                1.0 - 2.207 * std::pow(1.0 - s, 1.0121), 1e-15);
  }
}

TEST(ExponentialRelativePermeability, FallsByAFactorOfEPerInverseAlpha) {
  const ExponentialPermeability law{.alpha = 0.5};
  EXPECT_EQ(law.evaluate(-1.0, 1.0), 1.0);
  EXPECT_EQ(law.evaluate(0.0, 1.0), 1.0);
  for (double h = 0.01; h < 50.0; h += 0.01) {
    EXPECT_NEAR(law.evaluate(h + 2.0, 1.0) / law.evaluate(h, 1.0), std::exp(-1.0), 1e-12);
  }
}

TEST(VanGenuchtenMualemPermeability, RisesFromZeroToOneOverItsRange) {
  const VanGenuchtenMualem law{.n = 2.0, .range = {0.1, 0.9}};
  EXPECT_EQ(law.evaluate(0.0, 0.1), 0.0);
  EXPECT_EQ(law.evaluate(0.0, 0.05), 0.0);
  EXPECT_EQ(law.evaluate(0.0, 0.9), 1.0);
  double before = 0.0;
  for (double s = 0.1; s < 0.9; s += 0.0005) {
    const double k = law.evaluate(0.0, s);
    EXPECT_GE(k, before);
    before = k;
  }
  // n = 2: k = sqrt(S_e) (1 - sqrt(1 - S_e^2))^2
  EXPECT_NEAR(law.evaluate(0.0, 0.5), std::sqrt(0.5) * std::pow(1.0 - std::sqrt(0.75), 2), 1e-14);
}

TEST(VanGenuchtenMualemPermeability, WithAnAirEntryFallsFromOneThere) {
  const VanGenuchten retention{.alpha = 0.8, .n = 1.09, .range = {}, .air_entry = 0.02};
  const VanGenuchtenMualem law{1.09, {}, retention.entry_saturation()}, plain{1.09, {}};
  const VanGenuchten formula{.alpha = 0.8, .n = 1.09, .range = {}};
  EXPECT_EQ(law.evaluate(0.0, 1.0), 1.0);
  EXPECT_LT(plain.evaluate(0.0, formula.evaluate(0.001).saturation), 0.5) << "without it, after a millimetre";
  // above the air entry both fall alike, save for the square root of S_e
  const auto ratio = [&](double h) {
    const double k = law.evaluate(0.0, retention.evaluate(h).saturation) / std::sqrt(retention.evaluate(h).saturation);
    return k / (plain.evaluate(0.0, formula.evaluate(h).saturation) / std::sqrt(formula.evaluate(h).saturation));
  };
  EXPECT_NEAR(ratio(0.5), ratio(0.05), 1e-9 * ratio(0.5));
}

TEST(RelativePermeabilities, HoldTheirFloorAndAreOneWhenSaturated) {
  for (const RelativePermeability& law :
       {RelativePermeability{HillelPower{}, 1.0e-4}, RelativePermeability{LiakopoulosPermeability{}, 1.0e-4},
        RelativePermeability{ExponentialPermeability{.alpha = 3.0}, 1.0e-4},
        RelativePermeability{VanGenuchtenMualem{.n = 1.5, .range = {}}, 1.0e-4}}) {
    EXPECT_EQ(law.evaluate(0.0, 1.0), 1.0);
    EXPECT_EQ(law.evaluate(100.0, 0.0), 1.0e-4);
    for (double h = 0.0; h < 5.0; h += 0.01) {
      const double k = law.evaluate(h, std::exp(-h));
      EXPECT_GE(k, 1.0e-4);
      EXPECT_LE(k, 1.0);
    }
  }
}

struct Pores {
  Retention retention;
  RelativePermeability permeability;

  [[nodiscard]] Saturation saturation(double suction_head) const {
    return std::visit([&](const auto& law) { return law.evaluate(suction_head); }, retention);
  }
  [[nodiscard]] double at(double suction_head) const {
    return permeability.evaluate(suction_head, saturation(suction_head).saturation);
  }
};

TEST(RelativePermeabilities, HaveTheSlopeOfTheirCurves) {
  const SaturationRange range{0.1, 0.95};
  const VanGenuchten sand{.alpha = 3.0, .n = 2.7, .range = range}, clay{.alpha = 0.8, .n = 1.09, .range = range},
      entry{.alpha = 0.8, .n = 1.09, .range = range, .air_entry = 0.02};
  const double floor = 1.0e-9;
  for (const Pores& pores :
       {Pores{sand, {HillelPower{.exponent = 3.5}, floor}}, Pores{sand, {VanGenuchtenMualem{2.7, range}, floor}},
        Pores{entry, {VanGenuchtenMualem{1.09, range, entry.entry_saturation()}, floor}},
        Pores{clay, {VanGenuchtenMualem{1.09, range}, floor}}, Pores{sand, {ExponentialPermeability{2.0}, floor}},
        Pores{LiakopoulosRetention{}, {LiakopoulosPermeability{}, floor}},
        Pores{LiakopoulosRetention{}, {LiakopoulosPermeability{2.207, 1.0121}, floor}}}) {
    for (double h = 0.05; h < 20.0; h *= 1.01) {
      const double dh = 1.0e-5 * h, k = pores.at(h);
      const double difference = (pores.at(h + dh) - pores.at(h - dh)) / (2.0 * dh);
      if (pores.at(h + dh) <= floor) continue;  // the kink at the floor
      EXPECT_NEAR(pores.permeability.slope(h, pores.saturation(h)), difference, 1e-11 * k / dh - 1e-5 * difference)
          << "suction head " << h << " m, law " << pores.permeability.law.index();
    }
    for (const double h : {0.0, -2.0}) EXPECT_EQ(pores.permeability.slope(h, pores.saturation(h)), 0.0);
    EXPECT_EQ(pores.permeability.slope(1.0e6, {range.residual, 0.0}), 0.0);
  }
  const Pores floored{LiakopoulosRetention{}, {LiakopoulosPermeability{}, 1.0e-4}};
  EXPECT_EQ(floored.permeability.slope(2.2, floored.saturation(2.2)), 0.0) << "at the floor nothing changes";
}

}  // namespace
}  // namespace slope::seepage
