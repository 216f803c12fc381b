// The factor of safety of slopes that others have published, on 10 cells in their height, beside what they found and
// what circles by Bishop's method find.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "known_factor.hpp"
#include "run_case.hpp"
#include "slope/testing/circular_search.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

double found(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return found_factor(start_case(name, overrides));
}

SlopeSoil::Field everywhere(double value) {
  return [value](double, double) { return value; };
}

constexpr double friction_angle = 20.0 * std::numbers::pi / 180.0;
const SlopeSection on_firm_ground{.toe = {0.0, 0.0}, .crest = {20.0, 10.0}, .base = 0.0};
const SlopeSection over_clay{.toe = {20.0, 10.0}, .crest = {40.0, 20.0}, .base = 0.0};

double circles(const SlopeSection& section, const SlopeSoil::Field& undrained_strength) {
  return critical_circle(section, {20.0e3, everywhere(0.0), undrained_strength, everywhere(0.0)}).factor_of_safety;
}

/// Of the slope of Griffiths and Lane, with water at rest inside and outside up to a level (m).
double circles_in_water(double level) {
  const SlopeSoil soil{20.0e3, everywhere(friction_angle), everywhere(10.0e3), everywhere(0.0), level};
  return critical_circle(on_firm_ground, soil).factor_of_safety;
}

std::vector<std::string> in_water(const std::string& level) {
  return {"initial.water={type: hydrostatic, water_table: " + level + ", maximum_suction: 0 kPa}",
          "water_boundaries=[{name: lake, at: free_surface, initial: true, reservoir: {level: " + level + "}}]"};
}

TEST(KnownSlope, OfGriffithsAndLane) {
  constexpr double published = 1.38;  // by Bishop and Morgenstern's charts
  EXPECT_TRUE(record("known-slope-1",
                     "Slope 1:2 on firm ground (Griffiths and Lane 1999), over Bishop and Morgenstern's",
                     near(1.0, 0.02), found("griffiths_lane.yaml") / published, ""));
}

TEST(KnownSlope, UnderWater) {
  EXPECT_TRUE(record("known-slope-2", "- wholly under water, over the circles' of its buoyant weight", near(1.0, 0.02),
                     found("griffiths_lane.yaml", in_water("10 m")) / circles_in_water(10.0), ""));
}

TEST(KnownSlope, HalfUnderWater) {
  EXPECT_TRUE(record("known-slope-3", "- with water up to its middle, inside and outside", near(1.0, 0.02),
                     found("griffiths_lane.yaml", in_water("5 m")) / circles_in_water(5.0), ""));
}

TEST(KnownSlope, OfTheAcadsSurvey) {
  constexpr double published = 1.0;
  EXPECT_TRUE(record("known-slope-4", "Slope 1:2 of ACADS problem 1(a) (Giam and Donald 1989)", near(1.0, 0.02),
                     found("acads.yaml") / published, ""));
}

// With the dilatancy that limit equilibrium takes for granted.
TEST(KnownSlope, InLayersOfTheAcadsSurvey) {
  constexpr double published = 1.39;
  const std::vector<std::string> associated{"soils.sand.strength.dilatancy_angle=38 deg",
                                            "soils.silt.strength.dilatancy_angle=23 deg",
                                            "soils.clay.strength.dilatancy_angle=20 deg"};
  EXPECT_TRUE(record("known-slope-5", "- in three layers, problem 1(c)", near(1.0, 0.02),
                     found("acads_layers.yaml", associated) / published, ""));
}

TEST(KnownSlope, OfClayOverClay) {
  constexpr double published = 1.47;  // Taylor (1937), by Griffiths and Lane
  EXPECT_TRUE(record("known-slope-6", "Undrained slope 1:2 over as much clay (Taylor 1937)", near(1.0, 0.02),
                     found("deep_clay.yaml") / published, ""));
}

TEST(KnownSlope, OfClayThatIsStrongerBelow) {
  constexpr double at_crest = 10.0e3, rate = 3.0e3;  // Pa, Pa/m
  std::vector<std::string> layers;
  std::string geometry;
  const auto corner = [](int x, int y) { return "[" + std::to_string(x) + " m, " + std::to_string(y) + " m]"; };
  for (int below = 0; below < 20; ++below) {
    const std::string name = "layer_" + std::to_string(below);
    layers.push_back("soils." + name +
                     "={youngs_modulus: 100 MPa, poissons_ratio: 0.3, porosity: 0.35, grain_density: 2598.055 kg/m3, "
                     "hydraulic_conductivity: 1e-9 m/s, retention: {model: van_genuchten, alpha: 0.05 1/m, n: 3, "
                     "residual_saturation: 0, maximum_saturation: 1}, "
                     "relative_permeability: {model: hillel, exponent: 2}, strength: {model: von_mises, "
                     "undrained_strength: " +
                     std::to_string(at_crest + rate * (below + 0.5)) + " Pa}}");
    const int top = 20 - below, base = top - 1;
    geometry += (below == 0 ? "" : ", ") + ("{soil: " + name) + ", polygon: [" +
                corner(base < 10 ? 0 : 2 * base, base) + ", " + corner(70, base) + ", " + corner(70, top) + ", " +
                corner(top <= 10 ? 0 : 2 * top, top) + "]}";
  }
  layers.push_back("geometry=[" + geometry + "]");
  const double right = circles(over_clay, [](double, double y) { return at_crest + rate * (20.0 - y); });
  EXPECT_TRUE(record("known-slope-7", "- whose strength grows with depth, in layers, over the circles'",
                     near(1.0, 0.02), found("deep_clay.yaml", layers) / right, ""));
}

}  // namespace
}  // namespace slope::testing
