#include "slope/seepage/head_operator.hpp"

#include <algorithm>
#include <cmath>

#include "moment_correction.hpp"
#include "moved_beyond.hpp"

namespace slope::seepage {

namespace {

// Share of the spacing by which a particle may move before the pair factors are worked out anew.
constexpr double follow_distance = 0.01;

}  // namespace

HeadOperator::HeadOperator(double spacing, double smoothing_ratio, const MirrorWalls& walls, int threads)
    : spacing_(spacing),
      kernel_(smoothing_ratio * spacing),
      walls_(walls),
      threads_(threads),
      lattice_scale_(lattice_scale(kernel_, spacing)) {}

bool HeadOperator::update(const Skeleton& skeleton) {
  const std::size_t n = skeleton.size();
  if (x_weighted_.size() == n) {
    if (!moved_beyond(follow_distance * spacing_, skeleton, x_weighted_, y_weighted_)) return false;
  } else {
    share_.resize(n);
    for (std::size_t p = 0; p < n; ++p) share_[p] = skeleton.volume[p] / (spacing_ * spacing_);
  }
  x_weighted_.assign(skeleton.x.begin(), skeleton.x.end());
  y_weighted_.assign(skeleton.y.begin(), skeleton.y.end());
  neighbours_ = find_neighbours(skeleton.x, skeleton.y, kernel_.support(), threads_);
  find_images(skeleton, neighbours_, walls_, kernel_, lattice_scale_, images_);
  find_pair_factors(skeleton);
  return true;
}

void HeadOperator::find_pair_factors(const Skeleton& skeleton) {
  const std::size_t n = skeleton.size();
  const MomentCorrection correction(images_, skeleton.volume, share_, kernel_, spacing_, threads_);
  factor_.assign(neighbours_.index.size(), 0.0);
  conductance_.resize(factor_.size());
  diagonal_.resize(n);
  conductivity_.resize(n);
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t s = neighbours_.start[p];
    for (const Image& image : images_.of(p)) {
      if (image.particle == p) break;
      while (neighbours_.index[s] != image.particle) ++s;
      factor_[s] += 2.0 * skeleton.volume[p] * image.weight * correction(p, image);
    }
  }
}

void HeadOperator::set_conductivity(std::span<const double> conductivity, std::span<const double> pressure_head) {
  for (std::size_t p = 0; p < diagonal_.size(); ++p) {
    conductivity_[p] = {conductivity[p], pressure_head.empty() ? 0.0 : pressure_head[p]};
  }
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < diagonal_.size(); ++p) {
    double sum = 0.0;
    for (std::size_t s = neighbours_.start[p]; s < neighbours_.start[p + 1]; ++s) {
      const std::size_t q = neighbours_.index[s];
      const auto [first, second] = std::minmax(p, q);  // the same for both particles, to the last digit
      conductance_[s] = factor_[s] * mean_conductivity(conductivity_[first], conductivity_[second],
                                                       y_weighted_[first] - y_weighted_[second]);
      sum += conductance_[s];
    }
    diagonal_[p] = sum;
  }
}

double HeadOperator::conductance_slope(std::size_t p, std::size_t s, double conductivity_slope) const {
  const std::size_t q = neighbours_.index[s];
  return factor_[s] * mean_conductivity_slope(conductivity_[p], conductivity_[q], y_weighted_[p] - y_weighted_[q],
                                              conductivity_slope);
}

void HeadOperator::apply(std::span<const double> head, std::span<double> outflow) const {
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < diagonal_.size(); ++p) {
    const double here = head[p];
    double sum = 0.0;
    for (std::size_t s = neighbours_.start[p]; s < neighbours_.start[p + 1]; ++s) {
      sum += conductance_[s] * (here - head[neighbours_.index[s]]);
    }
    outflow[p] = sum;
  }
}

void HeadOperator::gradient(std::span<const double> field, const Skeleton& skeleton, std::span<double> dx,
                            std::span<double> dy) const {
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < skeleton.size(); ++p) {
    double xx = 0.0, xy = 0.0, yy = 0.0, gx = 0.0, gy = 0.0;
    for (const Image& q : images_.of(p)) {
      const double second = q.weight * q.r * q.r;
      const double first = q.weight * q.r * (field[p] - field[q.particle]);
      xx += second * q.ex * q.ex;
      xy += second * q.ex * q.ey;
      yy += second * q.ey * q.ey;
      gx += first * q.ex;
      gy += first * q.ey;
    }
    const double determinant = xx * yy - xy * xy;
    const bool regular = determinant > 1.0e-8 * (xx + yy) * (xx + yy);
    dx[p] = regular ? (yy * gx - xy * gy) / determinant : 0.0;
    dy[p] = regular ? (xx * gy - xy * gx) / determinant : 0.0;
  }
}

}  // namespace slope::seepage
