#include "slope/couple/geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "cell_cut.hpp"
#include "polygon.hpp"

namespace slope::couple {

namespace {

/// What is this close (in spacings) is in the same place, whatever the rounding.
constexpr double tolerance = 1.0e-9;
/// Share of a lattice square that does not count.
constexpr double least_area = 1.0e-12;
/// Share of a lattice square below which what is cut out of it makes no particle of its own.
constexpr double least_share = 0.5;

/// The squares of the particle lattice.
struct Lattice {
  explicit Lattice(const Domain& domain)
      : per_side(static_cast<int>(std::lround(std::sqrt(domain.particles_per_cell)))),
        columns(cells_along(domain, 0) * per_side),
        rows(cells_along(domain, 1) * per_side),
        spacing(domain.cell_size / per_side),
        lower_(domain.lower),
        cell_size_(domain.cell_size) {}

  [[nodiscard]] Point corner(int column, int row) const { return {at(0, column, 0.0), at(1, row, 0.0)}; }
  [[nodiscard]] Point centre(int column, int row) const { return {at(0, column, 0.5), at(1, row, 0.5)}; }

  /// Calls `see(column, row)` for every square, grid cell by grid cell, row by row from below.
  template <class See>
  void each(See see) const {
    for (int row = 0; row < rows; row += per_side) {
      for (int column = 0; column < columns; column += per_side) {
        for (int j = 0; j < per_side; ++j) {
          for (int i = 0; i < per_side; ++i) see(column + i, row + j);
        }
      }
    }
  }

  int per_side;
  int columns, rows;
  double spacing;

 private:
  static int cells_along(const Domain& domain, std::size_t axis) {
    return static_cast<int>(std::llround((domain.upper[axis] - domain.lower[axis]) / domain.cell_size));
  }
  [[nodiscard]] double at(std::size_t axis, int line, double share) const {
    return lower_[axis] + cell_size_ * (line / per_side + (line % per_side + share) / per_side);
  }

  Point lower_;
  double cell_size_;
};

/// What becomes a particle.
struct Piece {
  Point position{0.0, 0.0};
  double volume = 0.0;
  int soil = 0;
  int column = 0, row = 0;
  std::array<double, 4> contact{};  // length of soil on the left, right, lower and upper side of a cut square (m)
};

/// The outlines of the regions, sorted into the lattice columns that they touch.
class Outlines {
 public:
  Outlines(const Lattice& lattice, const std::vector<Region>& regions)
      : lattice_(lattice), edges_(static_cast<std::size_t>(lattice.columns)) {
    for (std::size_t r = 0; r < regions.size(); ++r) {
      const std::vector<Point>& polygon = regions[r].polygon;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto [left, right] = std::minmax(polygon[i], polygon[(i + 1) % polygon.size()]);
        add({left, right, r});
      }
    }
  }

  [[nodiscard]] const std::vector<Edge>& over(int column) const { return edges_[static_cast<std::size_t>(column)]; }

  /// The last of the regions that holds a point of a column, or whose outline runs through it; none if none does.
  [[nodiscard]] std::optional<std::size_t> region_at(int column, const Point& point) const {
    const double margin = tolerance * lattice_.spacing;
    const std::vector<Edge>& edges = over(column);  // region by region
    for (auto last = edges.rbegin(); last != edges.rend();) {
      const std::size_t region = last->region;
      bool inside = false, on_outline = false;
      for (; last != edges.rend() && last->region == region; ++last) {
        const Edge& edge = *last;
        if (edge.right[0] < point[0] - margin || edge.left[0] > point[0] + margin) continue;
        on_outline = on_outline || distance_to_edge(edge.left, edge.right, point) <= margin;
        if (edge.left[0] <= point[0] && point[0] < edge.right[0] && edge.height_at(point[0]) > point[1]) {
          inside = !inside;
        }
      }
      if (inside || on_outline) return region;
    }
    return std::nullopt;
  }

  /// Whether an outline runs through the inside of a square.
  [[nodiscard]] bool cut(int column, int row) const {
    const Point corner = lattice_.corner(column, row);
    const double margin = tolerance * lattice_.spacing;
    const Point low{corner[0] + margin, corner[1] + margin};
    const Point high{corner[0] + lattice_.spacing - margin, corner[1] + lattice_.spacing - margin};
    return std::any_of(over(column).begin(), over(column).end(), [&](const Edge& edge) {
      if (edge.right[0] <= low[0] || edge.left[0] >= high[0]) return false;
      const bool vertical = edge.left[0] == edge.right[0];
      const double first = vertical ? edge.left[1] : edge.height_at(std::max(edge.left[0], low[0]));
      const double last = vertical ? edge.right[1] : edge.height_at(std::min(edge.right[0], high[0]));
      return std::max(first, last) > low[1] && std::min(first, last) < high[1];
    });
  }

