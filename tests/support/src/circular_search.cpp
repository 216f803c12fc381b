#include "slope/testing/circular_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace slope::testing {
namespace {

constexpr double water_weight = 9810.0;  // N/m3
constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr int slices = 60;
constexpr int grid_points = 13;    // of each of the three coordinates
constexpr int narrowings = 12;     // the last grid is a 1/2000 of the first
constexpr double narrowed = 0.55;  // overlaps the neighbours of the best point

double ground(const SlopeSection& section, double x) {
  const double share = std::clamp((x - section.toe[0]) / (section.crest[0] - section.toe[0]), 0.0, 1.0);
  return section.toe[1] + share * (section.crest[1] - section.toe[1]);
}

// The lower arc between two points of the ground. `sag` is its height over the chord's length. None: the arc would
// overhang, cut the firm ground, or run out of the ground in between.
std::optional<SlipCircle> circle_through(const SlopeSection& section, double left, double right, double sag) {
  const double y_left = ground(section, left), y_right = ground(section, right);
  const double run = right - left, rise = y_right - y_left, chord = std::hypot(run, rise);
  if (!(run > 0.0) || !(sag > 0.0)) return std::nullopt;
  const double radius = chord * (0.25 / sag + sag) / 2.0;
  const double above_chord = radius - sag * chord;
  SlipCircle circle{
      unlimited,
      {0.5 * (left + right) - above_chord * rise / chord, 0.5 * (y_left + y_right) + above_chord * run / chord},
      radius};
  if (circle.centre[1] < y_right) return std::nullopt;
  if (circle.centre[0] > left && circle.centre[1] - radius < section.base) return std::nullopt;
  return circle;
}

struct Slice {
  double driving;     // W sin(alpha) (N/m)
  double frictional;  // (W - u b) tan(phi) (N/m)
  double cohesive;    // c b (N/m)
  double cosine, sine;
  double friction;  // tan(phi)
};

// F = sum of (c b + (W - u b) tan phi) / m_alpha over the sum of W sin(alpha), m_alpha = cos(alpha) + sin(alpha)
// tan(phi) / F
double factor_of_safety(const std::vector<Slice>& cut) {
  double driving = 0.0;
  for (const Slice& slice : cut) driving += slice.driving;
  if (!(driving > 0.0)) return unlimited;
  double factor = 1.0;
  for (int k = 0; k < 100; ++k) {
    double resisting = 0.0;
    for (const Slice& slice : cut) {
      const double m_alpha = slice.cosine + slice.sine * slice.friction / factor;
      if (m_alpha < 0.2) return unlimited;  // where the method does not hold: steep passive ends
      resisting += (slice.cohesive + std::max(slice.frictional, 0.0)) / m_alpha;
    }
    const double next = resisting / driving;
    if (std::abs(next - factor) < 1.0e-6) return next;
    factor = next;
  }
  return factor;
}

double factor_of_safety(const SlopeSection& section, const SlopeSoil& soil, const SlipCircle& circle, double left,
                        double right) {
  const double width = (right - left) / slices;
  std::vector<Slice> cut;
  cut.reserve(slices);
  for (int i = 0; i < slices; ++i) {
    const double x = left + (i + 0.5) * width, sine = (x - circle.centre[0]) / circle.radius;
    const double cosine = std::sqrt(1.0 - sine * sine), y = circle.centre[1] - circle.radius * cosine;
    const double height = ground(section, x) - y;
    if (height < 0.0) return unlimited;
    const double in_water = std::clamp(soil.water_level - y, 0.0, height);
    const double weight = (soil.unit_weight * height - water_weight * in_water) * width;
    const double friction = std::tan(soil.friction_angle(x, y));
    cut.push_back({weight * sine, (weight - soil.pore_stress(x, y) * width) * friction, soil.cohesion(x, y) * width,
                   cosine, sine, friction});
  }
  return factor_of_safety(cut);
}

}  // namespace

SlipCircle critical_circle(const SlopeSection& section, const SlopeSoil& soil) {
  const double height = section.crest[1] - section.toe[1];
  const std::array<double, 3> lowest{section.toe[0] - 2.0 * height, section.toe[0] + 0.05 * height, 0.01};
  const std::array<double, 3> highest{section.crest[0] - 0.05 * height, section.crest[0] + 2.0 * height, 0.5};
  std::array<double, 3> middle{}, half{};  // where the circle comes out, where it begins, its sag
  for (std::size_t d = 0; d < 3; ++d) {
    middle[d] = 0.5 * (lowest[d] + highest[d]);
    half[d] = 0.5 * (highest[d] - lowest[d]);
  }
  SlipCircle best{.factor_of_safety = unlimited};
  for (int k = 0; k < narrowings; ++k) {
    const std::array<double, 3> around = middle;
    const auto coordinate = [&](std::size_t d, int i) {
      return std::clamp(around[d] + half[d] * (2.0 * i / (grid_points - 1) - 1.0), lowest[d], highest[d]);
    };
    for (int a = 0; a < grid_points; ++a) {
      for (int b = 0; b < grid_points; ++b) {
        for (int c = 0; c < grid_points; ++c) {
          const std::array<double, 3> at{coordinate(0, a), coordinate(1, b), coordinate(2, c)};
          std::optional<SlipCircle> circle = circle_through(section, at[0], at[1], at[2]);
          if (!circle) continue;
          circle->factor_of_safety = factor_of_safety(section, soil, *circle, at[0], at[1]);
          if (circle->factor_of_safety < best.factor_of_safety) {
            best = *circle;
            middle = at;
          }
        }
      }
    }
    for (double& width : half) width *= narrowed;
  }
  return best;
}

}  // namespace slope::testing
