#include "slope/solid/mohr_coulomb.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "block.hpp"
#include "slope/solid/shear_strength.hpp"

namespace slope::solid {
namespace {

using testing::degree;

constexpr Elastic elastic{.youngs_modulus = 1.0e7, .poissons_ratio = 0.33};

YieldPyramid pyramid_of(double cohesion, double friction_angle, double dilatancy_angle) {
  return SuctionDependentPyramid(MohrCoulomb{.cohesion = cohesion,
                                             .friction_angle = friction_angle * degree,
                                             .dilatancy_angle = dilatancy_angle * degree})
      .at(0.0);
}

// Of a stress, the largest first.
std::array<double, 3> principal(const SymmetricTensor& t) {
  const double centre = 0.5 * (t.xx + t.yy), radius = std::hypot(0.5 * (t.xx - t.yy), t.xy);
  std::array<double, 3> values{centre + radius, centre - radius, t.zz};
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

double size_of(const SymmetricTensor& s) {
  return std::max({std::abs(s.xx), std::abs(s.yy), std::abs(s.zz), std::abs(s.xy)});
}

// Plastic strain: what the return took from the elastic strain.
SymmetricTensor plastic_strain(const SymmetricTensor& trial, const SymmetricTensor& stress) {
  const SymmetricTensor lost{trial.xx - stress.xx, trial.yy - stress.yy, trial.zz - stress.zz, trial.xy - stress.xy};
  const double shear = elastic.shear_modulus(), bulk = elastic.bulk_modulus();
  const SymmetricTensor d = deviator(lost);
  const double mean = trace(lost) / (9.0 * bulk);
  return {d.xx / (2.0 * shear) + mean, d.yy / (2.0 * shear) + mean, d.zz / (2.0 * shear) + mean, d.xy / (2.0 * shear)};
}

double product(const SymmetricTensor& a, const SymmetricTensor& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2.0 * a.xy * b.xy;
}

class AnyTrial {
 public:
  explicit AnyTrial(unsigned seed) : random_(seed) {}
  SymmetricTensor operator()(double scale) {
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    const double mean = scale * part(random_);
    SymmetricTensor trial{mean + scale * part(random_), mean + scale * part(random_), mean + scale * part(random_),
                          scale * part(random_)};
    switch (count_++ % 4) {  // ties among the principal stresses
      case 1:
        trial.xx = trial.yy;
        trial.xy = 0.0;
        break;
      case 2:
        trial.zz = principal(trial)[count_ % 3];
        break;
      default:
        break;
    }
    return trial;
  }

 private:
  std::mt19937 random_;
  int count_ = 0;
};

TEST(MohrCoulombReturn, EndsOnTheSurfaceFromAnywhereOutside) {
  AnyTrial any(11);
  std::array<int, 4> seen{};
  for (int k = 0; k < 40000; ++k) {
    const double phi = k % 41, psi = (k % 3) * 0.5 * phi;
    const YieldPyramid pyramid = pyramid_of(1.0e4 * (k % 5), phi, psi);
    const double scale = 1.0e5;
    const SymmetricTensor trial = any(scale);
    SymmetricTensor stress = trial;
    const Return where = return_to_yield_surface(pyramid, elastic, stress);
    ++seen[static_cast<std::size_t>(where)];
    if (where == Return::elastic) {
      EXPECT_LE(pyramid.value(trial), 0.0);
      EXPECT_EQ(stress.xx, trial.xx);
      EXPECT_EQ(stress.zz, trial.zz);
      EXPECT_EQ(stress.xy, trial.xy);
      continue;
    }
    const double rounding = 1e-11 * (size_of(trial) + size_of(stress));
    EXPECT_GT(pyramid.value(trial), 0.0);
    EXPECT_NEAR(pyramid.value(stress), 0.0, rounding);
    const auto [major, middle, minor] = principal(stress);
    const double tie = where == Return::face   ? 0.0
                       : where == Return::edge ? std::min(major - middle, middle - minor)
                                               : major - minor;
    EXPECT_NEAR(tie, 0.0, rounding);
    // the principal directions stay
    EXPECT_NEAR((trial.xx - trial.yy) * stress.xy - (stress.xx - stress.yy) * trial.xy, 0.0, rounding * scale);
    // a second return finds nothing to do but rounding
    SymmetricTensor again = stress;
    return_to_yield_surface(pyramid, elastic, again);
    EXPECT_NEAR(size_of({again.xx - stress.xx, again.yy - stress.yy, again.zz - stress.zz, again.xy - stress.xy}), 0.0,
                rounding);
  }
  for (const int count : seen) EXPECT_GT(count, 1000);
}

// With psi = phi the returned stress is the closest one in the energy of the elastic strain: no admissible stress does
// more work on the plastic strain.
TEST(MohrCoulombReturn, IsTheClosestPointWithTheAssociatedRule) {
  AnyTrial any(5);
  for (const double phi : {0.0, 15.0, 30.0, 45.0}) {
    const YieldPyramid pyramid = pyramid_of(2.0e4, phi, phi);
    std::array<SymmetricTensor, 60> admissible{};
    for (SymmetricTensor& stress : admissible) {
      stress = any(1.0e5);
      return_to_yield_surface(pyramid, elastic, stress);
    }
    for (int k = 0; k < 2000; ++k) {
      const SymmetricTensor trial = any(1.0e5);
      SymmetricTensor stress = trial;
      if (return_to_yield_surface(pyramid, elastic, stress) == Return::elastic) continue;
      const SymmetricTensor strain = plastic_strain(trial, stress);
      const double work = product(stress, strain);
      for (const SymmetricTensor& other : admissible) {
        EXPECT_LE(product(other, strain), work + 1e-9 * size_of(trial) * size_of(strain));
      }
    }
  }
}

TEST(MohrCoulombReturn, DilatesByTheDilatancyAngle) {
  AnyTrial any(3);
  for (const double psi : {0.0, 8.0, 20.0}) {
    const YieldPyramid pyramid = pyramid_of(5.0e3, 30.0, psi);
    int flows = 0;
    for (int k = 0; k < 4000; ++k) {
      const SymmetricTensor trial = any(1.0e5);
      SymmetricTensor stress = trial;
      const Return where = return_to_yield_surface(pyramid, elastic, stress);
      if (where != Return::face && where != Return::edge) continue;
      ++flows;
      // volume over the sum of the positive parts less the negative ones: sin(psi) on a face, and on an edge too
      const SymmetricTensor strain = plastic_strain(trial, stress);
      const auto values = principal(strain);
      double shearing = 0.0;
      for (const double value : values) shearing += std::abs(value);
      EXPECT_NEAR(trace(strain), std::sin(psi * degree) * shearing, 1e-9 * shearing + 1e-15);
    }
    EXPECT_GT(flows, 1000);
  }
}

TEST(MohrCoulombReturn, AHydrostaticTensionGoesToTheTip) {
  const YieldPyramid pyramid = pyramid_of(1.0e4, 30.0, 0.0);
  SymmetricTensor stress{1.0e5, 1.0e5, 1.0e5, 0.0};
  EXPECT_EQ(return_to_yield_surface(pyramid, elastic, stress), Return::apex);
  const double tip = 1.0e4 / std::tan(30.0 * degree);
  EXPECT_NEAR(stress.xx, tip, 1e-9);
  EXPECT_NEAR(stress.zz, tip, 1e-9);
  const YieldPyramid sand = pyramid_of(0.0, 30.0, 0.0);
  stress = {1.0e3, 2.0e3, 5.0e2, 1.0e2};
  EXPECT_EQ(return_to_yield_surface(sand, elastic, stress), Return::apex);
  EXPECT_EQ(size_of(stress), 0.0);
}

TEST(MohrCoulombReturn, WithoutFrictionIsTresca) {
  const YieldPyramid pyramid = pyramid_of(2.0e4, 0.0, 0.0);
  for (const double mean : {-1.0e6, 0.0, 1.0e6}) {
    SymmetricTensor stress{mean + 5.0e4, mean - 5.0e4, mean, 1.0e4};
    EXPECT_NE(return_to_yield_surface(pyramid, elastic, stress), Return::elastic);
    const auto [major, middle, minor] = principal(stress);
    EXPECT_NEAR(major - minor, 4.0e4, 1e-6);
    EXPECT_NEAR(trace(stress), 3.0 * mean, 1e-6);
  }
  // without any strength a soil bears pressure only
  const YieldPyramid mud = pyramid_of(0.0, 0.0, 0.0);
  SymmetricTensor stress{-3.0e4, -2.0e4, -1.0e4, 3.0e4};
  return_to_yield_surface(mud, elastic, stress);
  EXPECT_NEAR(stress.xx, -2.0e4, 1e-6);
  EXPECT_NEAR(stress.zz, -2.0e4, 1e-6);
  EXPECT_NEAR(stress.xy, 0.0, 1e-6);
}

// Strain in small steps with the stresses of two axes held, until the limit is reached. Axes: 0 and 1 in the plane.
double triaxial_limit(const YieldPyramid& pyramid, double confining, bool compression) {
  const double shear = elastic.shear_modulus(), lame = elastic.bulk_modulus() - 2.0 / 3.0 * shear;
  SymmetricTensor stress{confining, confining, confining, 0.0};
  const double step = compression ? -1.0e-5 : 1.0e-5;
  for (int k = 0; k < 4000; ++k) {
    // both lateral strains are equal, and such that the lateral stress is the confining one
    const auto after = [&](double lateral) {
      const double volumetric = lame * (step + 2.0 * lateral);
      SymmetricTensor trial{stress.xx + volumetric + 2.0 * shear * lateral, stress.yy + volumetric + 2.0 * shear * step,
                            stress.zz + volumetric + 2.0 * shear * lateral, 0.0};
      return_to_yield_surface(pyramid, elastic, trial);
      return trial;
    };
    double low = -5.0e-5, high = 5.0e-5;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (after(middle).xx < confining ? low : high) = middle;
    }
    stress = after(0.5 * (low + high));
    EXPECT_NEAR(stress.xx, confining, 1e-4 * std::abs(confining));
    EXPECT_NEAR(stress.zz, confining, 1e-4 * std::abs(confining));
  }
  return stress.yy;
}

TEST(MohrCoulombLimit, TriaxialCompressionAndExtension) {
  const double c = 5.0e3, confining = -5.0e4;
  for (const double phi : {20.0, 35.0}) {
    const double kp = std::pow(std::tan((45.0 + 0.5 * phi) * degree), 2);
    for (const double psi : {0.0, 10.0}) {
      const YieldPyramid pyramid = pyramid_of(c, phi, psi);
      EXPECT_NEAR(triaxial_limit(pyramid, confining, true), confining * kp - 2.0 * c * std::sqrt(kp), 30.0);
      EXPECT_NEAR(triaxial_limit(pyramid, confining, false), (confining + 2.0 * c * std::sqrt(kp)) / kp, 30.0);
    }
  }
}

TEST(SuctionDependentPyramid, FollowsEquations15And16) {
  MohrCoulomb strength{.cohesion = 1.0e3,
                       .friction_angle = 25.0 * degree,
                       .dilatancy_angle = 5.0 * degree,
                       .maximum_cohesion_increase = 1.0e5,
                       .cohesion_suction_rate = 0.07};
  for (const double rate : {0.0, 5.0 * degree}) {
    strength.friction_angle_suction_rate = rate;
    const SuctionDependentPyramid law(strength);
    for (const double suction : {-1.0e4, 0.0, 1.0e3, 9.0e4, 1.0e6}) {
      const double s = std::max(suction, 0.0) / atmospheric_pressure;
      const double c = 1.0e3 + 1.0e5 * (1.0 - std::exp(-0.07 * s));
      const double phi = std::min(25.0 * degree + rate * s, 90.0 * degree);
      const YieldPyramid now = law.at(suction);
      EXPECT_NEAR(now.sin_friction, std::sin(phi), 1e-14) << suction;
      EXPECT_NEAR(now.c_cos_friction, c * std::cos(phi), 1e-9 * c) << suction;
      EXPECT_NEAR(now.sin_dilatancy, std::sin(5.0 * degree), 1e-15) << suction;
    }
  }
}

// A state in which the soil slides along x: with psi the angle of the flow, the principal stresses lie at 45 degrees -
// psi / 2 to the plane (coaxial flow that neither stretches nor shrinks along it).
TEST(Pyramid, BearsAlongASlipWhatItsMohrCircleHasThere) {
  for (const double dilatancy : {0.0, 10.0, 25.0}) {
    const YieldPyramid pyramid = pyramid_of(5.0e3, 25.0, dilatancy);
    const double normal = -40.0e3, psi = dilatancy * degree;
    const double shear = pyramid.shear_along_slip(normal);
    const double radius = shear / std::cos(psi), along = normal - 2.0 * radius * std::sin(psi);
    // the circle through both stresses, whose top lies psi from the plane's point
    const double centre = 0.5 * (normal + along);
    EXPECT_NEAR(std::hypot(normal - centre, shear), radius, 1.0e-9 * radius);
    EXPECT_NEAR(pyramid.value({along, normal, centre, shear}), 0.0, 1.0e-6 * radius) << dilatancy;
  }
  EXPECT_NEAR(pyramid_of(5.0e3, 25.0, 25.0).shear_along_slip(-40.0e3), 5.0e3 + 40.0e3 * std::tan(25.0 * degree),
              1.0e-6);
  EXPECT_NEAR(pyramid_of(5.0e3, 25.0, 0.0).shear_along_slip(-40.0e3),
              5.0e3 * std::cos(25.0 * degree) + 40.0e3 * std::sin(25.0 * degree), 1.0e-6);
}

}  // namespace
}  // namespace slope::solid