 private:
  void add(const Edge& edge) {
    const double first = (edge.left[0] - lattice_.corner(0, 0)[0]) / lattice_.spacing;
    const double last = (edge.right[0] - lattice_.corner(0, 0)[0]) / lattice_.spacing;
    const int from = std::max(0, static_cast<int>(std::floor(first)) - 1);
    const int to = std::min(lattice_.columns - 1, static_cast<int>(std::floor(last)) + 1);
    for (int column = from; column <= to; ++column) edges_[static_cast<std::size_t>(column)].push_back(edge);
  }

  const Lattice& lattice_;
  std::vector<std::vector<Edge>> edges_;
};

/// The soil with the largest share; of equal ones the one laid last.
int largest_soil(const CellCut& cut, const std::vector<Region>& regions) {
  const double margin = tolerance * cut.area;
  std::size_t best = 0;
  double largest = -1.0;
  for (std::size_t i = regions.size(); i-- > 0;) {
    double share = 0.0;
    for (std::size_t j = 0; j < regions.size(); ++j) {
      if (regions[j].soil == regions[i].soil) share += cut.share[j];
    }
    if (share > largest + margin) {
      largest = share;
      best = regions[i].soil;
    }
  }
  return static_cast<int>(best);
}

std::vector<Piece> whole_pieces(const Lattice& lattice, const std::vector<Region>& regions) {
  const Outlines outlines(lattice, regions);
  std::vector<Piece> pieces;
  lattice.each([&](int column, int row) {
    const Point centre = lattice.centre(column, row);
    const auto region = outlines.region_at(column, centre);
    if (!region) return;
    const int soil = static_cast<int>(regions[*region].soil);
    pieces.push_back({centre, lattice.spacing * lattice.spacing, soil, column, row, {}});
  });
  return pieces;
}

std::vector<Piece> cut_pieces(const Lattice& lattice, const std::vector<Region>& regions) {
  const Outlines outlines(lattice, regions);
  const double whole = lattice.spacing * lattice.spacing;
  std::vector<Piece> pieces;
  lattice.each([&](int column, int row) {
    const Point centre = lattice.centre(column, row);
    if (!outlines.cut(column, row)) {
      const auto region = outlines.region_at(column, centre);
      if (!region) return;
      const int soil = static_cast<int>(regions[*region].soil);
      pieces.push_back({centre, whole, soil, column, row, {}});
      return;
    }
    const CellCut cut = cut_cell(lattice.corner(column, row), lattice.spacing, outlines.over(column), regions.size());
    if (cut.area < least_area * whole) return;
    const int soil = largest_soil(cut, regions);
    if (cut.area > (1.0 - least_area) * whole) {
      pieces.push_back({centre, whole, soil, column, row, {}});
    } else {
      pieces.push_back({cut.centroid, cut.area, soil, column, row, cut.contact});
    }
  });
  return pieces;
}

/// Joins what is too small for a particle to a neighbour.
class SliverJoin {
 public:
  SliverJoin(const Lattice& lattice, std::vector<Piece>& pieces)
      : lattice_(lattice), pieces_(pieces), joined_to_(pieces.size()) {
    std::iota(joined_to_.begin(), joined_to_.end(), std::size_t{0});
    for (std::size_t p = 0; p < pieces.size(); ++p) at_[{pieces[p].column, pieces[p].row}] = p;
  }

