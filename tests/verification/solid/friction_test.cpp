// Blocks on walls with friction: they slide as rigid ones do once their stress is that of sliding, stay below the
// coefficient, come off, land and topple; towards either side, on the base and along the sides.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <slope/testing/record.hpp>

#include "block.hpp"

namespace slope::solid {
namespace {

using slope::testing::at_least;
using slope::testing::at_most;
using slope::testing::near;
using slope::testing::record;
using testing::Block;

constexpr double gravity = 9.81;
constexpr double left_end = 1.0;  // m, of a block before it slides

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

struct Sliding {
  double friction = 0.5;
  double push = 0.6;  // k_h
  double lift = 0.0;  // k_v
  double youngs_modulus = 1.0e7;
  double length = 2.0, height = 1.0;  // m
  double cell_size = 0.25;
  double box = 14.0;  // m
  double start = left_end;
  double time = 1.5;
  double courant_number = 0.5;
  double side_friction = -1.0;  // of the left wall; none: free
  bool sudden = false;          // the push begins with the motion
};

struct Slid {
  double way = 0.0, speed = 0.0;
  double least_reaction = 0.0;    // of a node, over the weight
  double normal_impulse = 0.0;    // over that of the weight
  double friction_impulse = 0.0;  // over the coefficient times the normal one
  double highest_stress = 0.0;    // vertical, mean of the lowest particles over two cells, over the overburden
};

class SlidingBlock {
 public:
  explicit SlidingBlock(const Sliding& given) : given_(given), solid_(build(given)) {
    const Particles& p = solid_.particles();
    weight_ = gravity * std::accumulate(p.solid_mass.begin(), p.solid_mass.end(), 0.0);
    step_ = solid_.stable_step(given.courant_number, {});
    const double crossing = given.height / given.cell_size * solid_.stable_step(1.0, {});
    const StepMode initial{.yields = false, .moves = false, .accumulates_strain = false};
    for (double time = 0.0; time < 100.0 * crossing; time += step_) {
      solid_.predict(step_, {}, {.body_acceleration = given.sudden ? std::array{0.0, 0.0} : body()},
                     0.5 * std::numbers::pi / crossing);
      solid_.advance(step_, {}, initial);
    }
    solid_.stop();
  }

  void run(double duration) {
    for (double time = 0.0; time < duration - 1e-9;) {
      const double dt = std::min(step_, duration - time);
      solid_.predict(dt, {}, {.body_acceleration = body()}, 0.0);
      solid_.advance(dt, {}, {.yields = false});
      time += dt;
      for (const WallReaction& reaction : solid_.wall_reactions()) {
        least_ = std::min(least_, reaction.normal);
        normal_ += dt * reaction.normal;
        friction_ += dt * reaction.friction;
      }
      watch_stress();
    }
    time_ += duration;
  }

  void set(double push, double lift) {
    given_.push = push;
    given_.lift = lift;
  }

  [[nodiscard]] Slid result() const {
    const Particles& p = solid_.particles();
    return {
        mean(p.ux), mean(p.vx), least_ / weight_, normal_ / (weight_ * time_), -friction_ / (given_.friction * normal_),
        highest_};
  }
  [[nodiscard]] const Particles& particles() const { return solid_.particles(); }
  [[nodiscard]] double normal_force() const {
    double force = 0.0;
    for (const WallReaction& reaction : solid_.wall_reactions()) force += reaction.normal;
    return force / weight_;
  }

 private:
  static MaterialPointMethod build(const Sliding& given) {
    const auto cells = [&given](double length) { return static_cast<int>(std::lround(length / given.cell_size)); };
    Block block;
    block.cell_size = given.cell_size;
    block.columns = cells(given.box);
    block.rows = cells(given.height + 1.0);
    block.first_column = cells(given.start);
    block.soil_columns = cells(given.length);
    block.soil_rows = cells(given.height);
    block.soil.elastic.youngs_modulus = given.youngs_modulus;
    block.walls = {.left = Wall::free, .right = Wall::free, .base = Wall::friction, .base_friction = given.friction};
    if (given.side_friction >= 0.0) {
      block.walls.left = Wall::friction;
      block.walls.left_friction = given.side_friction;
    }
    return block.build();
  }

