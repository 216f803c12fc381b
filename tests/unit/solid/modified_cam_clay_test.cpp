// Modified Cam-clay against the closed forms of Wood (1990, chapter 5) and Roscoe and Burland (1968). The numbers are
// about those of London clay.

#include "slope/solid/modified_cam_clay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "block.hpp"

namespace slope::solid {
namespace {

constexpr double M = 0.888, lambda = 0.161, kappa = 0.062, nu = 0.3, first_v = 2.1;
constexpr double plastic_share = (lambda - kappa) / lambda;  // Wood's Lambda
constexpr double p_0 = 100.0e3;

ModifiedCamClay clay(double overconsolidation_ratio = 1.0) {
  return {.critical_state_ratio = M,
          .lambda = lambda,
          .kappa = kappa,
          .minimum_mean_stress = 1.0e3,
          .overconsolidation_ratio = overconsolidation_ratio};
}

double p_of(const SymmetricTensor& stress) {
  return -trace(stress) / 3.0;
}

double q_of(const SymmetricTensor& stress) {
  return std::sqrt(3.0 * second_invariant(stress));
}

SymmetricTensor pressure(double p) {
  return {-p, -p, -p, 0.0};
}

/// Triaxial strain: axial along y, positive in compression.
SymmetricTensor triaxial(double axial, double radial) {
  return {-radial, -axial, -radial, 0.0};
}

struct Sample {
  HardeningEllipse law;
  double v = first_v;
  SymmetricTensor stress;
  double p_c = 0.0, plastic_strain = 0.0;

  Sample(const ModifiedCamClay& strength, const SymmetricTensor& found) : law(strength, nu), stress(found) {
    law.initial(stress, {&p_c, 1});
  }
  explicit Sample(double overconsolidation_ratio) : Sample(clay(overconsolidation_ratio), pressure(p_0)) {}

