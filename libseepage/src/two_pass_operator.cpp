#include "slope/seepage/two_pass_operator.hpp"

#include "require.hpp"

namespace slope::seepage {

namespace {

double checked(double spacing, double smoothing_ratio, const MirrorWalls& walls) {
  require_above(0.0, "spacing", spacing);
  require_above(0.0, "smoothing_ratio", smoothing_ratio);
  walls.check();
  return spacing;
}

}  // namespace

TwoPassOperator::TwoPassOperator(double spacing, double smoothing_ratio, const MirrorWalls& walls)
    : kernel_(checked(spacing, smoothing_ratio, walls) * smoothing_ratio),
      walls_(walls),
      scale_(lattice_scale(kernel_, spacing)) {}

void TwoPassOperator::update(const Skeleton& skeleton) {
  neighbours_ = find_neighbours(skeleton.x, skeleton.y, kernel_.support());
  find_images(skeleton, neighbours_, walls_, kernel_, scale_, images_);
}

// V_q grad phi = -V_q F r
void TwoPassOperator::darcy_velocity(std::span<const double> head, std::span<const double> conductivity,
                                     std::span<double> wx, std::span<double> wy) const {
  for (std::size_t p = 0; p < images_.size(); ++p) {
    double gx = 0.0, gy = 0.0;
    for (const Image& q : images_.of(p)) {
      const double weighted = q.weight * q.r * (head[p] - head[q.particle]);
      gx += weighted * q.ex;
      gy += weighted * q.ey;
    }
    wx[p] = -conductivity[p] * gx;
    wy[p] = -conductivity[p] * gy;
  }
}

void TwoPassOperator::divergence(std::span<const double> wx, std::span<const double> wy,
                                 std::span<double> divergence) const {
  for (std::size_t p = 0; p < images_.size(); ++p) {
    double sum = 0.0;
    for (const Image& q : images_.of(p)) {
      sum += q.weight * q.r * (q.ex * (wx[p] - q.flip_x * wx[q.particle]) + q.ey * (wy[p] - q.flip_y * wy[q.particle]));
    }
    divergence[p] = sum;
  }
}

}  // namespace slope::seepage