  [[nodiscard]] std::array<double, 2> body() const { return {given_.push * gravity, given_.lift * gravity}; }

  void watch_stress() {
    const Particles& p = solid_.particles();
    const auto row = static_cast<std::size_t>(std::lround(2.0 * given_.length / given_.cell_size));
    for (std::size_t first = 0; first + 4 <= row; first += 4) {
      const double stress = 0.25 * std::accumulate(&p.syy[first], &p.syy[first] + 4, 0.0);
      highest_ = std::max(highest_, stress * given_.length / weight_);
    }
  }

  Sliding given_;
  MaterialPointMethod solid_;
  double weight_ = 0.0, step_ = 0.0, time_ = 0.0;
  double least_ = 1e300, normal_ = 0.0, friction_ = 0.0, highest_ = -1e300;
};

Slid slide(const Sliding& given) {
  SlidingBlock block(given);
  block.run(given.time);
  return block.result();
}

// Of a rigid block.
double acceleration(const Sliding& given) {
  return gravity * (given.push - std::copysign(given.friction * (1.0 - given.lift), given.push));
}

double way_error(const Sliding& given, const Slid& slid) {
  return std::abs(slid.way / (0.5 * acceleration(given) * given.time * given.time) - 1.0);
}

double speed_error(const Sliding& given, const Slid& slid) {
  return std::abs(slid.speed / (acceleration(given) * given.time) - 1.0);
}

TEST(FrictionBlock, SlidesAsARigidOne) {
  double way = 0.0, speed = 0.0, least = 1.0, impulse = 0.0, highest = -1.0;
  for (const double friction : {0.2, 0.4, 0.6, 0.8}) {
    for (const double modulus : {1.0e7, 1.0e8}) {
      for (const auto& [length, height] : {std::pair{2.0, 1.0}, std::pair{8.0, 0.5}}) {
        const Sliding given{.friction = friction,
                            .push = friction + 0.1,
                            .youngs_modulus = modulus,
                            .length = length,
                            .height = height};
        const Slid slid = slide(given);
        way = std::max(way, way_error(given, slid));
        speed = std::max(speed, speed_error(given, slid));
        least = std::min(least, slid.least_reaction);
        impulse = std::max({impulse, std::abs(slid.normal_impulse - 1.0), std::abs(slid.friction_impulse - 1.0)});
        highest = std::max(highest, slid.highest_stress);
      }
    }
  }
  const std::string blocks = "Blocks 2 x 1 and 8 x 0.5 m on a base of 0.2 to 0.8, E 10 and 100 MPa: ";
  EXPECT_TRUE(record("friction-blocks-1-way", blocks + "largest error of the way", at_most(0.02), way, "%"));
  EXPECT_TRUE(record("friction-blocks-2-speed", blocks + "of the speed", at_most(0.02), speed, "%"));
  EXPECT_TRUE(record("friction-blocks-3-normal", blocks + "least normal force of the base at a node over the weight",
                     at_least(0.0), least, ""));
  EXPECT_TRUE(record("friction-blocks-4-stress",
                     blocks + "highest vertical stress at the base (mean over two cells, tension positive) over the "
                              "overburden",
                     at_most(0.05), highest, ""));
  EXPECT_LT(impulse, 0.005) << "the normal force bears the weight, friction is its share";
}

TEST(FrictionBlock, IsTheSameOnOtherGridsAndUnderAVerticalForce) {
  for (const Sliding& given :
       {Sliding{.cell_size = 0.125}, Sliding{.cell_size = 0.5}, Sliding{.start = 1.5}, Sliding{.length = 1.0},
        Sliding{.courant_number = 0.9}, Sliding{.start = 0.0, .side_friction = 0.5},
        Sliding{.friction = 0.4, .push = 0.5, .lift = 0.3}, Sliding{.friction = 0.4, .push = 0.7, .lift = -0.3}}) {
    const Slid slid = slide(given);
    EXPECT_LT(way_error(given, slid), 0.01) << given.cell_size << " " << given.length << " " << given.lift;
    EXPECT_LT(speed_error(given, slid), 0.01) << given.cell_size << " " << given.length << " " << given.lift;
  }
  const Sliding far{.friction = 0.2, .box = 20.0, .time = 2.6};
  EXPECT_TRUE(record("friction-blocks-5-far", "Block on a base of 0.2, k_h = 0.6, over 53 cells: way",
                     near(0.5 * acceleration(far) * 2.6 * 2.6, 0.02 * 0.5 * acceleration(far) * 2.6 * 2.6),
                     slide(far).way, "m"));
}

TEST(FrictionBlock, PushedTheOtherWayIsItsMirrorImage) {
  const Slid right = slide({.sudden = true}), left = slide({.push = -0.6, .start = 11.0, .sudden = true});
  EXPECT_NEAR(left.way, -right.way, 1e-9);
  EXPECT_NEAR(left.speed, -right.speed, 1e-9);
}

// The base stops the soil with mu W only when the shear wave, rho c k_h g t, has grown to that: until t_1 = mu H/(k_h
// c).
TEST(FrictionBlock, PushedAllAtOnceSlidesAsAnElasticOne) {
  const Sliding given{.sudden = true};
  const Block block;
  const double shear = Elastic{given.youngs_modulus, block.soil.elastic.poissons_ratio}.shear_modulus();
  const double until = given.friction / given.push * given.height / std::sqrt(shear / block.dry_density());
  const double late = given.friction * gravity * until;
  const double way = 0.5 * acceleration(given) * 1.5 * 1.5 + late * (0.5 * 1.5 - until / 6.0);
  EXPECT_TRUE(record("friction-blocks-6-sudden",
                     "Elastic block on a base of 0.5 (E 10 MPa), k_h = 0.6 at once: way after 1.5 s",
                     near(way, 0.02 * way), slide(given).way, "m"));
}

TEST(FrictionBlock, StaysBelowTheCoefficient) {
  const Slid slow = slide({.friction = 0.7});
  EXPECT_TRUE(record("friction-blocks-7-rest", "Block on a base of 0.7, k_h = 0.6: way after 1.5 s", at_most(0.1),
                     1e3 * std::abs(slow.way), "mm"));
  // at once, it is thrown beyond the coefficient and slips a little; then it stays
  SlidingBlock block({.friction = 0.7, .sudden = true});
  block.run(1.0);
  const double before = block.result().way;
  EXPECT_LT(before, 0.01);
  block.run(2.0);
  EXPECT_NEAR(block.result().way, before, 1e-4);
}

TEST(FrictionBlock, ThrownUpFliesFreelyAndLands) {
  SlidingBlock block({.friction = 0.4, .push = 0.3, .lift = 1.2});
  block.run(0.5);
  const Slid thrown = block.result();
  EXPECT_NEAR(thrown.speed, 0.3 * gravity * 0.5, 0.005 * gravity * 0.5);
  EXPECT_NEAR(mean(block.particles().uy), 0.5 * 0.2 * gravity * 0.25, 0.005);
  EXPECT_LT(thrown.normal_impulse, 0.01);
  EXPECT_EQ(block.normal_force(), 0.0);
  block.set(0.0, 0.0);
  block.run(4.0);
  EXPECT_NEAR(mean(block.particles().uy), 0.0, 0.005);
  EXPECT_NEAR(block.result().speed, 0.0, 0.01);
  EXPECT_NEAR(block.normal_force(), 1.0, 0.1);
}

TEST(FrictionBlock, TopplesWhereItsWeightLeavesItsBase) {
  const auto turned = [](double push) {
    SlidingBlock block(
        {.friction = 2.0, .push = push, .youngs_modulus = 1.0e8, .length = 1.0, .start = 5.0, .sudden = true});
    block.run(0.8);
    const Particles& p = block.particles();
    return (p.uy.front() - p.uy[3]) / 0.75;
  };
  EXPECT_LT(std::abs(turned(0.8)), 0.01);
  EXPECT_GT(turned(1.3), 0.1);
}

// In hydrostatic water up to its top, the effective weight is what friction follows, in layers thin and thick.
TEST(FrictionBlock, SlidesWithItsEffectiveWeightInWater) {
  double error = 0.0;
  for (const double height : {0.5, 1.0}) {
    Block block;
    block.cell_size = 0.25;
    block.columns = 48;
    block.rows = 8;
    block.first_column = 4;
    block.soil_columns = 32;
    block.soil_rows = static_cast<int>(std::lround(height / block.cell_size));
    block.walls = {.left = Wall::free, .right = Wall::free, .base = Wall::friction, .base_friction = 0.5};
    MaterialPointMethod solid = block.build();
    const double unit_weight = 1000.0 * gravity, buoyant = 1.0 - 1000.0 / block.saturated_density();
    const double expected = gravity * (0.4 - 0.5 * buoyant);
    const std::vector<double> water = block.pore_water(solid);
    std::vector<double> pressure = solid.particles().y;
    for (double& p : pressure) p = unit_weight * (height - p);
    const double dt = solid.stable_step(0.5, water);
    for (int step = 0; step < 1500; ++step) {
      solid.predict(dt, {pressure, water}, {.body_acceleration = {0.4 * gravity, 0.0}}, 40.0);
      solid.advance(dt, {}, {.yields = false, .moves = false, .accumulates_strain = false});
    }
    solid.stop();
    double time = 0.0;
    for (; time < 0.8; time += dt) {
      solid.predict(dt, {pressure, water}, {.body_acceleration = {0.4 * gravity, 0.0}}, 0.0);
      solid.advance(dt, {}, {.yields = false});
    }
    error = std::max(error, std::abs(mean(solid.particles().vx) / (expected * time) - 1.0));
  }
  EXPECT_TRUE(record("friction-blocks-9-water",
                     "Saturated layers of 0.5 and 1 m on a base of 0.5, hydrostatic, k_h = 0.4: error of the speed",
                     at_most(0.02), error, "%"));
}

// A block beside a wall, with gravity and push exchanged.
double fall(Wall left, Wall right, double friction, double push, double time) {
  Block block;
  block.cell_size = 0.25;
  block.columns = 16;
  block.soil_columns = 4;
  block.first_column = right == Wall::friction ? 12 : 0;
  block.rows = 60;
  block.first_row = 50;
  block.soil_rows = 8;
  block.walls = {
      .left = left, .right = right, .base = Wall::roller, .left_friction = friction, .right_friction = friction};
  MaterialPointMethod solid = block.build();
  const double dt = solid.stable_step(0.5, {});
  for (int step = 0; step < 2000; ++step) {
    solid.predict(dt, {}, {.body_acceleration = {push * gravity, 0.0}}, 40.0);
    solid.advance(dt, {}, {.yields = false, .moves = false, .accumulates_strain = false});
  }
  solid.stop();
  for (double t = 0.0; t < time - 0.5 * dt; t += dt) {
    solid.predict(dt, {}, {.body_acceleration = {push * gravity, 0.0}}, 0.0);
    solid.advance(dt, {}, {.yields = false});
  }
  return -mean(solid.particles().uy);
}

TEST(FrictionBlock, SlidesDownASide) {
  const double time = 1.0, expected = 0.5 * 0.5 * gravity * time * time;
  const double left = fall(Wall::friction, Wall::free, 0.5, -1.0, time);
  EXPECT_TRUE(record("friction-blocks-8-side", "Block 1 x 2 m pressed with its weight to a side of 0.5: fall after 1 s",
                     near(expected, 0.02 * expected), left, "m"));
  EXPECT_NEAR(fall(Wall::free, Wall::friction, 0.5, 1.0, time), left, 1e-9);
  EXPECT_NEAR(fall(Wall::friction, Wall::free, 0.5, 0.2, 0.5), 0.5 * gravity * 0.25, 0.01) << "pulled off the wall";
}

}  // namespace
}  // namespace slope::solid
