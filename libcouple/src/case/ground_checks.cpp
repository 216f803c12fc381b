#include "ground_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "polygon.hpp"
#include "units.hpp"

namespace slope::couple {

namespace {

/// More cells than this are taken for a slip of the unit.
constexpr double most_cells = 4.0e6, most_particles = 4.0e6;
/// Corners of all regions together, and these times the lines of the particle lattice.
constexpr std::size_t most_corners = 50'000;
constexpr double most_cuts = 1.0e9;

std::string text_of(const Point& point) {
  return fmt::format("({}, {})", length_text(point[0]), length_text(point[1]));
}

}  // namespace

void check_domain(const Input& place, const Domain& domain) {
  double cells = 1.0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double side = domain.upper[axis] - domain.lower[axis];
    const char* direction = axis == 0 ? "right of" : "above";
    if (side <= 0.0) {
      place.at("upper").problem(
          fmt::format("must be {} lower, got {} and {}", direction, text_of(domain.upper), text_of(domain.lower)));
      return;
    }
    const double along = side / domain.cell_size;
    cells *= along;
    if (std::abs(along - std::round(along)) < 1.0e-6 && along > 0.5) continue;
    const double fitting = domain.lower[axis] + std::max(1.0, std::ceil(along)) * domain.cell_size;
    place.at("upper").problem(fmt::format("the {} of {} is not a whole number of cells of {}; {} = {} would be",
                                          axis == 0 ? "width" : "height", length_text(side),
                                          length_text(domain.cell_size), axis == 0 ? "x" : "y", length_text(fitting)));
  }
  if (cells > most_cells) {
    place.at("cell_size")
        .problem(fmt::format("makes {:.3g} cells, at most {:g} are possible; choose a larger cell", cells, most_cells));
  }
}

bool check_simple(const Input& outline, const std::vector<Point>& polygon) {
  const auto edges = crossing_edges(polygon);
  if (!edges) return true;
  outline.problem(fmt::format("the edges from {} and from {} cross each other; give the corners in order",
                              text_of(polygon[edges->first]), text_of(polygon[edges->second])));
  return false;
}

void check_region(const Input& place, const Domain& domain, const Region& region) {
  const bool drawn = place.has("polygon");
  const Input outline = place.at(drawn ? "polygon" : "surface");
  const double tolerance = 1.0e-9 * domain.cell_size;
  for (std::size_t i = 0; i < region.polygon.size(); ++i) {
    const Point& corner = region.polygon[i];
    const bool inside = corner[0] >= domain.lower[0] - tolerance && corner[0] <= domain.upper[0] + tolerance &&
                        corner[1] >= domain.lower[1] - tolerance && corner[1] <= domain.upper[1] + tolerance;
    if (inside) continue;
    (drawn ? outline.item(i) : outline)
        .problem(fmt::format("the corner {} is outside of the domain, which goes from {} to {}", text_of(corner),
                             text_of(domain.lower), text_of(domain.upper)));
  }
  if (!check_simple(outline, region.polygon)) return;
  if (std::abs(signed_area(region.polygon)) < 1.0e-9 * domain.cell_size * domain.cell_size) {
    outline.problem("the polygon encloses no area; its corners lie on one line");
  } else if (const auto corner = drawn ? turning_corner(region.polygon) : std::nullopt) {
    outline.item(*corner).problem(fmt::format("the outline turns back on itself at {}; leave out what has no area",
                                              text_of(region.polygon[*corner])));
  } else if (!holds_lattice_point(domain, region)) {
    outline.problem(
        fmt::format("no particle lies in the polygon; it is too small for cells of {}", length_text(domain.cell_size)));
  }
}

void check_size(const Input& root, const Case& input) {
  const double per_side = std::sqrt(input.domain.particles_per_cell);
  const auto lines = [&](std::size_t axis) {
    return per_side * (input.domain.upper[axis] - input.domain.lower[axis]) / input.domain.cell_size;
  };
  const double spacing = input.domain.cell_size / per_side;
  double area = 0.0;
  std::size_t corners = 0;
  for (const Region& region : input.regions) {
    area += std::abs(signed_area(region.polygon));
    corners += region.polygon.size();
  }
  const double particles = std::min(area / (spacing * spacing), lines(0) * lines(1));
  const Input geometry = root.at("geometry");
  if (particles > most_particles) {
    root.at("domain")
        .at("cell_size")
        .problem(fmt::format("makes about {:.2g} particles, at most {:g} are possible; choose a larger cell or fewer "
                             "particles_per_cell",
                             particles, most_particles));
  }
  if (corners > most_corners) {
    geometry.problem(fmt::format("has {} corners, at most {} are possible; thin the lines out", corners, most_corners));
  } else if (static_cast<double>(corners) * (lines(0) + lines(1)) > most_cuts) {
    geometry.problem(
        fmt::format("has {} corners, too many for {:.2g} columns and rows of particles; thin the lines "
                    "out, or choose a larger cell",
                    corners, lines(0) + lines(1)));
  }
}

void check_points(const Input& root, const Case& input) {
  const double spacing = input.domain.cell_size / std::sqrt(input.domain.particles_per_cell);
  for (const VerificationPoint& point : input.points) {
    const bool inside = std::any_of(input.regions.begin(), input.regions.end(), [&](const Region& region) {
      return contains(region.polygon, point.position, spacing);
    });
    if (inside) continue;
    root.at("points")
        .at(point.name)
        .problem(fmt::format("the point {} lies outside of the soil; move it into a region of geometry",
                             text_of(point.position)));
  }
}

void doubt_hanging_soil(const Input& place, const InitialParticles& particles, const Frame& frame, int columns) {
  constexpr int reach = 2;  // squares; slivers leave gaps of one
  std::map<std::array<int, 2>, std::size_t> waiting;
  for (std::size_t p = 0; p < particles.x.size(); ++p) waiting[{particles.column[p], particles.row[p]}] = p;
  std::vector<std::array<int, 2>> held;
  for (auto entry = waiting.begin(); entry != waiting.end();) {
    const auto [column, row] = entry->first;
    const bool at_wall = column < reach || column >= columns - reach || row < reach;
    if (at_wall) held.push_back(entry->first);
    entry = at_wall ? waiting.erase(entry) : std::next(entry);
  }
  while (!held.empty()) {
    const auto [column, row] = held.back();
    held.pop_back();
    for (int i = -reach; i <= reach; ++i) {
      for (int j = -reach; j <= reach; ++j) {
        const auto found = waiting.find({column + i, row + j});
        if (found == waiting.end()) continue;
        held.push_back(found->first);
        waiting.erase(found);
      }
    }
  }
  if (waiting.empty()) return;
  const std::size_t p = waiting.begin()->second;
  place.warning(fmt::format("the soil around {} touches neither a wall nor what stands on one: it hangs in the air",
                            text_of(frame.position({particles.x[p], particles.y[p]}))));
}

}  // namespace slope::couple
