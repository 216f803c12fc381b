// Drainage of a sand column (paper, section 3) against an independent one-dimensional solution.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_case.hpp"
#include "slope/testing/curve.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::testing {
namespace {

struct Errors {
  double early_head = 0.0;  // up to 300 s
  double late_head = 0.0;
  double settlement = 0.0;  // from 300 s on
  double outflow = 0.0;     // from 300 s on
};

Errors run_liakopoulos(const std::string& skeleton) {
  couple::Simulation simulation = start_shipped_case("paper/liakopoulos.yaml", {"coupling.skeleton=" + skeleton});
  const Table profiles = reference("liakopoulos/liakopoulos_ref_" + skeleton + "_profiles.csv");
  const Table history = reference("liakopoulos/liakopoulos_ref_history.csv");
  const Curve outflow{history.column("t_s"),
                      history.column(skeleton == "rigid" ? "cum_outflow_m_rigid" : "cum_outflow_m_def")};
  const double width = simulation.input().domain.upper[0] - simulation.input().domain.lower[0];
  Errors errors;
  run(simulation, [&](const couple::ParticleTable& now) {
    const std::string time = time_text(now.time);
    Curve head, settlement;
    for (std::size_t p = 0; p < now.position.size(); ++p) {
      head.x.push_back(now.position[p][1]);
      head.y.push_back(now.suction[p] / 9810.0);
      settlement.x.push_back(now.position[p][1]);
      settlement.y.push_back(-now.displacement[p][1] * 1000.0);
    }
    const double head_error =
        max_relative_error(head, {profiles.column("z_m"), profiles.column("suction_head_m_t" + time)});
    double& worst = now.time <= 300.0 ? errors.early_head : errors.late_head;
    worst = std::max(worst, head_error);
    if (now.time < 300.0) return;
    const double exact = interpolate(outflow, now.time);
    errors.outflow = std::max(errors.outflow, std::abs(simulation.summary().water.outflow / width - exact) / exact);
    if (skeleton == "rigid") return;
    const Curve exact_settlement{profiles.column("z_m"), profiles.column("settlement_mm_t" + time)};
    errors.settlement = std::max(errors.settlement, max_relative_error(settlement, exact_settlement));
  });
  return errors;
}

TEST(Liakopoulos, Deformable) {
  const Errors errors = run_liakopoulos("deformable");
  EXPECT_TRUE(record("liakopoulos-1", "Liakopoulos column, deformable, 2 x 50 particles: suction head up to 300 s",
                     at_most(0.03), errors.early_head, "%"));
  EXPECT_TRUE(record("liakopoulos-2", "- suction head after 300 s", at_most(0.02), errors.late_head, "%"));
  EXPECT_TRUE(record("liakopoulos-3", "- settlement from 300 s on", at_most(0.02), errors.settlement, "%"));
  EXPECT_TRUE(record("liakopoulos-4", "- cumulative outflow from 300 s on", at_most(0.02), errors.outflow, "%"));
}

TEST(Liakopoulos, Rigid) {
  const Errors errors = run_liakopoulos("rigid");
  EXPECT_TRUE(record("liakopoulos-5", "Liakopoulos column, rigid, 2 x 50 particles: suction head up to 300 s",
                     at_most(0.03), errors.early_head, "%"));
  EXPECT_TRUE(record("liakopoulos-6", "- suction head after 300 s", at_most(0.02), errors.late_head, "%"));
  EXPECT_TRUE(record("liakopoulos-7", "- cumulative outflow from 300 s on", at_most(0.02), errors.outflow, "%"));
}

}  // namespace
}  // namespace slope::testing