  void strain(const SymmetricTensor& increment, bool yields = true) {
    plastic_strain += law.update({increment, 0.0, v, yields}, {&p_c, 1}, stress);
    v *= 1.0 + trace(increment);
  }
  [[nodiscard]] double f() const { return law.value(stress, {&p_c, 1}); }
};

/// Axial strain at a constant radial stress.
void strain_drained(Sample& sample, double axial) {
  double low = -2.0 * std::abs(axial), high = -low;  // of the radial strain; more of it is more radial pressure
  const double wanted = sample.stress.xx;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    Sample tried = sample;
    tried.strain(triaxial(axial, middle));
    (tried.stress.xx > wanted ? low : high) = middle;
  }
  sample.strain(triaxial(axial, low));
}

TEST(ModifiedCamClay, SwellsAndIsCompressedAlongItsLines) {
  Sample sample(1.0);
  const double step = 1.0e-4;
  double worst = 0.0;
  const auto compare = [&](double expected) {
    worst = std::max(worst, std::abs(p_of(sample.stress) / expected - 1.0));
  };
  while (p_of(sample.stress) < 4.0 * p_0) {
    sample.strain(triaxial(step, step));
    compare(p_0 * std::exp((first_v - sample.v) / lambda));
  }
  const double top = p_of(sample.stress), dense = sample.v;
  EXPECT_NEAR(sample.p_c, top, 1e-9 * top);
  while (p_of(sample.stress) > 2.0 * p_0) {
    sample.strain(triaxial(-step, -step));
    compare(top * std::exp((dense - sample.v) / kappa));
  }
  EXPECT_NEAR(sample.p_c, top, 1e-9 * top) << "unloading changes no memory";
  while (p_of(sample.stress) < 0.99 * top) {
    sample.strain(triaxial(step, step));
    compare(top * std::exp((dense - sample.v) / kappa));
  }
  while (p_of(sample.stress) < 8.0 * p_0) sample.strain(triaxial(step, step));
  compare(p_0 * std::exp((first_v - sample.v) / lambda));
  RecordProperty("largest_error", std::to_string(worst));
  EXPECT_LT(worst, 1e-8);
}

// Wood (1990), section 5.4: at constant volume p'/p'_y = ((M^2 + eta_y^2) / (M^2 + eta^2))^Lambda from the first yield
// on, where p'_y = p'_0 and eta_y = M sqrt(n - 1) for soil that was consolidated to n p'_0.
void expect_undrained_path(double n, double axial_step) {
  Sample sample(n);
  const double eta_y = M * std::sqrt(n - 1.0);
  double worst = 0.0;
  for (double axial = 0.0; axial < 0.3; axial += axial_step) {
    sample.strain(triaxial(axial_step, -0.5 * axial_step));
    const double p = p_of(sample.stress), eta = q_of(sample.stress) / p;
    if (sample.plastic_strain == 0.0) {
      EXPECT_NEAR(p, p_0, 1e-9 * p_0) << "elastic, isotropic";
      continue;
    }
    const double expected = p_0 * std::pow((M * M + eta_y * eta_y) / (M * M + eta * eta), plastic_share);
    worst = std::max(worst, std::abs(p / expected - 1.0));
  }
  const double last = p_0 * std::pow(0.5 * n, plastic_share);
  ::testing::Test::RecordProperty("largest_error", std::to_string(worst));
  EXPECT_LT(worst, 0.01) << "the path, at an overconsolidation ratio of " << n;
  EXPECT_NEAR(p_of(sample.stress), last, 0.01 * last) << "critical state, n = " << n;
  EXPECT_NEAR(q_of(sample.stress), M * last, 0.01 * M * last) << "critical state, n = " << n;
  EXPECT_EQ(sample.p_c > n * p_0, n < 2.0) << "wet soil hardens, dry soil softens";
}

TEST(ModifiedCamClay, FollowsTheUndrainedPathNormallyConsolidated) {
  expect_undrained_path(1.0, 1.0e-4);
}

TEST(ModifiedCamClay, FollowsTheUndrainedPathLightlyOverconsolidated) {
  expect_undrained_path(1.5, 1.0e-4);
}

TEST(ModifiedCamClay, FollowsTheUndrainedPathHeavilyOverconsolidated) {
  expect_undrained_path(6.0, 1.0e-4);
}

// The shear strain of that path, by integration of the flow rule and of the elastic law from eta = 0:
// plastic kappa Lambda / (v M) (ln((M + eta) / (M - eta)) - 2 atan(eta / M)) (Wood 1990, section 5.4), elastic
// kappa / (3 r v) (eta (1 - 2 Lambda) + 2 Lambda M atan(eta / M)), r = G / K.
TEST(ModifiedCamClay, NeedsTheShearStrainOfTheClosedForm) {
  Sample sample(1.0);
  const double r = 1.5 * (1.0 - 2.0 * nu) / (1.0 + nu), step = 2.0e-5;
  double worst = 0.0;
  for (double axial = step; axial < 0.06; axial += step) {
    sample.strain(triaxial(step, -0.5 * step));
    if (axial < 0.002) continue;
    const double eta = q_of(sample.stress) / p_of(sample.stress);
    const double plastic =
        kappa * plastic_share / (first_v * M) * (std::log((M + eta) / (M - eta)) - 2.0 * std::atan(eta / M));
    const double elastic = kappa / (3.0 * r * first_v) *
                           (eta * (1.0 - 2.0 * plastic_share) + 2.0 * plastic_share * M * std::atan(eta / M));
    worst = std::max(worst, std::abs((plastic + elastic) / axial - 1.0));
    EXPECT_NEAR(sample.plastic_strain, plastic, 0.01 * (plastic + elastic));
  }
  RecordProperty("largest_error", std::to_string(worst));
  EXPECT_LT(worst, 0.01);
}

// Drained, v = v_0 - lambda ln(p' / p'_0) - (lambda - kappa) ln(1 + eta^2 / M^2) (Wood 1990, section 5.3), and the
// critical state lies where the path of slope 3 meets q = M p'.
TEST(ModifiedCamClay, FollowsTheDrainedPathNormallyConsolidated) {
  Sample sample(1.0);
  double worst = 0.0;
  for (int k = 0; k < 1500; ++k) {
    strain_drained(sample, 5.0e-4);
    const double p = p_of(sample.stress), eta = q_of(sample.stress) / p;
    ASSERT_NEAR(q_of(sample.stress), 3.0 * (p - p_0), 1e-3 * p_0);
    const double lost = lambda * std::log(p / p_0) + (lambda - kappa) * std::log1p(eta * eta / (M * M));
    worst = std::max(worst, std::abs((first_v - sample.v) / lost - 1.0));
  }
  const double last = 3.0 * p_0 / (3.0 - M);
  RecordProperty("largest_error", std::to_string(worst));
  EXPECT_LT(worst, 0.01);
  EXPECT_NEAR(q_of(sample.stress), M * last, 0.01 * M * last);
  EXPECT_NEAR(sample.p_c, 2.0 * last, 0.02 * last);
}

// Heavily overconsolidated and drained it yields where the path meets the first ellipse, dilates, softens, and ends at
// the same critical state.
TEST(ModifiedCamClay, SoftensToTheCriticalStateOnTheDrySide) {
  const double n = 8.0;
  Sample sample(n);
  double peak = 0.0, least_p_c = n * p_0, before = n * p_0;
  for (int k = 0; k < 3000; ++k) {
    strain_drained(sample, 2.0e-4);
    peak = std::max(peak, q_of(sample.stress));
    EXPECT_LE(sample.p_c, before * (1.0 + 1e-9)) << "step " << k;
    before = sample.p_c;
    least_p_c = std::min(least_p_c, sample.p_c);
  }
  // q = 3 (p - p_0) in f = 0
  const double a = 9.0 / (M * M) + 1.0, b = -(18.0 / (M * M) + n) * p_0, c = 9.0 / (M * M) * p_0 * p_0;
  const double at_yield = 3.0 * ((-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a) - p_0);
  const double last = 3.0 * p_0 / (3.0 - M);
  EXPECT_NEAR(peak, at_yield, 0.01 * at_yield);
  EXPECT_NEAR(q_of(sample.stress), M * last, 0.01 * M * last);
  EXPECT_GT(sample.v, first_v) << "it dilates";
}

// From stresses on the ellipse and inside, by increments in all directions: where it yields it ends on the ellipse, and
// the plastic strain is normal to it: d eps_v^p / d eps_q^p = M^2 (2 p - p_c) / (2 q).
TEST(ModifiedCamClay, ReturnsToTheEllipseAlongItsNormal) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  int yielded = 0, dry = 0;
  for (int k = 0; k < 20000; ++k) {
    Sample sample(clay(1.0), pressure(p_0 * (1.0 + part(random))));
    sample.p_c = p_0 * std::pow(10.0, part(random));
    sample.stress = pressure(sample.p_c * (0.5 + 0.5 * part(random)));
    SymmetricTensor s = deviator({part(random), part(random), part(random), part(random)});
    const double p = p_of(sample.stress), reach = M * std::sqrt(std::max(0.0, p * (sample.p_c - p)));
    const double size = (k % 4 == 0 ? std::abs(part(random)) : 1.0) * reach / q_of(s);
    sample.stress = {size * s.xx - p, size * s.yy - p, size * s.zz - p, size * s.xy};
    ASSERT_LE(sample.f(), 1e-12);
    const double before = sample.p_c, scale = std::pow(10.0, -5.5 + 1.5 * part(random));
    sample.strain({scale * part(random), scale * part(random), scale * part(random), scale * part(random)});
    ASSERT_LE(sample.f(), 1e-9);
    ASSERT_GE(p_of(sample.stress), -1e-9 * p_0);
    if (sample.plastic_strain == 0.0) {
      EXPECT_EQ(sample.p_c, before);
      continue;
    }
    ++yielded;
    ASSERT_NEAR(sample.f(), 0.0, 1e-9);
    const double p_now = p_of(sample.stress), q_now = q_of(sample.stress);
    const double volumetric = (lambda - kappa) / first_v * std::log(sample.p_c / before);
    dry += volumetric < 0.0;
    if (sample.p_c < 1.01e3) continue;  // no longer softens
    const double shear = 2.0 * q_now * volumetric, slope = M * M * (2.0 * p_now - sample.p_c) * sample.plastic_strain;
    EXPECT_NEAR(shear, slope, 1e-6 * sample.p_c * (std::abs(volumetric) + sample.plastic_strain)) << k;
  }
  EXPECT_GT(yielded, 4000);
  EXPECT_GT(dry, 1000);
}

