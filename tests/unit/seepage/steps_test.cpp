// Steps own their work: what they keep between their calls, and that they keep nothing between steps.

#include <gtest/gtest.h>

#include <optional>

#include "particles.hpp"
#include "slope/seepage/coupled_step.hpp"
#include "slope/seepage/explicit_step.hpp"
#include "slope/seepage/rigid_step.hpp"

namespace slope::seepage {
namespace {

using testing::lattice;
using testing::Particles;

constexpr int columns = 4, rows = 10;
constexpr double spacing = 0.1;

// A box of two soils with each kind of boundary.
class Steps : public ::testing::Test {
 protected:
  [[nodiscard]] PoreFlow flow() const {
    Soil sand, loam;
    sand.retention = VanGenuchten{.alpha = 2.0, .n = 3.0, .range = {}};
    sand.relative_permeability.law = HillelPower{.exponent = 3.0};
    sand.hydraulic_conductivity = 1.0e-4;
    loam.retention = VanGenuchten{.alpha = 1.0, .n = 1.5, .range = {}};
    loam.relative_permeability.law = VanGenuchtenMualem{.n = 1.5, .range = {}};
    loam.hydraulic_conductivity = 1.0e-6;
    std::vector<std::uint16_t> soil(particles.size(), 0);
    std::fill(soil.begin() + columns * rows / 2, soil.end(), std::uint16_t{1});
    std::vector<double> pressure;
    for (const double y : particles.y) pressure.push_back(Water{}.unit_weight() * (0.3 - y));
    FlowSettings settings;
    settings.spacing = spacing;
    settings.walls = {.left = 0.0, .right = columns * spacing, .base = 0.0};
    return {{sand, loam}, Water{}, soil, pressure, particles.skeleton(), settings};
  }
  [[nodiscard]] Boundary boundary() const {
    const std::uint32_t top = (rows - 1) * columns;
    const double half = 0.5 * spacing;
    Boundary result;
    result.count = 5;
    result.held = {{top, 0, -1000.0}};
    result.faces = {{top + 1, 1, 100.0, half, half, spacing}};
    result.inflows = {{top + 2, 2, 1.0e-7}, {1, 2, 2.0e-8}};
    result.open_faces = {{top + 3, 3, 2.0e-7, 0.0, -1.0e5, half, half, spacing},
                         {top + 2, 3, -1.0e-8, 0.0, -1.0e5, half, half, spacing}};
    result.drains = {{1, 4, spacing}, {2, 4, spacing}};
    return result;
  }
  void take_coupled(PoreFlow& water, CoupledStep& step) const {
    step.solve(water, 2.0, particles.skeleton(), strain, boundary(), RigidSkeleton{}, 1.0e-2);
    step.finish(water, particles.skeleton());
  }

