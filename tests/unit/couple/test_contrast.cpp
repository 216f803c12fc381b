// The warning of a soil that is thin, in cells, beside one that bears much more.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "case_folder.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

/// Clay under clay under clay, 20 m wide, on cells of a size.
class Contrast : public testing::Test {
 protected:
  [[nodiscard]] std::vector<Problem> warnings(const std::string& above, const std::string& strength,
                                              const std::string& below, double bottom, double top, double cell = 1.0) {
    const auto soil = [](const char* name, const std::string& is) {
      return fmt::format(
          "  {}: {{youngs_modulus: 10 MPa, poissons_ratio: 0.3, porosity: 0.35, grain_density: 2700 kg/m3, strength: "
          "{}, "
          "hydraulic_conductivity: 1e-9 m/s, retention: {{model: van_genuchten, alpha: 0.05 1/m, n: 3, "
          "residual_saturation: 0, maximum_saturation: 1}}, relative_permeability: {{model: hillel, exponent: 2}}}}\n",
          name, is);
    };
    const auto layer = [](const char* name, double from, double to) {
      if (to <= from) return std::string();
      return fmt::format("  - {{soil: {0}, polygon: [[0 m, {1} m], [20 m, {1} m], [20 m, {2} m], [0 m, {2} m]]}}\n",
                         name, from, to);
    };
    const auto file = folder_.write(
        "layers.yaml",
        fmt::format("title: layers\ndomain: {{lower: [0 m, 0 m], upper: [20 m, 20 m], cell_size: {} m, "
                    "particles_per_cell: 4}}\nwalls: {{left: roller, right: roller, base: fixed}}\nsoils:\n",
                    cell) +
            soil("above", above) + soil("middle", strength) + soil("below", below) + "geometry:\n" +
            layer("below", 0.0, bottom) + layer("middle", bottom, top) + layer("above", top, 16.0) +
            "initial: {water: {type: uniform, pressure: 0 kPa}}\ncoupling: {skeleton: rigid, mixture_density: "
            "saturated}\nstop: {time: 1 s}\n");
    std::vector<Problem> told;
    (void)read_case(file, {}, &told);
    return told;
  }

  [[nodiscard]] static std::string clay(double strength) {
    return fmt::format("{{model: von_mises, undrained_strength: {} kPa}}", strength);
  }
  static constexpr const char* sand =
      "{model: mohr_coulomb, cohesion: 0 kPa, friction_angle: 35 deg, dilatancy_angle: 0 deg}";

 private:
  CaseFolder folder_;
};

TEST_F(Contrast, OfAThinSeamIsTold) {
  const auto told = warnings(clay(90), clay(30), clay(90), 6.0, 8.0);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].key, "geometry");
  EXPECT_NE(
      told[0].message.find("the soil middle at x = 10.25 m is 2 cells thick in below, which bears 3 times as much"),
      std::string::npos)
      << told[0].message;
  EXPECT_NE(told[0].message.find("take cells of 0.5 m or less"), std::string::npos) << told[0].message;
}

TEST_F(Contrast, OfSoilOverFirmGroundIsTold) {
  const auto told = warnings(clay(30), clay(30), clay(90), 6.0, 8.0);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].message.find("the soil middle at x = 10.25 m is 2 cells thick over below"), std::string::npos)
      << told[0].message;
  const auto rock = warnings(clay(30), clay(30), "{model: elastic}", 6.0, 16.0);
  ASSERT_EQ(rock.size(), 1u);
  EXPECT_NE(rock[0].message.find("below, which never yields"), std::string::npos) << rock[0].message;
}

// Sand bears little near its top and much below.
TEST_F(Contrast, CountsAtTheDepthOfTheFace) {
  EXPECT_EQ(warnings(sand, clay(20), sand, 6.0, 8.0).size(), 1u) << "8 m of sand above";
  const auto skin = warnings(sand, clay(20), sand, 15.0, 15.5);
  ASSERT_EQ(skin.size(), 1u) << "half a metre of sand above";
  EXPECT_NE(skin[0].message.find("the soil above"), std::string::npos) << skin[0].message;
}

TEST_F(Contrast, IsNotToldWhereItHardlyMatters) {
  EXPECT_TRUE(warnings(clay(40), clay(30), clay(40), 6.0, 8.0).empty()) << "nearly as strong";
  EXPECT_TRUE(warnings(clay(90), clay(30), clay(90), 4.0, 12.0).empty()) << "8 cells thick";
  EXPECT_TRUE(warnings(clay(90), clay(30), clay(30), 6.0, 14.0).empty()) << "a crust";
  const char* elastic = "{model: elastic}";
  EXPECT_TRUE(warnings(elastic, elastic, elastic, 6.0, 8.0).empty()) << "none of them yields";
  EXPECT_TRUE(warnings(clay(90), clay(30), clay(90), 6.0, 8.0, 0.25).empty()) << "fine cells";
}

}  // namespace
}  // namespace slope::couple::test