  void run() {
    std::vector<std::size_t> order;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (is_sliver(p)) order.push_back(p);
    }
    std::ranges::sort(order, {}, [&](std::size_t p) { return rank_of(pieces_[p]); });
    for (const std::size_t p : order) {
      if (is_sliver(p)) join(p);
    }
    std::size_t kept = 0;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (joined_to_[p] == p) pieces_[kept++] = pieces_[p];
    }
    pieces_.resize(kept);
  }

 private:
  /// The smallest come first, and of equal ones, row by row, those on the left: an order that goes with a straight
  /// face.
  [[nodiscard]] std::tuple<double, int, int> rank_of(const Piece& piece) const {
    const double share = piece.volume / (lattice_.spacing * lattice_.spacing);
    return {std::floor(share / tolerance + 0.25), piece.row, piece.column};
  }

  [[nodiscard]] bool is_sliver(std::size_t p) const {
    return pieces_[p].volume < (least_share - tolerance) * lattice_.spacing * lattice_.spacing;
  }

  [[nodiscard]] std::size_t whole_of(std::size_t p) const {
    while (joined_to_[p] != p) p = joined_to_[p];
    return p;
  }

  /// To the neighbour that is no sliver itself and has the longest side in common, of equal ones the lower; among
  /// slivers if there is no other. A piece that touches nothing stays as it is.
  void join(std::size_t p) {
    constexpr std::array<std::array<int, 2>, 4> steps{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
    const double margin = tolerance * lattice_.spacing;
    std::size_t best = p;
    double longest = 0.0;
    for (const std::size_t side : {2u, 0u, 1u, 3u}) {
      const double contact = pieces_[p].contact[side];
      if (contact <= margin) continue;
      const auto found = at_.find({pieces_[p].column + steps[side][0], pieces_[p].row + steps[side][1]});
      if (found == at_.end()) continue;
      const std::size_t q = whole_of(found->second);
      if (q == p) continue;
      const bool better = is_sliver(q) == is_sliver(best) ? contact > longest + margin : is_sliver(best);
      if (best != p && !better) continue;
      best = q;
      longest = contact;
    }
    if (best == p) return;
    Piece& sliver = pieces_[p];
    Piece& other = pieces_[best];
    const double volume = sliver.volume + other.volume;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      other.position[axis] = (sliver.volume * sliver.position[axis] + other.volume * other.position[axis]) / volume;
    }
    other.volume = volume;
    joined_to_[p] = best;
  }

  const Lattice& lattice_;
  std::vector<Piece>& pieces_;
  std::vector<std::size_t> joined_to_;
  std::map<std::array<int, 2>, std::size_t> at_;
};

/// Whether the particles of a place are the outermost of columns (or else of rows), and the largest coordinate is
/// outside.
struct Direction {
  explicit Direction(Place place)
      : by_column(place != Place::left && place != Place::right),
        upwards(place != Place::left && place != Place::base) {}

  bool by_column, upwards;
};

/// The edges of all outlines that lie across a direction, by columns as they are, by rows with x and y exchanged.
std::vector<Edge> edges_across(const std::vector<Region>& regions, bool by_column) {
  const std::size_t along = by_column ? 0 : 1;
  std::vector<Edge> edges;
  for (const auto& [soil, polygon] : regions) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const Point first{a[along], a[1 - along]}, second{b[along], b[1 - along]};
      if (first[0] == second[0]) continue;
      edges.push_back({std::min(first, second), std::max(first, second), 0});
    }
  }
  return edges;
}

/// The outermost of the outlines, as seen from outside.
class OuterLine {
 public:
  OuterLine(std::vector<Edge> edges, const Direction& direction)
      : edges_(std::move(edges)), sign_(direction.upwards ? 1.0 : -1.0) {}

  struct At {
    double outwards, slope;  // coordinate, positive outwards (m); of it along the line
  };
  [[nodiscard]] std::optional<At> at(double along) const {
    std::optional<At> found;
    for (const Edge& edge : edges_) {
      if (along < edge.left[0] || along > edge.right[0]) continue;
      const double outwards = sign_ * edge.height_at(along);
      if (found && outwards <= found->outwards) continue;
      found = {outwards, sign_ * (edge.right[1] - edge.left[1]) / (edge.right[0] - edge.left[0])};
    }
    return found;
  }

  /// The face of a particle in a column that begins somewhere; none if the line is not outside of the particle.
  [[nodiscard]] std::optional<Face> face_of(const Point& particle, double begin, double spacing) const {
    constexpr int samples = 8;  // of the inclination, whose mean counts: outlines may have corners
    const auto here = at(particle[0]);
    double slope = 0.0;
    int found = 0;
    for (int k = 0; k < samples; ++k) {
      const auto line = at(begin + (k + 0.5) / samples * spacing);
      if (!line) continue;
      slope += line->slope;
      ++found;
    }
    if (!here || found == 0) return std::nullopt;
    slope /= found;
    const double stretch = std::hypot(1.0, slope), outwards = here->outwards - sign_ * particle[1];
    if (outwards < least_face * spacing) return std::nullopt;
    return Face{0, {-slope / stretch, sign_ / stretch}, outwards / stretch, spacing * stretch, outwards};
  }

 private:
  static constexpr double least_face = 0.05;  // spacings; what is nearer lies beside a cliff
  std::vector<Edge> edges_;
  double sign_;
};

/// Distances from the ground, of all that the free surface may begin with: the uppermost particles, and those that are
/// cut.
void find_ground(const Lattice& lattice, const std::vector<Region>& regions, InitialParticles& particles) {
  const OuterLine ground(edges_across(regions, true), Direction(Place::ground_surface));
  const double whole = lattice.spacing * lattice.spacing;
  std::vector<char> near(particles.x.size(), 0);
  for (const std::size_t p : particles_at({}, particles)) near[p] = 1;
  for (std::size_t p = 0; p < particles.x.size(); ++p) {
    if (near[p] == 0 && particles.volume[p] == whole) continue;
    const double begin = lattice.corner(particles.column[p], 0)[0];
    const auto face = ground.face_of({particles.x[p], particles.y[p]}, begin, lattice.spacing);
    if (face && face->distance < lattice.spacing) particles.face_distance[p] = face->distance;
  }
}

}  // namespace

