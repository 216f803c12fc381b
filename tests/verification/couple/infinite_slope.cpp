// A long slope under rain, against the infinite-slope formula: when and how deep it begins to fail.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "run_case.hpp"
#include "slope/testing/curve.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

constexpr double cell = 0.4;                                   // m
const double inclination = std::atan((11.6376 - 2.4) / 16.0);  // of the ground in cases/rain/infinite-slope.yaml

// Between two places (m); the ground at the start is a line.
struct Strip {
  double from, to;
  double ground, gradient;  // y at x = 0 (m), tangent of its inclination
  double suction = 1.0;     // that counts over the one in the run
};
const Strip mid_slope{7.0, 9.0, 2.4, std::tan(inclination)};  // 8 m, six times the depth of the slide, from the ends
// Along a slope nothing changes, so that the suction's gradient is normal to it and 1 / cos^2 b times as steep as in
// level ground of the same suctions over the vertical depth. Level ground wets alike if its suctions are 1 / cos^2 b
// times larger and its curves are drawn out as much.
const double drawn_out = 1.0 / std::pow(std::cos(inclination), 2);
const Strip column{0.0, 0.8, 2.4, 0.0, 1.0 / drawn_out};

// Mean over a cell of depth, the least that the grid can shear; layers overlap by half.
struct Layer {
  double depth = 0.0;  // vertical (m)
  double factor_of_safety = 0.0, plastic_strain = 0.0;
  int particles = 0;
};

// FS = [c(s) + (gamma z cos^2 b + S_r s) tan(phi)] / (gamma z sin b cos b), with the strength of Eq. 15 and the
// effective stress of Eq. 2; `overburden` is gamma z (Pa).
double factor_of_safety(const solid::MohrCoulomb& soil, double overburden, double suction, double saturation) {
  const double cohesion =
      soil.cohesion -
      soil.maximum_cohesion_increase * std::expm1(-soil.cohesion_suction_rate * std::max(suction, 0.0) / 101325.0);
  const double sine = std::sin(inclination), cosine = std::cos(inclination);
  const double normal = overburden * cosine * cosine + saturation * suction;
  return (cohesion + normal * std::tan(soil.friction_angle)) / (overburden * sine * cosine);
}

// From the surface down, the soil that can yield. Places are those of the start.
std::vector<Layer> layers(const couple::Case& input, const couple::ParticleTable& table, const Strip& strip) {
  const couple::Soil& soil = input.soils.front();
  const auto& strength = std::get<solid::MohrCoulomb>(soil.solid.strength);
  constexpr double spacing = 0.5 * cell;
  const auto start = [&](std::size_t p, std::size_t d) { return table.position[p][d] - table.displacement[p][d]; };
  std::map<int, std::vector<std::size_t>> columns;
  for (std::size_t p = 0; p < table.position.size(); ++p) {
    if (table.soil[p] != 0 || start(p, 0) < strip.from || start(p, 0) > strip.to) continue;
    columns[static_cast<int>(start(p, 0) / spacing)].push_back(p);
  }
  std::vector<Layer> layers;
  for (auto& [number, particles] : columns) {
    std::ranges::sort(particles, [&](std::size_t a, std::size_t b) { return start(a, 1) > start(b, 1); });
    double above = 0.0;
    for (const std::size_t p : particles) {
      const double density = (1.0 - table.porosity[p]) * soil.solid.grain_density +
                             table.porosity[p] * table.saturation[p] * input.water.density;
      const double own = density * input.gravity * table.volume[p] / spacing;
      const double depth = strip.ground + strip.gradient * start(p, 0) - start(p, 1);
      const auto k = static_cast<std::size_t>(depth / spacing);
      if (k + 1 >= layers.size()) layers.resize(k + 2);
      for (const std::size_t layer : {k, k + 1}) {
        layers[layer].depth = static_cast<double>(layer) * spacing;
        layers[layer].factor_of_safety +=
            factor_of_safety(strength, above + 0.5 * own, strip.suction * table.suction[p], table.saturation[p]);
        layers[layer].plastic_strain += table.plastic_strain[p];
        ++layers[layer].particles;
      }
      above += own;
    }
  }
  for (Layer& layer : layers) {
    layer.factor_of_safety /= layer.particles;
    layer.plastic_strain /= layer.particles;
  }
  return layers;
}