// One increment of 2 % and two thousand of 1e-5 come to the same stress within 1 %.
TEST(ModifiedCamClay, BigAndSmallIncrementsAgree) {
  const std::vector<SymmetricTensor> ways{triaxial(0.02, -0.01), triaxial(0.02, 0.0),        triaxial(-0.02, 0.01),
                                          triaxial(0.02, 0.02),  {0.01, -0.012, 0.0, 0.015}, {0.0, 0.0, 0.0, 0.02}};
  double worst = 0.0;
  for (const double n : {1.0, 1.5, 4.0, 10.0}) {
    for (const SymmetricTensor& way : ways) {
      Sample at_once(n), little(n);
      at_once.strain(way);
      const int parts = 2000;
      const double fixed_v = little.v;
      for (int k = 0; k < parts; ++k) {
        little.v = fixed_v;
        little.strain({way.xx / parts, way.yy / parts, way.zz / parts, way.xy / parts});
      }
      const SymmetricTensor &a = at_once.stress, &b = little.stress;
      const double error = std::sqrt(2.0 / 3.0) * q_of({a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy});
      worst = std::max(
          {worst, error / p_of(b), std::abs(p_of(a) / p_of(b) - 1.0), std::abs(at_once.p_c / little.p_c - 1.0)});
    }
  }
  RecordProperty("largest_difference", std::to_string(worst));
  EXPECT_LT(worst, 0.01);
}

