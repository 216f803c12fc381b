#include "slope/seepage/head_operator.hpp"

#include <Eigen/Core>
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace slope::seepage {

namespace {

// Share of the spacing by which a particle may move before the pair factors are worked out anew.
constexpr double follow_distance = 0.01;
// Sweeps of the moment correction; each reduces what is left about fivefold.
constexpr int correction_sweeps = 4;
// Bounds of a pair's correction, relative to that of the regular lattice: they keep every conductance positive.
constexpr double least_correction = 0.1;
constexpr double largest_correction = 4.0;

double along(double ex, double ey, double xx, double xy, double yy) {
  return ex * ex * xx + 2.0 * ex * ey * xy + ey * ey * yy;
}

}  // namespace

HeadOperator::HeadOperator(double spacing, double smoothing_ratio, const MirrorWalls& walls, int threads)
    : spacing_(spacing), kernel_(smoothing_ratio * spacing), walls_(walls), threads_(threads) {
  const int reach = static_cast<int>(std::ceil(kernel_.support() / spacing));
  const double volume = spacing * spacing;
  double moment = 0.0, surface = 0.0;
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      if (i == 0 && j == 0) continue;
      const double f = volume * kernel_.radial_factor(spacing * std::hypot(i, j));
      moment += f * i * i * volume;
      if (j > 0) surface += f * j * spacing;
    }
  }
  lattice_scale_ = 1.0 / moment;
  flat_surface_ = surface;
}

bool HeadOperator::update(const Skeleton& skeleton) {
  const std::size_t n = skeleton.size();
  if (x_weighted_.size() == n) {
    const double limit = follow_distance * spacing_;
    double farthest = 0.0;
    for (std::size_t p = 0; p < n; ++p) {
      const double dx = skeleton.x[p] - x_weighted_[p], dy = skeleton.y[p] - y_weighted_[p];
      farthest = std::max(farthest, dx * dx + dy * dy);
    }
    if (farthest <= limit * limit) return false;
  }
  x_weighted_.assign(skeleton.x.begin(), skeleton.x.end());
  y_weighted_.assign(skeleton.y.begin(), skeleton.y.end());
  neighbours_ = find_neighbours(skeleton.x, skeleton.y, kernel_.support(), threads_);
  find_pair_factors(skeleton);
  return true;
}

// Calls visit(rx, ry, F, parity) for q and each of its mirror images in reach of p, with r = x_p - x_q and the sign
// that the image's xy components have.
template <class Visit>
void HeadOperator::visit_images(const Skeleton& skeleton, std::size_t p, std::size_t q, Visit&& visit) const {
  const double px = skeleton.x[p], py = skeleton.y[p];
  const double qx = skeleton.x[q], qy = skeleton.y[q];
  const std::array<double, 3> xs{qx, 2.0 * walls_.left - qx, 2.0 * walls_.right - qx};
  const std::array<double, 3> ys{qy, 2.0 * walls_.base - qy, 2.0 * walls_.top - qy};
  const double support = kernel_.support();
  for (std::size_t i = 0; i < 3; ++i) {
    const double rx = px - xs[i];
    if (!(std::abs(rx) < support)) continue;
    for (std::size_t j = 0; j < 3; ++j) {
      const double ry = py - ys[j];
      if (!(std::abs(ry) < support)) continue;
      const double f = kernel_.radial_factor(std::hypot(rx, ry));
      if (f > 0.0) visit(rx, ry, f, (i == 0) == (j == 0) ? 1.0 : -1.0);
    }
  }
}

// The unit tensor inside; at a free surface with normal n, unit along it and half of it across, as half of the
// neighbours are missing.
std::vector<HeadOperator::Tensor> HeadOperator::target_moments(const Skeleton& skeleton) const {
  std::vector<Tensor> target(skeleton.size());
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < skeleton.size(); ++p) {
    double cx = 0.0, cy = 0.0;
    const auto add = [&](std::size_t q) {
      visit_images(skeleton, p, q, [&](double rx, double ry, double f, double) {
        cx += skeleton.volume[q] * f * rx;
        cy += skeleton.volume[q] * f * ry;
      });
    };
    for (const std::uint32_t q : neighbours_.of(p)) add(q);
    const double length = std::hypot(cx, cy);
    target[p] = {1.0, 0.0, 1.0};
    if (length == 0.0) continue;
    const double missing = 0.5 * std::min(1.0, length / flat_surface_);
    const double nx = cx / length, ny = cy / length;
    target[p] = {1.0 - missing * nx * nx, -missing * nx * ny, 1.0 - missing * ny * ny};
  }
  return target;
}

