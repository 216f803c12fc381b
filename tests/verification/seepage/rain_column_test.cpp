// Rain on a rigid column of the paper's soil W2, 8 m high with the water table 5 m below its surface: twice what the
// saturated soil conducts, so that it ponds.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "column.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::seepage {
namespace {

constexpr double height = 8.0, conductivity = 1.0e-5;

struct Rain {
  explicit Rain(double intensity, int rows = 160) : intensity_(intensity), column_(height, rows) {
    for (std::uint32_t i = 0; i < testing::Column::columns; ++i) {
      OpenFace face;
      face.particle = column_.top(i);
      face.rain = intensity * column_.spacing;
      face.rise = face.distance = 0.5 * column_.spacing;
      face.area = column_.spacing;
      boundary_.open_faces.push_back(face);
    }
    boundary_.count = 1;
    std::fill(column_.particles.porosity.begin(), column_.particles.porosity.end(), 0.35);
  }

  [[nodiscard]] PoreFlow flow() const {
    const Water water;
    Soil soil;
    soil.retention = VanGenuchten{.alpha = 0.05, .n = 3.0, .range = {}};
    soil.relative_permeability.law = HillelPower{.exponent = 2.0};
    soil.hydraulic_conductivity = conductivity;
    std::vector<double> start;
    for (const double y : column_.particles.y) start.push_back(water.unit_weight() * (3.0 - y));
    return {{soil}, water, column_.soil(), start, column_.particles.skeleton(), column_.settings()};
  }

  // Goes on by steps of at most `longest` until `end`, books what the air and the soil exchange (m), and notes when the
  // first water ran off (s).
  void advance(PoreFlow& flow, double end, double longest) {
    while (time_ < end * (1.0 - 1.0e-12)) {
      const double step = std::min(longest, end - time_);
      ASSERT_TRUE(water_step_.advance(flow, step, column_.particles.skeleton(), boundary_, 0.1).converged) << time_;
      time_ += step;
      const AirFlow& now = flow.air_flow();
      for (const auto part : {&AirFlow::rain, &AirFlow::infiltration, &AirFlow::run_off, &AirFlow::seepage}) {
        budget_.*part += now.*part * step / column_.width();
      }
      if (ponding_ == 0.0 && now.run_off > 1.0e-9 * now.rain) ponding_ = time_;
    }
  }

  double intensity_;
  testing::Column column_;
  Boundary boundary_;
  AirFlow budget_;
  double time_ = 0.0, ponding_ = 0.0;
  RigidStep water_step_;
};

TEST(RainColumn, PondsInTimeAndFollowsTheReference) {
  const auto profiles = slope::testing::reference("rain_w2/infiltration_flux_W2_D5_rigid.csv");
  const auto history = slope::testing::reference("rain_w2/infiltration_flux_W2_D5_rigid_history.csv");
  const slope::testing::Curve cumulative{history.column("t_s"), history.column("cumulative_m")};
  Rain rain(2.0e-5);
  PoreFlow flow = rain.flow();
  const double before = flow.stored_water();
  double worst = 0.0, worst_volume = 0.0;
  for (const auto& [time, name] : {std::pair{50.0, "p_kPa_t50"},
                                   {100.0, "p_kPa_t100"},
                                   {225.0, "p_kPa_t225"},
                                   {300.0, "p_kPa_t300"},
                                   {350.0, "p_kPa_t350"}}) {
    ASSERT_NO_FATAL_FAILURE(rain.advance(flow, time, 0.25));
    slope::testing::Curve exact{profiles.column("depth_m"), profiles.column(name)};
    for (double& depth : exact.x) depth = height - depth;
    std::ranges::reverse(exact.x);
    std::ranges::reverse(exact.y);
    worst = std::max(worst, slope::testing::max_relative_error(rain.column_.profile(flow.pressure(), 1.0e-3), exact));
    const double volume = slope::testing::interpolate(cumulative, time);
    worst_volume = std::max(worst_volume, std::abs(rain.budget_.infiltration - volume) / volume);
  }
  using slope::testing::record;
  EXPECT_TRUE(record("rain-1-rigid-ponding", "Rain of 2 k on W2, rigid, 160 particles high: ponding (225.2 s)",
                     slope::testing::near(225.2, 0.03 * 225.2), rain.ponding_, "s"));
  EXPECT_TRUE(record("rain-1-rigid-pressure", "- pressure, 50 to 350 s", slope::testing::at_most(0.02), worst, "%"));
  EXPECT_TRUE(
      record("rain-1-rigid-volume", "- cumulative infiltration", slope::testing::at_most(0.02), worst_volume, "%"));
  EXPECT_NEAR(rain.budget_.rain, 2.0e-5 * 350.0, 1e-12);
  EXPECT_NEAR(rain.budget_.infiltration + rain.budget_.run_off, rain.budget_.rain, 1e-12 * rain.budget_.rain);
  EXPECT_NEAR((flow.stored_water() - before) / rain.column_.width(), rain.budget_.infiltration,
              1e-6 * rain.budget_.infiltration);
}

TEST(RainColumn, BelowTheSaturatedConductivityNeverPonds) {
  Rain rain(0.9 * conductivity, 80);
  PoreFlow flow = rain.flow();
  ASSERT_NO_FATAL_FAILURE(rain.advance(flow, 420.0, 1.0));
  EXPECT_EQ(rain.budget_.run_off, 0.0) << "the column has room for 0.0045 m";
  EXPECT_NEAR(rain.budget_.infiltration, 0.9 * conductivity * 420.0, 1e-12);
}

// A dry column of sandy loam (Carsel and Parrish 1988), 5 m high, whose wetting front is a few centimetres thin.
struct DryColumn {
  static constexpr double conductivity = 0.0442 / 3600.0, time = 3.0 * 3600.0;