  Particles particles = lattice(columns, rows, spacing);
  std::vector<double> strain = std::vector<double>(particles.size(), -1.0e-6);
};

TEST_F(Steps, BookTheBoundaryForWhichTheyWereSolved) {
  PoreFlow kept = flow(), gone = flow();
  CoupledStep of_kept, of_gone;
  const Boundary given = boundary();
  std::optional<Boundary> lost = given;
  of_kept.solve(kept, 2.0, particles.skeleton(), strain, given, RigidSkeleton{}, 1.0e-2);
  of_gone.solve(gone, 2.0, particles.skeleton(), strain, *lost, RigidSkeleton{}, 1.0e-2);
  lost.reset();
  of_kept.finish(kept, particles.skeleton());
  of_gone.finish(gone, particles.skeleton());
  EXPECT_EQ(gone.state(), kept.state());
  ASSERT_EQ(kept.inflow_rate().size(), 5u);
  for (const double rate : kept.inflow_rate()) EXPECT_NE(rate, 0.0);
  EXPECT_GT(kept.air_flow().rain, 0.0);
}

TEST_F(Steps, ACopyBetweenSolvingAndBookingGoesOnAlike) {
  PoreFlow water = flow();
  CoupledStep step;
  step.solve(water, 2.0, particles.skeleton(), strain, boundary(), RigidSkeleton{}, 1.0e-2);
  PoreFlow copy = water;
  CoupledStep copied_step = step;
  step.finish(water, particles.skeleton());
  EXPECT_NE(copy.state(), water.state());
  copied_step.finish(copy, particles.skeleton());
  EXPECT_EQ(copy.state(), water.state());
}

// The same steps from a copy and from a state, by steps that have done others before or none.
template <class Step, class Advance>
void expect_alike(const PoreFlow& fresh, const Advance& advance) {
  PoreFlow water = fresh;
  Step step;
  for (int k = 0; k < 3; ++k) advance(water, step);
  PoreFlow copy = water, resumed = fresh;
  resumed.set_state(water.state(), water.head_operator().state());
  Step first;
  for (int k = 0; k < 3; ++k) {
    advance(water, step);
    advance(copy, first);
    Step copied = step;
    advance(resumed, copied);
    EXPECT_EQ(copy.state(), water.state()) << "step " << k;
    EXPECT_EQ(resumed.state(), water.state()) << "step " << k;
  }
}

TEST_F(Steps, GoOnFromACopyOrAStateToTheLastBit) {
  expect_alike<CoupledStep>(flow(), [&](PoreFlow& water, CoupledStep& step) { take_coupled(water, step); });
  expect_alike<RigidStep>(flow(), [&](PoreFlow& water, RigidStep& step) {
    ASSERT_TRUE(step.advance(water, 30.0, particles.skeleton(), boundary(), 0.01).converged);
  });
  expect_alike<ExplicitStep>(flow(), [&](PoreFlow& water, ExplicitStep& step) {
    const double time_step = 0.1 * ExplicitStep::stable_step(water, particles.skeleton());
    step.advance(water, time_step, particles.skeleton(), strain, strain, boundary());
  });
}

TEST_F(Steps, MayTakeTurns) {
  PoreFlow water = flow();
  const double start = water.stored_water();
  CoupledStep coupled;
  RigidStep rigid;
  for (int k = 0; k < 4; ++k) {
    take_coupled(water, coupled);
    ASSERT_TRUE(rigid.advance(water, 2.0, particles.skeleton(), boundary(), 0.01).converged);
  }
  double inflow = 0.0;
  for (const double by_account : water.cumulative_inflow()) inflow += by_account;
  EXPECT_NEAR(water.stored_water() - start + water.unexplained_water(), inflow, 1.0e-12 * start);
}

// A rigid step on other ground, with other neighbours, than the one before.
TEST_F(Steps, RigidOnesNoticeOtherGround) {
  RigidStep used, first;
  PoreFlow before = flow();
  ASSERT_TRUE(used.advance(before, 5.0, particles.skeleton(), boundary(), 0.01).converged);
  const Particles wide = lattice(2 * columns, rows / 2, spacing);
  Soil soil;
  soil.retention = VanGenuchten{.alpha = 2.0, .n = 3.0, .range = {}};
  soil.relative_permeability.law = HillelPower{.exponent = 3.0};
  soil.hydraulic_conductivity = 1.0e-4;
  FlowSettings settings;
  settings.spacing = spacing;
  PoreFlow water({soil}, Water{}, std::vector<std::uint16_t>(wide.size(), 0), std::vector<double>(wide.size(), -2000.0),
                 wide.skeleton(), settings);
  PoreFlow again = water;
  ASSERT_TRUE(used.advance(water, 100.0, wide.skeleton(), {}, 1.0e-3).converged);
  ASSERT_TRUE(first.advance(again, 100.0, wide.skeleton(), {}, 1.0e-3).converged);
  EXPECT_EQ(water.state(), again.state());
}

TEST_F(Steps, HaveTermsWhoseSlopesAreTheirs) {
  PoreFlow water = flow();
  std::vector<double> head;
  for (std::size_t p = 0; p < particles.size(); ++p) head.push_back(water.pressure_head()[p] + particles.y[p]);
  BoundaryTerms boundary_terms;
  boundary_terms.find(boundary(), water, particles.y, head);
  ASSERT_EQ(boundary_terms.terms().size(), 7u);
  ASSERT_EQ(boundary_terms.held().size(), 1u);
  for (BoundaryTerm& term : boundary_terms.terms()) {
    const double at = head[term.particle], inflow = term.inflow(at);
    EXPECT_EQ(term.exchange(at).inflow, inflow) << "what stands in the equations is the law where it was found";
    EXPECT_GE(term.stiffness(), 0.0);
    EXPECT_NEAR(term.inflow(at + 0.5), inflow - 0.5 * term.stiffness(),
                1.0e-12 * (std::abs(inflow) + term.stiffness()));
    EXPECT_FALSE(term.follow(at));
    const double high = at + 10.0;
    if (term.follow(high)) {
      EXPECT_EQ(term.inflow(high), term.exchange(high).inflow);
    }
  }
  StepFlow step;
  step.outflow.assign(particles.size(), 0.0);
  boundary_terms.take_in(head, step);
  double out = 0.0, in = 0.0;
  for (const double outflow : step.outflow) out += outflow;
  for (const double rate : step.inflow_rate) in += rate;
  EXPECT_NEAR(-out, in, 1.0e-12 * std::abs(in));
}

// Pressures that wander, in two soils and through saturation: what is kept of the conductances is near what they are,
// and is kept. The loam's conductivity falls with an infinite slope where it begins to dry.
TEST_F(Steps, KeepConductancesWithinTheTolerance) {
  constexpr double tolerance = 1.0e-3;
  PoreFlow water = flow();
  water.follow(particles.skeleton());
  std::vector<double> pressure;
  for (std::size_t p = 0; p < particles.size(); ++p) pressure.push_back(15.0 * (double(p % 7) - 3.0));
  std::size_t kept = 0, all = 0;
  for (int k = 0; k < 1000; ++k) {
    for (std::size_t p = 0; p < pressure.size(); ++p) pressure[p] += 0.4 * std::sin(0.37 * k + 1.7 * double(p)) - 0.1;
    water.set_pressure(pressure);
    const std::vector<double> before(water.head_operator().conductance().begin(),
                                     water.head_operator().conductance().end());
    water.find_conductances(tolerance);
    PoreFlow exact = water;
    exact.find_conductances(0.0);
    for (std::size_t s = 0; s < before.size(); ++s) {
      const double now = water.head_operator().conductance()[s], right = exact.head_operator().conductance()[s];
      ASSERT_NEAR(now, right, 4.0 * tolerance * right) << "step " << k;
      kept += now == before[s] ? 1 : 0;
      ++all;
    }
    for (std::size_t p = 0; p < pressure.size(); ++p) {
      ASSERT_NEAR(water.head_operator().diagonal()[p], exact.head_operator().diagonal()[p],
                  4.0 * tolerance * exact.head_operator().diagonal()[p]);
    }
  }
  EXPECT_GT(kept, all / 10);
}

// Soil that gets over the place where its retention curve bends, a hair at a time.
class StepsOverAKink : public ::testing::TestWithParam<Retention> {};

TEST_P(StepsOverAKink, LeaveALittleOfWhatFlows) {
  const Retention retention = GetParam();
  const double kink = std::visit([](const auto& law) { return law.kink(); }, retention);
  const Particles block = lattice(6, 6, 0.25);
  Soil soil;
  soil.retention = retention;
  soil.relative_permeability.law = HillelPower{.exponent = 3.0};
  soil.hydraulic_conductivity = 1.0e-9;
  FlowSettings settings;
  settings.spacing = 0.25;
  for (const double rate : {1.0e-7, -1.0e-7}) {
    for (const double beside : {0.9999, 0.999, 1.0, 1.001, 1.0001}) {
      Boundary boundary;
      boundary.count = 1;
      for (std::uint32_t p = 0; p < block.size(); ++p) boundary.inflows.push_back({p, 0, rate});
      const double start = -kink * beside * Water{}.unit_weight();
      PoreFlow water({soil}, Water{}, std::vector<std::uint16_t>(block.size(), 0),
                     std::vector<double>(block.size(), start), block.skeleton(), settings);
      CoupledStep step;
      const std::vector<double> strain(block.size(), 0.0);
      for (int k = 0; k < 20; ++k) {
        constexpr double duration = 2.0;
        EXPECT_TRUE(step.solve(water, duration, block.skeleton(), strain, boundary, RigidSkeleton{}, 1.0e-3).converged);
        step.finish(water, block.skeleton());
        EXPECT_LE(std::abs(water.unexplained_water()), 1.0e-2 * duration * std::abs(rate) * double(block.size()))
            << "step " << k << " from " << start << " Pa at " << rate << " m2/s";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, StepsOverAKink,
                         ::testing::Values(Retention(LiakopoulosRetention{0.09247, 2.024, 0.2032}),
                                           Retention(LiakopoulosRetention{0.144, 2.74, 0.16}),
                                           Retention(VanGenuchten{
                                               .alpha = 0.5, .n = 2.0, .range = {}, .air_entry = 0.4})));

}  // namespace
}  // namespace slope::seepage
