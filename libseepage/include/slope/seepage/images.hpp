#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "slope/seepage/kernel.hpp"
#include "slope/seepage/neighbours.hpp"
#include "slope/seepage/skeleton.hpp"

namespace slope::seepage {

/// A neighbour q of a particle p, or a mirror image of one behind a wall.
struct Image {
  double ex, ey;               ///< direction of x_p - x_q
  double r;                    ///< length of x_p - x_q (m)
  double weight;               ///< V_q F(r) times the scale asked for (1/m2), F = -W'/r of the kernel
  std::uint32_t particle;      ///< q
  std::int8_t flip_x, flip_y;  ///< signs that the mirrors give to the components of a vector of q
};

/// Neighbours and images of every particle, in compressed rows. In each row the particles ascend, and the images of p
/// itself come last: no water flows between it and them, but they are part of its neighbourhood.
struct Images {
  std::vector<std::size_t> start;
  std::vector<Image> image;

  [[nodiscard]] std::size_t size() const { return start.empty() ? 0 : start.size() - 1; }
  [[nodiscard]] std::span<const Image> of(std::size_t p) const {
    return {image.data() + start[p], start[p + 1] - start[p]};
  }
};

/// Fills `images`, keeping its memory. @param scale  factor of the weights
void find_images(const Skeleton& skeleton, const Neighbours& neighbours, const MirrorWalls& walls,
                 const WendlandC2& kernel, double scale, Images& images);

/// The factor of V F that makes the second moment sum_q V_q F r r of the square lattice the unit tensor.
[[nodiscard]] double lattice_scale(const WendlandC2& kernel, double spacing);

}  // namespace slope::seepage
