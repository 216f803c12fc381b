#include "contrast_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "units.hpp"

namespace slope::couple {

namespace {

/// Of what two soils bear along the face between them: below it the factor of safety is right within a few per cent.
constexpr double contrast = 1.5;
/// Up to so many cells a layer between stronger ones, and one above a stronger one, is told.
constexpr double thin = 4.0, low = 20.0;
constexpr double gravity = 9.81;  // (m/s2)

/// What a soil bears along a plane (Pa), dry or drained, at its peak; nothing for a law that is not known by that.
std::optional<double> borne_along_a_plane(const solid::Strength& strength, double normal_stress) {
  return std::visit(
      [normal_stress](const auto& law) -> std::optional<double> {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (requires { law.friction_angle; }) {
          return law.cohesion + normal_stress * std::tan(law.friction_angle);
        } else if constexpr (requires { law.undrained_strength; }) {
          return law.undrained_strength;
        } else if constexpr (std::is_same_v<Law, solid::NoYield>) {
          return std::numeric_limits<double>::infinity();
        }
        return std::nullopt;
      },
      strength);
}

/// Soil of one kind in a column of the lattice, from its top down.
struct Run {
  std::size_t bottom;               // its lowest particle
  int count = 0;                    // of particles
  std::optional<int> above, below;  // soils
  double overburden = 0.0;          // on its bottom (Pa)
};

/// Of each soil, its runs in all columns of particles.
std::map<int, std::vector<Run>> runs_of(const Case& input, const InitialParticles& particles) {
  std::map<int, std::vector<std::size_t>> columns;
  for (std::size_t p = 0; p < particles.x.size(); ++p) columns[particles.column[p]].push_back(p);
  std::map<int, std::vector<Run>> runs;
  for (auto& [column, members] : columns) {
    std::ranges::sort(members, std::ranges::greater{}, [&](std::size_t p) { return particles.row[p]; });
    double overburden = 0.0;
    std::optional<int> above;
    for (std::size_t k = 0; k < members.size();) {
      const int soil = particles.soil[members[k]];
      const Soil& kind = input.soils[static_cast<std::size_t>(soil)];
      Run run{members[k], 0, above, {}, 0.0};
      for (; k < members.size() && particles.soil[members[k]] == soil; ++k, ++run.count) {
        run.bottom = members[k];
        overburden += gravity * (1.0 - kind.porosity) * kind.solid.grain_density * particles.volume[members[k]] /
                      particles.spacing;
      }
      if (k < members.size()) run.below = particles.soil[members[k]];
      run.overburden = overburden;
      runs[soil].push_back(run);
      above = soil;
    }
  }
  return runs;
}

}  // namespace

void doubt_contrast(const Input& geometry, const Case& input, const InitialParticles& particles, const Frame& frame) {
  const auto name_of = [&](int soil) { return input.soils[static_cast<std::size_t>(soil)].name; };
  const auto bears = [&](int soil, double stress) {
    return borne_along_a_plane(input.soils[static_cast<std::size_t>(soil)].solid.strength, stress);
  };
  for (const auto& [of, runs] : runs_of(input, particles)) {
    const int soil = of;
    const auto times_as_strong = [&](const std::optional<int>& other, double stress) {
      const auto own = bears(soil, stress);
      const auto others = other ? bears(*other, stress) : std::nullopt;
      return own && others && *own > 0.0 && std::isfinite(*own) ? *others / *own : 1.0;
    };
    std::vector<Run> over;
    std::size_t between = 0;
    for (const Run& run : runs) {
      if (times_as_strong(run.below, run.overburden) < contrast) continue;
      over.push_back(run);
      if (times_as_strong(run.above, run.overburden) >= contrast) ++between;
    }
    if (over.empty() || 2 * over.size() < runs.size()) continue;
    std::ranges::stable_sort(over, {}, &Run::count);
    const int usual = over[over.size() / 2].count;
    const auto first = std::ranges::lower_bound(over, usual, {}, &Run::count);
    const auto middle = first + (std::ranges::upper_bound(over, usual, {}, &Run::count) - first) / 2;
    const double cells = middle->count * particles.spacing / input.domain.cell_size;
    const bool enclosed = 2 * between >= over.size();
    if (cells > (enclosed ? thin : low)) continue;
    const Point place = frame.position({particles.x[middle->bottom], particles.y[middle->bottom]});
    const double times = times_as_strong(middle->below, middle->overburden);
    const std::string much =
        std::isinf(times) ? "never yields" : fmt::format("bears {:.2g} times as much along their face", times);
    geometry.warning(fmt::format(
        "the soil {} at x = {} is {:.2g} {} thick {} {}, which {}: a slide along it is held too firmly, {}; "
        "take cells of {:.2g} m or less",
        name_of(soil), length_text(place[0]), cells, cells == 1.0 ? "cell" : "cells", enclosed ? "in" : "over",
        name_of(*middle->below), much,
        enclosed ? "by up to 20 % where a layer is a cell thick and its foot pushes against level ground"
                 : "by some 5 % where the soil is ten cells high",
        input.domain.cell_size * cells / (enclosed ? thin : low)));
  }
}

}  // namespace slope::couple
