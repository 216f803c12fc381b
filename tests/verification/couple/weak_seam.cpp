#include "weak_seam.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "known_factor.hpp"
#include "run_case.hpp"

namespace slope::testing {

namespace {

using Corner = std::array<double, 2>;

constexpr double dip = 20.0 * std::numbers::pi / 180.0;
constexpr double length = 16.0, height = 5.0, height_at_ends = 0.5;               // m
constexpr double undrained_strength = 40.0e3;                                     // Pa
constexpr double unit_weight = 9.81 * ((1.0 - 0.35) * 2598.055 + 0.35 * 1000.0);  // N/m3

// A place along the seam's bottom and normal to it.
Corner at(double along, double up) {
  const double c = std::cos(dip), s = std::sin(dip);
  return {4.3 + along * c - up * s, 2.0 + along * s + up * c};
}

std::string region(const char* soil, const std::vector<Corner>& corners) {
  std::string text;
  for (const Corner& corner : corners) {
    text += fmt::format("{}[{:.6f} m, {:.6f} m]", text.empty() ? "" : ", ", corner[0], corner[1]);
  }
  return fmt::format("{{soil: {}, polygon: [{}]}}", soil, text);
}

}  // namespace

double WeakSeam::found() const {
  const double t = thickness;
  const Corner foot = at(0.0, 0.0);
  const double rise = std::tan(dip);
  const double drop = stands_free ? 1.5 : 0.0;
  const auto surface = [&](double x) { return foot[1] + (x - foot[0]) * rise - drop; };
  std::vector<Corner> ground{{0.0, 0.0}, {24.0, 0.0}, {24.0, surface(24.0)}};
  if (stands_free) ground.insert(ground.end(), {at(length, -drop), at(length, 0.0), at(0.0, 0.0), at(0.0, -drop)});
  if (surface(0.0) > 0.0) ground.push_back({0.0, surface(0.0)});
  const std::string geometry = fmt::format("geometry=[{}, {}, {}]", region("firm", ground),
                                           region("soft", {at(0.0, 0.0), at(length, 0.0), at(length, t), at(0.0, t)}),
                                           region("firm", {at(0.0, t), at(length, t), at(length, t + height_at_ends),
                                                           at(0.5 * length, t + height), at(0.0, t + height_at_ends)}));
  const double weight = unit_weight * length * (t + 0.5 * (height + height_at_ends));
  const double exact = undrained_strength * length / (weight * std::sin(dip));
  const std::string firm = "soils.firm.strength=" +
                           (std::isinf(times_as_strong) ? std::string("{model: elastic}")
                                                        : fmt::format("{{model: von_mises, undrained_strength: {} Pa}}",
                                                                      times_as_strong * undrained_strength));
  const std::string cells = fmt::format("domain.cell_size={} m", cell_size);
  return found_factor(start_case("weak_seam.yaml", {geometry, firm, cells})) / exact;
}

}  // namespace slope::testing
