// Where two soils meet: flow in series through a seam, water perched on it, and a capillary barrier.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

constexpr double height = 2.4, seam_thickness = 0.3, head_fall = 1.6;  // m
constexpr double loam = 0.0442 / 3600.0, clay = 0.002 / 3600.0;        // m/s

// Fixed heads drive dH / sum(d / k) through layers.
double flow_in_series(double around, double seam) {
  return head_fall / ((height - seam_thickness) / around + seam_thickness / seam);
}

// The block twice as wide as a cell, with so many particles in the seam.
std::vector<std::string> with_particles(int in_seam) {
  const std::string cell = std::to_string(2.0 * seam_thickness / in_seam),
                    width = std::to_string(4.0 * seam_thickness / in_seam);
  const auto block = [&](const char* soil, const char* from, const char* to) {
    return std::string("{soil: ") + soil + ", polygon: [[0 m, " + from + "], [" + width + " m, " + from + "], [" +
           width + " m, " + to + "], [0 m, " + to + "]]}";
  };
  return {"domain.cell_size=" + cell + " m", "domain.upper=[" + width + " m, 3 m]",
          "geometry=[" + block("loam", "0 m", "2.4 m") + ", " + block("seam", "1.2 m", "1.5 m") + "]"};
}

// Flow per area out of the base in the last step.
double flux(const couple::Simulation& simulation, double since, double outflow_since, int in_seam) {
  const couple::Summary summary = simulation.summary();
  return (summary.water.outflow - outflow_since) / (summary.time - since) / (4.0 * seam_thickness / in_seam);
}

double steady_flux(std::vector<std::string> overrides, int in_seam, std::size_t* steps = nullptr) {
  for (const std::string& text : with_particles(in_seam)) overrides.push_back(text);
  couple::Simulation simulation = start_case("seam.yaml", overrides);
  double since = 0.0, outflow = 0.0;
  for (couple::Event event; !event.finished;) {
    if (simulation.progress().time < 0.75 * simulation.input().stop.time) {
      since = simulation.progress().time;
      outflow = simulation.progress().water.outflow;
    }
    event = simulation.advance();
  }
  if (steps != nullptr) *steps = simulation.summary().steps;
  return flux(simulation, since, outflow, in_seam);
}

TEST(Seam, ConductsInSeries) {
  const double exact = flow_in_series(loam, clay);
  double worst = 0.0;
  std::size_t most_steps = 0, steps = 0;
  for (const int in_seam : {2, 4, 6, 8}) {
    worst = std::max(worst, std::abs(steady_flux({}, in_seam, &steps) / exact - 1.0));
    most_steps = std::max(most_steps, steps);
  }
  EXPECT_TRUE(record("seam-1", "Clay seam of 2 to 8 particles in sandy loam, saturated flow, off dH / sum(d / k)",
                     at_most(0.01), worst, "%"));
  std::size_t alone = 0;
  static_cast<void>(steady_flux({"soils.seam.hydraulic_conductivity=4.42 cm/h"}, 2, &alone));
  EXPECT_TRUE(record("seam-2", "- steps, over those of one soil", at_most(2.0),
                     static_cast<double>(most_steps) / static_cast<double>(alone), ""));
}

TEST(Seam, ConductsInSeriesWhateverTheContrast) {
  double worst = 0.0;
  for (const double contrast : {1.0e-6, 1.0e-3, 0.5, 2.0, 1.0e3, 1.0e6}) {
    const std::string seam = "soils.seam.hydraulic_conductivity=" + std::to_string(4.42 / contrast) + " cm/h";
    const double conductivity = std::stod(std::to_string(4.42 / contrast)) / 360000.0;
    const double exact = flow_in_series(loam, conductivity);
    worst = std::max(worst, std::abs(steady_flux({seam, "soils.seam.retention.air_entry=0 m"}, 2) / exact - 1.0));
  }
  EXPECT_TRUE(record("seam-3", "- contrasts of 2 to 1e6, the seam tighter or more open", at_most(0.01), worst, "%"));
}

// Before the start it flows already; the soil then stays where it is.
TEST(Seam, ConductsInSeriesInTheCoupledScheme) {
  double worst = 0.0;
  for (const int in_seam : {2, 4}) {
    const double found =
        steady_flux({"coupling.scheme=semi_implicit", "initial.stress=self_weight",
                     "initial.water={type: steady, water_table: 2.4 m}", "water_boundaries.0.initial=true",
                     "water_boundaries.1.initial=true", "stop.time=6 min", "output.history_interval=1 min"},
                    in_seam);
    worst = std::max(worst, std::abs(found / flow_in_series(loam, clay) - 1.0));
  }
  EXPECT_TRUE(
      record("seam-4", "- in the coupled scheme, with a steady state before the start", at_most(0.01), worst, "%"));
}