  double infiltration = 0.0, run_off = 0.0;  // over what the conductivity takes by gravity alone, and over the rain

  DryColumn(int rows, double intensity) {
    testing::Column column(5.0, rows);
    std::fill(column.particles.porosity.begin(), column.particles.porosity.end(), 0.41);
    Soil soil;
    const SaturationRange range{0.1585, 1.0};
    soil.retention = VanGenuchten{.alpha = 7.5, .n = 1.89, .range = range};
    soil.relative_permeability.law = VanGenuchtenMualem{.n = 1.89, .range = range};
    soil.hydraulic_conductivity = conductivity;
    const std::vector<double> start(column.particles.size(), -15.0e3);
    PoreFlow flow({soil}, Water{}, column.soil(), start, column.particles.skeleton(), column.settings());
    RigidStep water_step;
    Boundary boundary;
    boundary.count = 1;
    for (std::uint32_t i = 0; i < testing::Column::columns; ++i) {
      const double half = 0.5 * column.spacing;
      boundary.open_faces.push_back(
          {column.top(i), 0, intensity * column.spacing, 0.0, -1.0e5, half, half, column.spacing});
    }
    double now = 0.0, step = 1.0;
    while (now < time * (1.0 - 1.0e-12)) {
      const double taken = std::min(step, time - now);
      if (!water_step.advance(flow, taken, column.particles.skeleton(), boundary, 0.1).converged) {
        step = 0.5 * taken;
        if (step > 1.0e-6) continue;
        ADD_FAILURE() << "no step after " << now << " s";
        return;
      }
      now += taken;
      step = std::min(60.0, 1.2 * step);
      infiltration += flow.air_flow().infiltration * taken / column.width() / (conductivity * time);
      run_off += flow.air_flow().run_off * taken / column.width() / (intensity * time);
    }
  }
};

TEST(RainColumn, TakesWhatItConductsHoweverCoarse) {
  for (const int rows : {10, 20, 40, 100}) {
    const DryColumn fed(rows, 0.9 * DryColumn::conductivity);
    EXPECT_LT(fed.run_off, 1.0e-3) << rows;
  }
  double least = 9.0, most = 0.0;
  for (const int rows : {10, 20, 40, 100}) {
    const double taken = DryColumn(rows, 1.4 * DryColumn::conductivity).infiltration;
    least = std::min(least, taken);
    most = std::max(most, taken);
  }
  using slope::testing::record;
  EXPECT_TRUE(record("rain-2-coarse-least",
                     "Rain of 1.4 k on dry sandy loam, 10 to 100 particles in 5 m: infiltration in 3 h over k t, least",
                     {1.0, 1.1}, least, ""));
  EXPECT_TRUE(record("rain-2-coarse-most", "- most", {1.0, 1.1}, most, ""));
}

}  // namespace
}  // namespace slope::seepage