void HeadOperator::correct_moments(const Skeleton& skeleton, const std::vector<Tensor>& target,
                                   std::vector<Tensor>& tensor) const {
  const std::vector<Tensor> old = tensor;
  const double root_two = std::sqrt(2.0);
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < skeleton.size(); ++p) {
    // in the basis (xx, sqrt(2) xy, yy) the map from a tensor to the moment that it makes is symmetric
    Eigen::Matrix3d map = Eigen::Matrix3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const std::uint32_t q : neighbours_.of(p)) {
      visit_images(skeleton, p, q, [&](double rx, double ry, double f, double parity) {
        const double squared = rx * rx + ry * ry;
        const double w = skeleton.volume[q] * f / squared;
        const Eigen::Vector3d m(rx * rx, root_two * rx * ry, ry * ry);
        const double correction =
            0.5 * along(rx, ry, old[p].xx + old[q].xx, old[p].xy + parity * old[q].xy, old[p].yy + old[q].yy);
        map += w * m * m.transpose();
        moment += w * correction * m;
      });
    }
    const double size = map.trace();
    if (!(size > 0.0)) continue;
    map.diagonal().array() += 1.0e-3 * size;
    const Eigen::Vector3d wanted(target[p].xx, root_two * target[p].xy, target[p].yy);
    const Eigen::Vector3d change = map.ldlt().solve(wanted - moment);
    tensor[p] = {old[p].xx + change[0], old[p].xy + change[1] / root_two, old[p].yy + change[2]};
  }
}

void HeadOperator::find_pair_factors(const Skeleton& skeleton) {
  const std::size_t n = skeleton.size();
  std::vector<Tensor> tensor(n, {lattice_scale_, 0.0, lattice_scale_});
  const std::vector<Tensor> target = target_moments(skeleton);
  for (int sweep = 0; sweep < correction_sweeps; ++sweep) correct_moments(skeleton, target, tensor);

  factor_.resize(neighbours_.index.size());
  conductance_.resize(factor_.size());
  diagonal_.resize(n);
  const double least = least_correction * lattice_scale_;
  const double largest = largest_correction * lattice_scale_;
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t s = neighbours_.start[p]; s < neighbours_.start[p + 1]; ++s) {
      const std::size_t q = neighbours_.index[s];
      double sum = 0.0;
      visit_images(skeleton, p, q, [&](double rx, double ry, double f, double parity) {
        const double correction = 0.5 *
                                  along(rx, ry, tensor[p].xx + tensor[q].xx, tensor[p].xy + parity * tensor[q].xy,
                                        tensor[p].yy + tensor[q].yy) /
                                  (rx * rx + ry * ry);
        sum += f * std::clamp(correction, least, largest);
      });
      factor_[s] = 2.0 * skeleton.volume[p] * skeleton.volume[q] * sum;
    }
  }
}

void HeadOperator::set_conductivity(std::span<const double> conductivity) {
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < diagonal_.size(); ++p) {
    double sum = 0.0;
    for (std::size_t s = neighbours_.start[p]; s < neighbours_.start[p + 1]; ++s) {
      conductance_[s] = 0.5 * factor_[s] * (conductivity[p] + conductivity[neighbours_.index[s]]);
      sum += conductance_[s];
    }
    diagonal_[p] = sum;
  }
}

void HeadOperator::apply(std::span<const double> head, std::span<double> outflow) const {
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < diagonal_.size(); ++p) {
    double sum = 0.0;
    for (std::size_t s = neighbours_.start[p]; s < neighbours_.start[p + 1]; ++s) {
      sum += conductance_[s] * (head[p] - head[neighbours_.index[s]]);
    }
    outflow[p] = sum;
  }
}

void HeadOperator::gradient(std::span<const double> field, const Skeleton& skeleton, std::span<double> dx,
                            std::span<double> dy) const {
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < skeleton.size(); ++p) {
    double xx = 0.0, xy = 0.0, yy = 0.0, gx = 0.0, gy = 0.0;
    for (const std::uint32_t q : neighbours_.of(p)) {
      visit_images(skeleton, p, q, [&](double rx, double ry, double f, double) {
        const double w = skeleton.volume[q] * f;
        xx += w * rx * rx;
        xy += w * rx * ry;
        yy += w * ry * ry;
        gx += w * rx * (field[p] - field[q]);
        gy += w * ry * (field[p] - field[q]);
      });
    }
    const double determinant = xx * yy - xy * xy;
    const bool regular = determinant > 1.0e-8 * (xx + yy) * (xx + yy);
    dx[p] = regular ? (yy * gx - xy * gy) / determinant : 0.0;
    dy[p] = regular ? (xx * gy - xy * gx) / determinant : 0.0;
  }
}

}  // namespace slope::seepage
