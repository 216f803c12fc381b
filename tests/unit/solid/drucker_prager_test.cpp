#include "slope/solid/drucker_prager.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "block.hpp"

namespace slope::solid {
namespace {

using testing::degree;
using testing::table_2_strength;

constexpr Elastic elastic{.youngs_modulus = 1.0e7, .poissons_ratio = 0.33};

double size_of(const SymmetricTensor& s) {
  return std::max({std::abs(s.xx), std::abs(s.yy), std::abs(s.zz), std::abs(s.xy)});
}

TEST(ReturnMapping, EndsOnTheSurfaceFromAnywhereOutside) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> stress_part(-1.0, 1.0);
  int on_cone = 0, on_apex = 0, inside = 0;
  for (int k = 0; k < 20000; ++k) {
    DruckerPrager strength = table_2_strength();
    strength.friction_angle = (k % 40) * degree;
    strength.dilatancy_angle = (k % 3) * 0.5 * strength.friction_angle;
    strength.cohesion = 1.0e4 * (k % 5);
    const YieldCone cone = SuctionDependentCone(strength).at(0.0);
    const double scale = 1.0e5;
    const double mean = scale * stress_part(random);
    const SymmetricTensor trial{mean + scale * stress_part(random), mean + scale * stress_part(random),
                                mean + scale * stress_part(random), scale * stress_part(random)};
    SymmetricTensor stress = trial;
    switch (return_to_yield_surface(cone, elastic, stress)) {
      case Return::elastic:
        ++inside;
        EXPECT_LE(cone.value(trial), 1e-12 * scale);
        EXPECT_EQ(stress.xx, trial.xx);
        EXPECT_EQ(stress.xy, trial.xy);
        break;
      case Return::edge:
        FAIL() << "a cone has no edge";
      case Return::apex:
        ++on_apex;
        EXPECT_NEAR(std::sqrt(second_invariant(stress)), 0.0, 1e-15 * scale);
        [[fallthrough]];
      case Return::face:
        ++on_cone;
        EXPECT_GT(cone.value(trial), 0.0);
        EXPECT_NEAR(cone.value(stress), 0.0, 1e-12 * (size_of(trial) + size_of(stress)));
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(on_apex, 1000);
  EXPECT_GT(on_cone - on_apex, 1000);
}

TEST(ReturnMapping, FollowsTheFlowDirection) {
  DruckerPrager strength = table_2_strength();
  for (const double dilatancy : {0.0, 10.0, 25.0}) {
    strength.dilatancy_angle = dilatancy * degree;
    const YieldCone cone = SuctionDependentCone(strength).at(0.0);
    const SymmetricTensor trial{-2.0e5, -5.0e4, -9.0e4, 6.0e4};
    SymmetricTensor stress = trial;
    ASSERT_EQ(return_to_yield_surface(cone, elastic, stress), Return::face);
    // plastic strain = multiplier (s / (2 sqrt(J_2)) + eta(psi) I): its volume over its shear tells the direction
    const SymmetricTensor s = deviator(trial), t = deviator(stress);
    const double multiplier =
        (std::sqrt(second_invariant(trial)) - std::sqrt(second_invariant(stress))) / elastic.shear_modulus();
    const double volume = (trace(trial) - trace(stress)) / (3.0 * elastic.bulk_modulus());
    EXPECT_NEAR(volume, 3.0 * cone.eta_potential * multiplier, 1e-12);
    EXPECT_NEAR(t.xx * s.xy, t.xy * s.xx, 1e-3);
    EXPECT_NEAR(t.yy * s.xy, t.xy * s.yy, 1e-3);
    EXPECT_EQ(dilatancy == 0.0, std::abs(volume) < 1e-15);
  }
}

TEST(ReturnMapping, WithoutFrictionIsVonMises) {
  const YieldCone cone = SuctionDependentCone({.cohesion = 2.0e4}).at(0.0);
  EXPECT_EQ(cone.eta, 0.0);
  EXPECT_DOUBLE_EQ(cone.xi_c, 2.0e4);
  for (const double mean : {-1.0e6, 0.0, 1.0e6}) {
    SymmetricTensor stress{mean + 5.0e4, mean - 5.0e4, mean, 1.0e4};
    EXPECT_EQ(return_to_yield_surface(cone, elastic, stress), Return::face);
    EXPECT_NEAR(std::sqrt(second_invariant(stress)), 2.0e4, 1e-6);
    EXPECT_NEAR(trace(stress), 3.0 * mean, 1e-6);
  }
}

TEST(ReturnMapping, ASoilWithoutAnyStrengthBearsPressureOnly) {
  const YieldCone cone = SuctionDependentCone(DruckerPrager{}).at(0.0);
  for (int k = 1; k < 100; ++k) {
    SymmetricTensor stress{-1.0e5 * k / 3.0, -2.0e4 * k, -1.0e4 * k / 7.0, 3.0e4};
    const double pressure = trace(stress) / 3.0;
    return_to_yield_surface(cone, elastic, stress);
    EXPECT_NEAR(stress.xx, pressure, 1e-9 * std::abs(pressure));
    EXPECT_NEAR(stress.xy, 0.0, 1e-9);
  }
}

TEST(ReturnMapping, WithoutCohesionTensionGoesToTheOrigin) {
  const YieldCone cone = SuctionDependentCone({.friction_angle = 30.0 * degree}).at(0.0);
  SymmetricTensor stress{1.0e3, 2.0e3, 5.0e2, 1.0e2};
  EXPECT_EQ(return_to_yield_surface(cone, elastic, stress), Return::apex);
  EXPECT_EQ(size_of(stress), 0.0);
}

// Plane strain with the associated rule (Eqs. 13, 14): the cone meets Mohr-Coulomb where the plastic strain has no zz
// part, s_zz / (2 sqrt(J_2)) + eta = 0.
TEST(YieldCone, MeetsMohrCoulombInAssociatedPlaneStrain) {
  const double phi = 25.0 * degree, c = 1.0e3, minor = 5.0e4;
  const double major =
      minor * (1.0 + std::sin(phi)) / (1.0 - std::sin(phi)) + 2.0 * c * std::cos(phi) / (1.0 - std::sin(phi));
  const YieldCone cone = SuctionDependentCone(table_2_strength()).at(0.0);
  double low = minor, high = major;  // of -sigma_zz, by bisection
  for (int k = 0; k < 100; ++k) {
    const double zz = 0.5 * (low + high);
    const SymmetricTensor stress{-major, -minor, -zz, 0.0};
    const double flow = deviator(stress).zz / (2.0 * std::sqrt(second_invariant(stress))) + cone.eta;
    (flow > 0.0 ? low : high) = zz;
  }
  EXPECT_NEAR(cone.value({-major, -minor, -low, 0.0}), 0.0, 1e-8 * major);
}

TEST(SuctionDependentCone, CohesionFollowsEquation15) {
  const DruckerPrager strength = table_2_strength();
  const SuctionDependentCone law(strength);
  const double t = std::tan(25.0 * degree);
  const double xi = 3.0 / std::sqrt(9.0 + 12.0 * t * t);
  for (const double suction : {0.0, 1.0e3, 9.0e4, 1.0e6}) {
    const double c = 1.0e3 + 1.0e5 * (1.0 - std::exp(-0.07 * suction / 101325.0));
    EXPECT_NEAR(law.at(suction).xi_c, xi * c, 1e-9 * c) << suction;
    EXPECT_NEAR(law.at(suction).eta, t / std::sqrt(9.0 + 12.0 * t * t), 1e-15) << suction;
  }
}

TEST(SuctionDependentCone, FrictionFollowsEquation16) {
  DruckerPrager strength = table_2_strength();
  strength.friction_angle_suction_rate = 5.0 * degree;
  const SuctionDependentCone law(strength);
  const double suction = 0.5 * 101325.0;
  const double t = std::tan(27.5 * degree);
  const double c = 1.0e3 + 1.0e5 * (1.0 - std::exp(-0.035));
  EXPECT_NEAR(law.at(suction).eta, t / std::sqrt(9.0 + 12.0 * t * t), 1e-15);
  EXPECT_NEAR(law.at(suction).xi_c, 3.0 / std::sqrt(9.0 + 12.0 * t * t) * c, 1e-9 * c);
  // no friction angle exceeds a right one
  EXPECT_NEAR(law.at(1.0e8).eta, 1.0 / std::sqrt(12.0), 1e-15);
  EXPECT_NEAR(law.at(1.0e8).xi_c, 0.0, 1e-6);
}

TEST(SuctionDependentCone, SuctionBelowZeroCountsAsZero) {
  DruckerPrager strength = table_2_strength();
  strength.friction_angle_suction_rate = 5.0 * degree;
  const SuctionDependentCone law(strength);
  EXPECT_EQ(law.at(-5.0e4).xi_c, law.at(0.0).xi_c);
  EXPECT_EQ(law.at(-5.0e4).eta, law.at(0.0).eta);
  EXPECT_NEAR(law.at(1.0).xi_c, law.at(0.0).xi_c, 0.1);
}

TEST(Cone, BearsAlongASlipWhatItsYieldFunctionLeaves) {
  DruckerPrager strength = table_2_strength();
  strength.cohesion = 5.0e3;
  constexpr double normal = -40.0e3;
  const YieldCone isochoric = SuctionDependentCone(strength).at(0.0);
  const double shear = isochoric.shear_along_slip(normal);
  EXPECT_NEAR(isochoric.value({normal, normal, normal, shear}), 0.0, 1.0e-9 * shear);

  strength.dilatancy_angle = strength.friction_angle;  // associated flow: the match is Mohr-Coulomb itself
  const YieldCone associated = SuctionDependentCone(strength).at(0.0);
  EXPECT_NEAR(associated.shear_along_slip(normal), 5.0e3 - normal * std::tan(strength.friction_angle), 1.0e-6);
}

}  // namespace
}  // namespace slope::solid
