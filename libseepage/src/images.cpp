#include "slope/seepage/images.hpp"

#include <array>
#include <cmath>

namespace slope::seepage {

void find_images(const Skeleton& skeleton, const Neighbours& neighbours, const MirrorWalls& walls,
                 const WendlandC2& kernel, double scale, Images& images) {
  const std::size_t n = skeleton.size();
  const double support = kernel.support();
  images.image.clear();
  images.start.assign(1, 0);
  for (std::size_t p = 0; p < n; ++p) {
    const double px = skeleton.x[p], py = skeleton.y[p];
    const auto add = [&](std::size_t q, double x, double y, int flip_x, int flip_y) {
      const double rx = px - x, ry = py - y;
      const double r = std::sqrt(rx * rx + ry * ry);
      const double f = kernel.radial_factor(r);
      if (f > 0.0) {
        images.image.push_back({rx / r, ry / r, r, scale * skeleton.volume[q] * f, static_cast<std::uint32_t>(q),
                                static_cast<std::int8_t>(flip_x), static_cast<std::int8_t>(flip_y)});
      }
    };
    const auto add_mirrored = [&](std::size_t q) {
      const double qx = skeleton.x[q], qy = skeleton.y[q];
      const std::array<double, 3> xs{qx, 2.0 * walls.left - qx, 2.0 * walls.right - qx};
      const std::array<double, 3> ys{qy, 2.0 * walls.base - qy, 2.0 * walls.top - qy};
      for (std::size_t i = 0; i < 3; ++i) {
        if (!(std::abs(px - xs[i]) < support)) continue;
        for (std::size_t j = 0; j < 3; ++j) {
          if (p == q && i == 0 && j == 0) continue;
          if (std::abs(py - ys[j]) < support) add(q, xs[i], ys[j], i == 0 ? 1 : -1, j == 0 ? 1 : -1);
        }
      }
    };
    const bool near_wall = px - walls.left < support || walls.right - px < support || py - walls.base < support ||
                           walls.top - py < support;
    if (near_wall) {
      for (const std::uint32_t q : neighbours.of(p)) add_mirrored(q);
      add_mirrored(p);
    } else {
      for (const std::uint32_t q : neighbours.of(p)) add(q, skeleton.x[q], skeleton.y[q], 1, 1);
    }
    images.start.push_back(images.image.size());
  }
}

double lattice_scale(const WendlandC2& kernel, double spacing) {
  const int reach = static_cast<int>(std::ceil(kernel.support() / spacing));
  double moment = 0.0;
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      if (i != 0 || j != 0) moment += kernel.radial_factor(spacing * std::hypot(i, j)) * i * i;
    }
  }
  return 1.0 / (moment * std::pow(spacing, 4));
}

}  // namespace slope::seepage
