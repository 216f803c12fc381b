#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "slope/seepage/images.hpp"
#include "slope/seepage/kernel.hpp"

namespace slope::seepage {

/// What the weight of a pair is multiplied with so that linear heads flow as they should,
///
///     c_pq = 1 + e.(B_p + B_q).e / 2 + (a_p - a_q).e,     e = r_pq / |r_pq|,
///
/// the same for (p, q) and (q, p), with a symmetric tensor B and a vector a for every particle:
/// - B gives the second moment sum_q w_pq c_pq r r = I, hence the right conductivity in every direction. At a free
///   surface the condition across the surface is dropped: the first moment decides there.
/// - a gives the first moment sum_q w_pq c_pq r = 0 inside, hence no residual under a linear head; and A n / (2 V) in
///   the particles of a free surface, A n the piece of it that is theirs times its outward normal: what a linear head
///   drives through that piece. The pieces are those of the outline of the particles' discs; they close, whatever the
///   surface's inclination and the disorder.
/// Mirror images of neighbours take part, with B and a mirrored.
class MomentCorrection {
 public:
  /// @param images  with weights scaled by lattice_scale(); @param volume  V of each particle (m2)
  MomentCorrection(const Images& images, std::span<const double> volume, const WendlandC2& kernel, double spacing,
                   int threads);

  /// c_pq, kept within bounds that are positive; images must be those of the constructor.
  [[nodiscard]] double operator()(std::size_t p, const Image& image) const;

 private:
  struct Tensor {
    double xx, xy, yy;
  };
  struct Vector {
    double x, y;
  };
  // What a neighbour's disc covers of the rim of a particle's.
  struct Arc {
    double from, until;  // counterclockwise (rad)
    Vector to;           // direction of the neighbour
    double middle;       // of the way there (m)
  };
  // Asymmetry of the neighbourhood of the outermost particles of the square lattice at a flat surface (m).
  [[nodiscard]] static double flat_asymmetry(const WendlandC2& kernel, double spacing);
  [[nodiscard]] Vector surface_of(std::size_t p, double spacing, std::vector<Arc>& covered) const;
  void find_surface(std::span<const double> volume, const WendlandC2& kernel, double spacing);
  void find_surface_layer();
  void find_responses();
  void sweep_second_moments(const std::vector<Tensor>& old);
  void correct_first_moments(std::span<const double> volume);
  [[nodiscard]] double even_part(const std::vector<Tensor>& tensor, std::size_t p, const Image& image) const;
  [[nodiscard]] double odd_part(std::size_t p, const Image& image) const;

  const Images& images_;
  int threads_;
  std::vector<double> at_surface_;         // from 0 inside to 1 in the outermost particles
  std::vector<Vector> first_moment_;       // wanted (1/m)
  std::vector<Tensor> free_of_;            // projector on the directions in which the second moment counts
  std::vector<Eigen::Matrix3d> response_;  // of B to a lack of second moment
  std::vector<Tensor> tensor_;             // B
  std::vector<double> vector_;             // a, two components each
};

}  // namespace slope::seepage