TEST(ModifiedCamClay, BearsNoTensionAndKeepsItsLeastStrength) {
  Sample sample(1.0);
  for (const SymmetricTensor& pull : {SymmetricTensor{1.0e-4, 2.0e-5, 0.0, 5.0e-5}, triaxial(-1.0e-4, -1.0e-4)}) {
    for (int k = 0; k < 4000; ++k) {
      sample.strain(pull);
      ASSERT_GE(p_of(sample.stress), -1e-9 * p_0);
      ASSERT_LE(sample.f(), 1e-9);
    }
    EXPECT_LT(p_of(sample.stress), 0.5 * sample.p_c) << "dry";
    EXPECT_NEAR(sample.p_c, 1.0e3, 1e-9);
  }
  EXPECT_NEAR(p_of(sample.stress), 0.0, 1e-9) << "pulled alike in all directions";
  EXPECT_NEAR(q_of(sample.stress), 0.0, 1e-2);
  const Elastic least = sample.law.stiffness(sample.stress, first_v);
  EXPECT_NEAR(least.bulk_modulus(), first_v * 1.0e3 / kappa, 1e-6 * least.bulk_modulus());
  EXPECT_EQ(least.poissons_ratio, nu);
  for (int k = 0; k < 30; ++k) sample.strain(triaxial(1.0e-2, 1.0e-2));
  EXPECT_GT(p_of(sample.stress), 1.0e3) << "pressed together it is stiff again";
}

TEST(ModifiedCamClay, StiffnessGrowsWithPressureAndVolume) {
  const HardeningEllipse law(clay(), nu);
  const Elastic elastic = law.stiffness(pressure(2.0e5), 2.0);
  EXPECT_NEAR(elastic.bulk_modulus(), 2.0 * 2.0e5 / kappa, 1e-6);
  EXPECT_NEAR(elastic.shear_modulus(), 1.5 * (1.0 - 2.0 * nu) / (1.0 + nu) * elastic.bulk_modulus(), 1e-6);
  // a small strain meets it
  Sample sample(2.0);
  sample.strain({1.0e-7, 0.0, 0.0, 1.0e-7});
  const Elastic small = law.stiffness(pressure(p_0), first_v);
  EXPECT_NEAR(sample.stress.xy, 2.0 * small.shear_modulus() * 1.0e-7, 1e-4);
  EXPECT_NEAR(sample.stress.xx + p_0, small.constrained_modulus() * 1.0e-7, 1e-4);
}

TEST(ModifiedCamClay, IsFoundWithTheConsolidationThatItIsGiven) {
  const auto p_c = [](const ModifiedCamClay& strength, const SymmetricTensor& stress) {
    return Sample(strength, stress).p_c;
  };
  const SymmetricTensor sheared{-5.0e4, -1.1e5, -5.0e4, 0.0};  // p 70 kPa, q 60 kPa
  const double through = 7.0e4 + 6.0e4 * 6.0e4 / (M * M * 7.0e4);
  EXPECT_NEAR(p_c(clay(), sheared), through, 1e-6);
  EXPECT_NEAR(p_c(clay(2.5), sheared), 2.5 * through, 1e-6);
  ModifiedCamClay given = clay();
  given.overconsolidation_ratio.reset();
  given.pre_overburden_pressure = 3.0e4;
  EXPECT_NEAR(p_c(given, sheared), through + 3.0e4, 1e-6);
  given.pre_overburden_pressure.reset();
  given.preconsolidation_pressure = 4.0e5;
  EXPECT_NEAR(p_c(given, sheared), 4.0e5, 1e-6);
  given.preconsolidation_pressure = 2.0e4;
  EXPECT_NEAR(p_c(given, sheared), through, 1e-6) << "not less than the stress asks for";
  EXPECT_NEAR(p_c(clay(), pressure(0.0)), 1.0e3, 1e-9) << "at a free surface";
  EXPECT_NEAR(p_c(clay(), {1.0e5, -1.3e5, 1.0e4, 0.0}), 2.0 * 20.0e3 / 3.0, 1e-6) << "beyond the critical state";
}

