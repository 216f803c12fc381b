// A column of modified Cam-clay under a load on its top, between smooth walls, loaded, unloaded and loaded again:
// against the constitutive rates of one point, integrated in tiny steps by the midpoint rule. They share no line with
// the law.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <slope/testing/record.hpp>

#include "block.hpp"

namespace slope::solid {
namespace {

using slope::testing::at_most;
using slope::testing::record;
using testing::Block;

constexpr double M = 1.0, lambda = 0.2, kappa = 0.04, nu = 0.25, porosity = 0.5;
constexpr double first_load = 50.0e3, ratio = 1.5;  // Pa; overconsolidation ratio

/// One point that is compressed along an axis and held across: mean stress, q = sigma_a - sigma_r, p_c (Pa), volume.
struct Point {
  double p = first_load, q = 0.0, p_c = ratio * first_load, v = 1.0 / (1.0 - porosity);

  [[nodiscard]] double axial() const { return p + 2.0 / 3.0 * q; }
  [[nodiscard]] double radial() const { return p - q / 3.0; }
  [[nodiscard]] Point plus(const Point& rate, double strain) const {
    return {p + strain * rate.p, q + strain * rate.q, p_c + strain * rate.p_c, v + strain * rate.v};
  }
  /// Per axial strain; `sign` tells loading from unloading.
  [[nodiscard]] Point rates(double sign) const {
    const double bulk = v * p / kappa, shear = 1.5 * (1.0 - 2.0 * nu) / (1.0 + nu) * bulk;
    const double along_p = 2.0 * p - p_c, along_q = 2.0 * q / (M * M);
    const double towards = along_p * bulk + along_q * 2.0 * shear;  // of the elastic stress rate
    double flow = 0.0;
    if (q * q / (M * M) + p * (p - p_c) >= 0.0 && sign * towards > 0.0) {
      flow = towards /
             (along_p * along_p * bulk + along_q * along_q * 3.0 * shear + p * p_c * v / (lambda - kappa) * along_p);
    }
    return {bulk * (1.0 - flow * along_p), 3.0 * shear * (2.0 / 3.0 - flow * along_q),
            p_c * v / (lambda - kappa) * flow * along_p, -v};
  }
  void load_to(double wanted) {
    const double sign = wanted > axial() ? 1.0 : -1.0, strain = sign * 1.0e-6;
    while (sign * (wanted - axial()) > 0.0) *this = plus(plus(rates(sign), 0.5 * strain).rates(sign), strain);
  }
};

struct Column {
  Block block;
  MaterialPointMethod solid;
  std::vector<std::size_t> top;
  double load = first_load;

  static Block clay() {
    Block block;
    block.cell_size = 0.25;
    block.soil_rows = 4;
    block.rows = 6;
    block.walls.base = Wall::roller;
    block.porosity = porosity;
    block.settings.gravity = 0.0;
    block.soil.elastic = {.youngs_modulus = 0.0, .poissons_ratio = nu};
    block.soil.strength = ModifiedCamClay{.critical_state_ratio = M,
                                          .lambda = lambda,
                                          .kappa = kappa,
                                          .minimum_mean_stress = 1.0e3,
                                          .overconsolidation_ratio = ratio};
    return block;
  }

  Column() : block(clay()), solid(block.build()) {
    Particles& p = solid.particles();
    for (auto* stress : {&p.sxx, &p.syy, &p.szz}) std::fill(stress->begin(), stress->end(), -first_load);
    solid.set_internal_variables();
    const double highest = *std::ranges::max_element(p.y);
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.y[i] > highest - 0.25 * block.spacing()) top.push_back(i);
    }
  }

  void load_to(double wanted) {
    const double begin = load, period = 0.1, ramp = 20.0 * period, rest = 5.0 * period;
    double dt = 0.0;
    for (double time = 0.0; time < ramp + rest; time += dt) {
      dt = solid.stable_step(0.5, {});
      const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * std::min(1.0, time / ramp));
      load = begin + share * (wanted - begin);
      std::vector<ParticleTraction> tractions;
      for (const std::size_t p : top) tractions.push_back({p, 0.0, -load, 0.0, 0.5 * block.spacing()});
      solid.predict(dt, {}, {.tractions = tractions}, 2.0 * std::numbers::pi / period);
      solid.advance(dt, {});
    }
  }

  [[nodiscard]] double mean(const std::vector<double>& field) const {
    double sum = 0.0;
    for (const double value : field) sum += value;
    return sum / static_cast<double>(field.size());
  }
  [[nodiscard]] double volume() const { return mean(solid.particles().volume) / std::pow(block.spacing(), 2); }
};

TEST(CamClayOedometer, FollowsTheConstitutiveRates) {
  Column column;
  Point point;
  double strain_error = 0.0, stress_error = 0.0, memory_error = 0.0;
  for (const double load : {200.0e3, 60.0e3, 300.0e3}) {
    column.load_to(load);
    point.load_to(load);
    const double expected = 1.0 - point.v * (1.0 - porosity), found = 1.0 - column.volume();
    strain_error = std::max(strain_error, std::abs(found / expected - 1.0));
    const Particles& p = column.solid.particles();
    stress_error = std::max(stress_error, std::abs(-column.mean(p.sxx) / point.radial() - 1.0));
    memory_error = std::max(memory_error, std::abs(column.mean(p.internal) / point.p_c - 1.0));
    EXPECT_NEAR(-column.mean(p.syy), load, 0.005 * load);
  }
  EXPECT_TRUE(record("cam-clay-1", "Modified Cam-clay in an oedometer, loaded, unloaded, loaded again: settlement",
                     at_most(0.01), strain_error, "%"));
  EXPECT_TRUE(record("cam-clay-2", "- lateral stress", at_most(0.01), stress_error, "%"));
  EXPECT_TRUE(record("cam-clay-3", "- preconsolidation pressure", at_most(0.01), memory_error, "%"));
}

}  // namespace
}  // namespace slope::solid