// When and where a figure of the layers first passed a limit; linear in time.
class Passing {
 public:
  Passing(double limit, double initial) : limit_(limit), before_(initial) {}

  void add(double time, double value, double depth) {
    if (!at_ && (value - limit_) * (before_ - limit_) <= 0.0) {
      at_ = time_before_ + (time - time_before_) * (limit_ - before_) / (value - before_);
      depth_ = depth;
    }
    time_before_ = time;
    before_ = value;
  }
  [[nodiscard]] double time() const { return at_.value(); }  // (s)
  [[nodiscard]] double depth() const { return depth_; }      // (m)

 private:
  double limit_, before_, time_before_ = 0.0, depth_ = 0.0;
  std::optional<double> at_;
};

struct Failure {
  Curve factor;                   // the lowest by the formula, over time
  Passing unsafe{1.0, 2.0};       // where it passes 1
  Passing shear{1.0e-3, 0.0};     // plastic strain: 0.6 mm of shear over a cell
  double depth_of_largest_shear;  // at the end (m)
};

// Above that, what little strength the soil has there yields as the rain swells it.
constexpr double skin = 0.5;  // m

Failure failure(couple::Simulation simulation, const Strip& strip) {
  Failure found{};
  run(simulation, [&](const couple::ParticleTable& table) {
    const std::vector<Layer> all = layers(simulation.input(), table, strip);
    const Layer weakest = *std::ranges::min_element(all, {}, &Layer::factor_of_safety);
    const Layer sheared = *std::ranges::max_element(
        all, {}, [](const Layer& layer) { return layer.depth < skin ? -1.0 : layer.plastic_strain; });
    found.factor.x.push_back(table.time);
    found.factor.y.push_back(weakest.factor_of_safety);
    found.unsafe.add(table.time, weakest.factor_of_safety, weakest.depth);
    found.shear.add(table.time, sheared.plastic_strain, sheared.depth);
    found.depth_of_largest_shear = sheared.depth;
  });
  return found;
}

TEST(InfiniteSlope, FailsWhenAndWhereTheFormulaSays) {
  const std::string end = "stop.time=11 h";
  const Failure slope = failure(start_shipped_case("rain/infinite-slope.yaml", {end}), mid_slope);
  EXPECT_TRUE(record("infinite-slope-1",
                     "Long slope under rain: infinite-slope factor of safety when it begins to shear", {0.95, 1.0},
                     interpolate(slope.factor, slope.shear.time()), ""));
  const double depth = slope.unsafe.depth();
  EXPECT_TRUE(record("infinite-slope-2", "- depth of that shear (by the formula 1 m; cells of 0.4 m)",
                     near(depth, cell), slope.shear.depth(), "m"));
  EXPECT_TRUE(record("infinite-slope-3", "- depth of the largest shear after 11 h", near(depth, cell),
                     slope.depth_of_largest_shear, "m"));
  // the formula on level ground under the same rain, by the water alone
  const std::string alpha = std::to_string(4.0 / drawn_out) + " 1/m";
  const Failure level =
      failure(start_shipped_case(
                  "rain/infinite-slope.yaml",
                  {end, "domain.upper=[0.8 m, 4 m]", "coupling.scheme=seepage", "points={}",
                   "soils.silty_sand.retention.alpha=" + alpha, "soils.bedrock.retention.alpha=" + alpha,
                   "initial.water.pressure=" + std::to_string(-20.0 * drawn_out) + " kPa",
                   "geometry=[{soil: silty_sand, polygon: [[0 m, 0 m], [0.8 m, 0 m], [0.8 m, 2.4 m], [0 m, 2.4 m]]}]"}),
              column);
  EXPECT_TRUE(record("infinite-slope-4", "- time of factor 1 on a level column that wets alike, over the slope's",
                     near(1.0, 0.05), level.unsafe.time() / slope.unsafe.time(), ""));
}

}  // namespace
}  // namespace slope::testing