// Rain between the conductivities perches on the seam. Its head at the top of the seam is the integral of
// dpsi/dz = q / K(psi) - 1 from psi = 0 at the base, 1.2 m of sandy loam and 0.3 m of clay further up: by Runge and
// Kutta's method (scipy, LSODA, 1e-9).
TEST(Seam, BearsAPerchedHead) {
  struct Perched {
    const char* rain;
    double flux, head;
  };
  double worst = 0.0;
  for (const Perched& perched : {Perched{"1e-6 m/s", 1.0e-6, 0.177893}, Perched{"1.5e-6 m/s", 1.5e-6, 0.446509},
                                 Perched{"2e-6 m/s", 2.0e-6, 0.719375}}) {
    const couple::Simulation simulation = start_case(
        "seam.yaml",
        {"initial.water={type: steady, water_table: 0 m}",
         std::string("water_boundaries=[{name: base, at: base, total_head: 0 m, applied_to: face, initial: true}, "
                     "{name: rain, at: free_surface, initial: true, rain: {intensity: ") +
             perched.rain + "}}]"});
    const couple::ParticleTable table = simulation.particles();
    double head = 0.0;  // at the top of the seam, half a spacing of saturated sandy loam below the particle
    for (std::size_t p = 0; p < table.position.size(); ++p) {
      if (std::abs(table.position[p][1] - 1.575) > 0.01) continue;
      head = table.pore_pressure[p] / 9810.0 - 0.075 * (perched.flux / loam - 1.0);
    }
    worst = std::max(worst, std::abs(head / perched.head - 1.0));
  }
  EXPECT_TRUE(record("seam-5", "Head perched on a clay seam of 2 particles under rain, steady, exact", at_most(0.02),
                     worst, "%"));
}

// The steady state of a slope with a lens that conducts less than the rain: what falls on 0.8 m comes out.
TEST(Seam, IsSteadyUnderALensInASlope) {
  couple::Simulation simulation = start_case("perched.yaml");
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::WaterBudget water = simulation.summary().water;
  const double rain = 7.0e-5 * 0.8 * 0.01;
  EXPECT_NEAR(water.infiltration, rain, 1e-3 * rain);
  EXPECT_NEAR(water.outflow, rain, 1e-3 * rain);
}

// Loam over gravel, both at 2 m of suction, under 10 mm a day: an independent finite-volume solution of Richards'
// equation on cells of 1 and 2 cm lets nothing out until day 11 and 36.46 to 36.48 mm until day 15; another 36.7 to
// 37.0 mm.
TEST(Seam, IsACapillaryBarrier) {
  couple::Simulation simulation = start_case(
      "seam.yaml",
      {"domain={lower: [0 m, 0 m], upper: [0.4 m, 1.6 m], cell_size: 0.2 m, particles_per_cell: 4}",
       "soils.loam.porosity=0.43", "soils.loam.hydraulic_conductivity=1.04 cm/h",
       "soils.loam.retention={model: van_genuchten, alpha: 3.6 1/m, n: 1.56, residual_saturation: 0.1814, "
       "maximum_saturation: 1}",
       "soils.seam.porosity=0.35", "soils.seam.hydraulic_conductivity=1e-2 m/s",
       "soils.seam.retention={model: van_genuchten, alpha: 50 1/m, n: 4, residual_saturation: 0.02, "
       "maximum_saturation: "
       "1}",
       "soils.seam.relative_permeability={model: van_genuchten_mualem}",
       "geometry=[{soil: loam, polygon: [[0 m, 0.6 m], [0.4 m, 0.6 m], [0.4 m, 1.2 m], [0 m, 1.2 m]]}, {soil: seam, "
       "polygon: [[0 m, 0 m], [0.4 m, 0 m], [0.4 m, 0.6 m], [0 m, 0.6 m]]}]",
       "initial.water={type: uniform, pressure: -19.62 kPa}",
       "water_boundaries=[{name: rain, at: free_surface, rain: {intensity: 10 mm/d}}, {name: drain, at: base, "
       "free_drainage: true}]",
       "stop.time=15 d", "output.history_interval=1 d", "output.snapshots=[10 d]"});
  bool at_ten_days = true;
  run(simulation, [&](const couple::ParticleTable&) {
    const double out = simulation.summary().water.outflow / 0.4;
    if (at_ten_days) {
      EXPECT_TRUE(
          record("capillary-barrier-1", "Capillary barrier, leaked in 10 days", at_most(0.2), 1000.0 * out, "mm"));
    }
    at_ten_days = false;
  });
  EXPECT_TRUE(record("capillary-barrier-2", "- and in 15 days, finite volumes", near(36.85, 0.02 * 36.85),
                     1000.0 * simulation.summary().water.outflow / 0.4, "mm"));
}

}  // namespace
}  // namespace slope::testing
