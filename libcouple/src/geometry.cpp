#include "slope/couple/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "polygon.hpp"

namespace slope::couple {

namespace {

/// A lattice point this close to an outline (in spacings) belongs to the region, whatever the rounding.
constexpr double outline_tolerance = 1.0e-9;

std::size_t cells_along(const Domain& domain, std::size_t axis) {
  return static_cast<std::size_t>(std::llround((domain.upper[axis] - domain.lower[axis]) / domain.cell_size));
}

/// The last of the regions that holds the point; -1 if none does.
int region_at(const std::vector<Region>& regions, const Point& point, double tolerance) {
  for (std::size_t i = regions.size(); i-- > 0;) {
    if (contains(regions[i].polygon, point, tolerance)) return static_cast<int>(i);
  }
  return -1;
}

/// Number of lattice columns (or rows) between the lowest coordinate and this one.
long line_of(double coordinate, double lowest, double spacing) {
  return std::lround((coordinate - lowest) / spacing);
}

}  // namespace

InitialParticles fill_regions(const Domain& domain, const std::vector<Region>& regions) {
  const int per_side = static_cast<int>(std::lround(std::sqrt(domain.particles_per_cell)));
  InitialParticles particles;
  particles.spacing = domain.cell_size / per_side;
  for (std::size_t row = 0; row < cells_along(domain, 1); ++row) {
    for (std::size_t column = 0; column < cells_along(domain, 0); ++column) {
      for (int j = 0; j < per_side; ++j) {
        for (int i = 0; i < per_side; ++i) {
          const Point point{domain.lower[0] + domain.cell_size * (static_cast<double>(column) + (i + 0.5) / per_side),
                            domain.lower[1] + domain.cell_size * (static_cast<double>(row) + (j + 0.5) / per_side)};
          const int region = region_at(regions, point, outline_tolerance * particles.spacing);
          if (region < 0) continue;
          particles.x.push_back(point[0]);
          particles.y.push_back(point[1]);
          particles.volume.push_back(particles.spacing * particles.spacing);
          particles.soil.push_back(static_cast<int>(regions[static_cast<std::size_t>(region)].soil));
        }
      }
    }
  }
  return particles;
}

std::vector<std::size_t> particles_at(const PlaceRange& where, const InitialParticles& particles) {
  if (particles.x.empty()) return {};
  const bool top = where.place == Place::ground_surface || where.place == Place::free_surface;
  const bool by_column = top || where.place == Place::base;
  const bool outermost_is_largest = top || where.place == Place::right;
  const std::vector<double>& across = by_column ? particles.x : particles.y;
  const std::vector<double>& outwards = by_column ? particles.y : particles.x;

  const double lowest = *std::min_element(across.begin(), across.end());
  std::map<long, std::size_t> outermost;
  for (std::size_t p = 0; p < across.size(); ++p) {
    const auto [entry, first] = outermost.try_emplace(line_of(across[p], lowest, particles.spacing), p);
    const double beyond = outwards[p] - outwards[entry->second];
    if (!first && (outermost_is_largest ? beyond > 0.0 : beyond < 0.0)) entry->second = p;
  }
  std::vector<std::size_t> chosen;
  for (const auto& [line, p] : outermost) {
    if (across[p] >= where.from && across[p] <= where.to) chosen.push_back(p);
  }
  return chosen;
}

}  // namespace slope::couple