TEST(ModifiedCamClay, AnswersElasticallyWhereItShallNotYield) {
  Sample sample(1.0);
  sample.strain(triaxial(0.01, 0.01), false);
  EXPECT_NEAR(p_of(sample.stress), p_0 * std::exp(first_v * 0.03 / kappa), 1e-6 * p_0);
  EXPECT_EQ(sample.p_c, p_0);
  EXPECT_EQ(sample.plastic_strain, 0.0);
}

TEST(ModifiedCamClay, WhatItCannotIntegrateIsNoNumber) {
  for (const double strain : {2.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Sample sample(1.0);
    sample.strain({strain, 0.0, 0.0, 0.0});
    EXPECT_FALSE(std::isfinite(p_of(sample.stress))) << strain;
  }
}

testing::Block clay_block() {
  testing::Block block;
  block.soil_rows = 4;
  block.soil.elastic = {.youngs_modulus = 0.0, .poissons_ratio = nu};
  block.soil.strength = clay(2.0);
  return block;
}

TEST(ModifiedCamClayInAGrid, KeepsItsVariablesOnTheParticles) {
  MaterialPointMethod solid = clay_block().build();
  Particles& p = solid.particles();
  ASSERT_EQ(p.internal.size(), p.size());
  for (auto* stress : {&p.sxx, &p.syy, &p.szz}) std::fill(stress->begin(), stress->end(), -p_0);
  solid.set_internal_variables();
  const std::vector<InternalField> fields = solid.internal_fields();
  ASSERT_EQ(fields.size(), 1u);
  EXPECT_EQ(fields[0].name, "preconsolidation_pressure");
  EXPECT_EQ(fields[0].unit, "Pa");
  ASSERT_EQ(fields[0].values.size(), p.size());
  EXPECT_NEAR(fields[0].values[3], 2.0 * p_0, 1e-9);
  EXPECT_TRUE(solid.stiffness_varies());

  testing::Block other;
  other.soil_rows = 4;
  MaterialPointMethod stateless = other.build();
  EXPECT_TRUE(stateless.particles().internal.empty());
  EXPECT_TRUE(stateless.internal_fields().empty());
  EXPECT_FALSE(stateless.stiffness_varies());
  EXPECT_THROW(stateless.set_state(solid.state()), std::invalid_argument);
}

TEST(ModifiedCamClayInAGrid, StableStepFollowsTheStress) {
  const testing::Block block = clay_block();
  MaterialPointMethod solid = block.build();
  const auto wave_step = [&](double p) {
    const double v = 1.0 / (1.0 - block.porosity);
    const double bulk = v * p / kappa;
    const double modulus = bulk * (1.0 + 2.0 * (1.0 - 2.0 * nu) / (1.0 + nu));
    return 0.5 * block.cell_size / std::sqrt(modulus / block.dry_density());
  };
  EXPECT_NEAR(solid.stable_step(0.5, {}), wave_step(1.0e3), 1e-9);
  Particles& p = solid.particles();
  for (auto* stress : {&p.sxx, &p.syy, &p.szz}) stress->at(5) = -9.0e4;
  EXPECT_NEAR(solid.stable_step(0.5, {}), wave_step(9.0e4), 1e-9);
}

TEST(ModifiedCamClayInAGrid, WhatItCannotIntegrateIsAnError) {
  MaterialPointMethod solid = clay_block().build();
  for (double& rate : solid.particles().cyx) rate = 30.0;
  solid.predict(0.1, {}, {}, 0.0);
  EXPECT_THROW(solid.advance(0.1, {}, {.moves = false}), SolidError);
}

}  // namespace
}  // namespace slope::solid
