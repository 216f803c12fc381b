#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "slope/solid/grid.hpp"
#include "slope/solid/particles.hpp"

namespace slope::solid {

/// The faces between soils of different kinds, as the particles show them, and the particles near these.
///
/// A face is known by its points, halfway between a particle and the nearest one of another kind. Its direction at a
/// point is that of the straight line through those within four cells, which the steps of the particles' lattice and
/// the face's ends do not turn.
class SoilFaces {
 public:
  static constexpr std::size_t none = ~std::size_t{0};

  /// A particle near a face of its soil.
  struct Beside {
    std::size_t other;       ///< particle of the other soil, at the face
    std::size_t beyond;      ///< particle of the soil behind that, if the other one is a thin layer; else none
    Eigen::Vector2d normal;  ///< of the face, out of the particle's soil
    double gap;              ///< from the particle to the face (m), >= 0
    double distance;         ///< from the particle to the nearest point of it that was found (m)
    bool close;              ///< whether it is near the face however thick the other soil is
    std::size_t next;        ///< index of the same particle's next one, or none
  };

  /// Which particles lie in which cell: one cell after the other, and where each ends.
  struct ByCell {
    std::span<const std::size_t> end, particles;
  };

  /// Looks for the faces. Soils are of the same kind if their numbers differ by a multiple of `kinds`.
  void find(const Grid& grid, const ByCell& by_cell, const Particles& particles, std::size_t kinds);

  /// Those near a face, each once.
  [[nodiscard]] std::span<const std::size_t> particles_beside() const { return particles_beside_; }
  /// Calls visit(beside) for each soil that such a particle is near to.
  template <class Visit>
  void for_each_face_of(std::size_t particle, const Visit& visit) const {
    for (std::size_t k = first_beside_[particle]; k != none; k = beside_[k].next) visit(beside_[k]);
  }

 private:
  // On a face. Its sides are 0, which the normals point out of, and 1.
  struct Point {
    std::array<std::size_t, 2> particle;  // on either side
    std::array<std::size_t, 2> kind;      // rising
    Eigen::Vector2d x;                    // halfway between them
    double weight;                        // 2 where each is the other's nearest
    Eigen::Vector2d pair_normal, rough_normal;
    Eigen::Vector2d foot, normal;  // of the line
    std::array<double, 2> thickness{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    std::array<std::size_t, 2> beyond{none, none};  // particle behind the layer on that side
    std::size_t next = none;                        // in its cell
  };

  void mark_cells(const Grid& grid, const ByCell& by_cell, const Particles& particles);
  void pair_up(const Grid& grid, const ByCell& by_cell, const Particles& particles);
  void draw_lines(const Grid& grid);
  void measure_layers(const Grid& grid, const Particles& particles);
  void gather(const Grid& grid, const ByCell& by_cell, const Particles& particles);
  template <class Visit>
  void for_each_point_around(const Grid& grid, const Point& point, double distance, const Visit& visit) const;

  std::size_t kinds_ = 0;
  std::vector<std::size_t> kind_in_cell_;  // or several, or none
  std::vector<double> least_square_;       // of each particle, of its distance from another soil (m2)
  std::vector<std::size_t> partner_;       // of each particle, the nearest one of another soil
  std::vector<std::size_t> point_of_;      // of each particle that has a partner
  std::vector<Point> points_;
  std::vector<std::size_t> first_point_;  // in each cell
  std::vector<Beside> beside_;
  std::vector<std::size_t> first_beside_;  // of each particle
  std::vector<std::size_t> particles_beside_;
};

}  // namespace slope::solid