bool holds_lattice_point(const Domain& domain, const Region& region) {
  const Lattice lattice(domain);
  const Outlines outlines(lattice, {region});
  const auto lines = [&](std::size_t axis, int count) {
    const auto [low, high] =
        std::ranges::minmax(region.polygon, {}, [axis](const Point& corner) { return corner[axis]; });
    const double first = (low[axis] - domain.lower[axis]) / lattice.spacing - 1.0;
    const double last = (high[axis] - domain.lower[axis]) / lattice.spacing + 1.0;
    return std::pair(std::max(0, static_cast<int>(std::max(first, 0.0))),
                     std::min(count - 1, static_cast<int>(std::min(last, static_cast<double>(count)))));
  };
  const auto [left, right] = lines(0, lattice.columns);
  const auto [lower, upper] = lines(1, lattice.rows);
  for (int column = left; column <= right; ++column) {
    for (int row = lower; row <= upper; ++row) {
      if (outlines.region_at(column, lattice.centre(column, row))) return true;
    }
  }
  return false;
}

InitialParticles fill_regions(const Domain& domain, const std::vector<Region>& regions) {
  const Lattice lattice(domain);
  std::vector<Piece> pieces;
  if (domain.surface_particles == SurfaceParticles::clipped) {
    pieces = cut_pieces(lattice, regions);
    SliverJoin(lattice, pieces).run();
  } else {
    pieces = whole_pieces(lattice, regions);
  }
  InitialParticles particles;
  particles.spacing = lattice.spacing;
  const double whole = lattice.spacing * lattice.spacing;
  for (const Piece& piece : pieces) {
    particles.x.push_back(piece.position[0]);
    particles.y.push_back(piece.position[1]);
    particles.volume.push_back(piece.volume);
    particles.soil.push_back(piece.soil);
    particles.column.push_back(piece.column);
    particles.row.push_back(piece.row);
    particles.face_distance.push_back(0.5 * lattice.spacing * (piece.volume / whole));
  }
  if (domain.surface_particles == SurfaceParticles::clipped) find_ground(lattice, regions, particles);
  return particles;
}

std::vector<std::size_t> particles_at(const PlaceRange& where, const InitialParticles& particles) {
  const auto [by_column, outermost_is_largest] = Direction(where.place);
  const std::vector<int>& line = by_column ? particles.column : particles.row;
  const std::vector<double>& across = by_column ? particles.x : particles.y;
  const std::vector<int>& outwards = by_column ? particles.row : particles.column;

  std::map<int, std::size_t> outermost;
  for (std::size_t p = 0; p < across.size(); ++p) {
    const auto [entry, first] = outermost.try_emplace(line[p], p);
    const int beyond = outwards[p] - outwards[entry->second];
    if (!first && (outermost_is_largest ? beyond > 0 : beyond < 0)) entry->second = p;
  }
  const double margin = tolerance * particles.spacing;
  std::vector<std::size_t> chosen;
  for (const auto& [number, p] : outermost) {
    if (across[p] >= where.from - margin && across[p] <= where.to + margin) chosen.push_back(p);
  }
  return chosen;
}

std::vector<Face> faces_at(const PlaceRange& where, const Case& input, const InitialParticles& particles) {
  const Direction direction(where.place);
  const double sign = direction.upwards ? 1.0 : -1.0;
  const OuterLine line(edges_across(input.regions, direction.by_column), direction);
  const Lattice lattice(input.domain);
  std::vector<Face> faces;
  for (const std::size_t p : particles_at(where, particles)) {
    const double across = direction.by_column ? particles.x[p] : particles.y[p];
    const double out = direction.by_column ? particles.y[p] : particles.x[p];
    const Point corner = lattice.corner(particles.column[p], particles.row[p]);
    std::optional<Face> face;
    if (input.domain.surface_particles == SurfaceParticles::clipped) {
      face = line.face_of({across, out}, corner[direction.by_column ? 0 : 1], particles.spacing);
    }
    const double straight = particles.face_distance[p];
    if (!face) face = Face{0, {0.0, sign}, straight, particles.spacing, straight};
    face->particle = p;
    if (!direction.by_column) std::swap(face->normal[0], face->normal[1]);
    faces.push_back(*face);
  }
  return faces;
}

}  // namespace slope::couple
