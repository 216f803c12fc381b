// What the laws cannot take is refused where it is given, by the name of its field.

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "particles.hpp"
#include "slope/seepage/free_surface.hpp"
#include "slope/seepage/pore_flow.hpp"
#include "slope/seepage/two_pass_operator.hpp"

namespace slope::seepage {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// All that a flow is made of, good as it stands.
struct Ingredients {
  std::vector<Soil> soils{{.retention = VanGenuchten{.alpha = 0.5, .n = 3.0, .range = {}},
                           .relative_permeability = {.law = HillelPower{}},
                           .hydraulic_conductivity = 1.0e-5},
                          {.retention = ExponentialRetention{.alpha = 1.0, .range = {}},
                           .relative_permeability = {.law = VanGenuchtenMualem{.n = 2.0, .range = {}}},
                           .hydraulic_conductivity = 1.0e-6}};
  Water water;
  std::vector<std::uint16_t> soil{0, 1, 0, 1};
  std::vector<double> pressure{0.0, 1.0, 2.0, -3.0};
  testing::Particles particles = testing::lattice(2, 2, 0.1);
  FlowSettings settings{.spacing = 0.1, .walls = {}};

  [[nodiscard]] PoreFlow flow() const { return {soils, water, soil, pressure, particles.skeleton(), settings}; }
};

std::string refusal(const std::function<void()>& build) {
  try {
    build();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "taken";
}

struct Wrong {
  std::string message;
  std::function<void(Ingredients&)> spoil;
};

TEST(PoreFlow, RefusesWhatTheLawsCannotTake) {
  EXPECT_NO_THROW((void)Ingredients{}.flow());
  const auto retention = [](const Retention& law) {
    return [law](Ingredients& given) { given.soils[1].retention = law; };
  };
  const auto permeability = [](const auto& law) {
    return [law](Ingredients& given) { given.soils[1].relative_permeability.law = law; };
  };
  const std::vector<Wrong> all{
      {"soils[1].retention.alpha must be above 0, got 0", retention(VanGenuchten{.alpha = 0.0, .n = 2.0, .range = {}})},
      {"soils[1].retention.n must be above 1, got 1", retention(VanGenuchten{.alpha = 1.0, .n = 1.0, .range = {}})},
      {"soils[1].retention.n must be above 1, got nan", retention(VanGenuchten{.alpha = 1.0, .n = nan, .range = {}})},
      {"soils[1].retention.alpha must be above 0, got inf",
       retention(VanGenuchten{.alpha = infinity, .n = 2.0, .range = {}})},
      {"soils[1].retention.air_entry must be at least 0, got -0.1",
       retention(VanGenuchten{.alpha = 1.0, .n = 2.0, .range = {}, .air_entry = -0.1})},
      {"soils[1].retention.range.maximum must be above 0 and at most 1, got 1.2",
       retention(VanGenuchten{.alpha = 1.0, .n = 2.0, .range = {0.0, 1.2}})},
      {"soils[1].retention.range.residual must be at least 0 and below range.maximum, got 0.9",
       retention(ExponentialRetention{.alpha = 1.0, .range = {0.9, 0.8}})},
      {"soils[1].retention.alpha must be above 0, got -1", retention(ExponentialRetention{.alpha = -1.0, .range = {}})},
      {"soils[1].retention.coefficient must be above 0, got 0", retention(LiakopoulosRetention{.coefficient = 0.0})},
      {"soils[1].retention.exponent must be above 1, got 1", retention(LiakopoulosRetention{.exponent = 1.0})},
      {"soils[1].retention.floor must be at least 0 and below 1, got 1", retention(LiakopoulosRetention{.floor = 1.0})},
      {"soils[1].relative_permeability.n must be above 1, got 0.5",
       permeability(VanGenuchtenMualem{.n = 0.5, .range = {}})},
      {"soils[1].relative_permeability.entry_saturation must be above 0 and at most 1, got 0",
       permeability(VanGenuchtenMualem{.n = 2.0, .range = {}, .entry_saturation = 0.0})},
      {"soils[1].relative_permeability.exponent must be above 0, got 0", permeability(HillelPower{.exponent = 0.0})},
      {"soils[1].relative_permeability.alpha must be above 0, got 0", permeability(ExponentialPermeability{})},
      {"soils[1].relative_permeability.coefficient must be above 0, got nan",
       permeability(LiakopoulosPermeability{.coefficient = nan})},
      {"soils[1].relative_permeability.exponent must be above 0, got -1",
       permeability(LiakopoulosPermeability{.exponent = -1.0})},
      {"soils[0].relative_permeability.floor must be above 0 and below 1, got 0",
       [](Ingredients& given) { given.soils[0].relative_permeability.floor = 0.0; }},
      {"soils[0].hydraulic_conductivity must be above 0, got 0",
       [](Ingredients& given) { given.soils[0].hydraulic_conductivity = 0.0; }},
      {"soils must be one at least, got 0", [](Ingredients& given) { given.soils.clear(); }},
      {"density must be above 0, got 0", [](Ingredients& given) { given.water.density = 0.0; }},
      {"bulk_modulus must be above 0, got nan", [](Ingredients& given) { given.water.bulk_modulus = nan; }},
      {"gravity must be above 0, got -9.81", [](Ingredients& given) { given.water.gravity = -9.81; }},
      {"soil must be an index into soils, got 2", [](Ingredients& given) { given.soil[3] = 2; }},
      {"soil must be one for each particle, got 3", [](Ingredients& given) { given.soil.pop_back(); }},
      {"pressure must be a number, got nan", [](Ingredients& given) { given.pressure[2] = nan; }},
      {"pressure must be one for each particle, got 3", [](Ingredients& given) { given.pressure.pop_back(); }},
      {"x must be a number, got nan", [](Ingredients& given) { given.particles.x[0] = nan; }},
      {"y must be one for each particle, got 3", [](Ingredients& given) { given.particles.y.pop_back(); }},
      {"volume must be above 0, got 0", [](Ingredients& given) { given.particles.volume[1] = 0.0; }},
      {"porosity must be above 0 and below 1, got -0.1",
       [](Ingredients& given) { given.particles.porosity[1] = -0.1; }},
      {"porosity must be above 0 and below 1, got 1", [](Ingredients& given) { given.particles.porosity[1] = 1.0; }},
      {"spacing must be above 0, got 0", [](Ingredients& given) { given.settings.spacing = 0.0; }},
      {"smoothing_ratio must be above 0, got nan", [](Ingredients& given) { given.settings.smoothing_ratio = nan; }},
      {"threads must be at least 1, got 0", [](Ingredients& given) { given.settings.threads = 0; }},
      {"walls.right must be above walls.left, got nan", [](Ingredients& given) { given.settings.walls.right = nan; }},
      {"walls.top must be above walls.base, got 0",
       [](Ingredients& given) { given.settings.walls.top = given.settings.walls.base = 0.0; }},
  };
  for (const Wrong& wrong : all) {
    Ingredients given;
    wrong.spoil(given);
    EXPECT_EQ(refusal([&] { (void)given.flow(); }), wrong.message);
  }
}

TEST(Constructors, RefuseWhatTheyCannotTake) {
  EXPECT_EQ(refusal([] { FreeSurface(0.0, {}); }), "spacing must be above 0, got 0");
  EXPECT_EQ(refusal([] { TwoPassOperator(nan, 1.2, {}); }), "spacing must be above 0, got nan");
  EXPECT_EQ(refusal([] { TwoPassOperator(0.1, 0.0, {}); }), "smoothing_ratio must be above 0, got 0");
  EXPECT_EQ(refusal([] { HeadOperator(-0.1, 1.2, {}, 1); }), "spacing must be above 0, got -0.1");
  EXPECT_EQ(refusal([] { (void)ConductivityCurve(Soil{}); }), "retention.alpha must be above 0, got 0");
}

}  // namespace
}  // namespace slope::seepage
