#include "slope/seepage/head_operator.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "moment_correction.hpp"
#include "moved_beyond.hpp"
#include "require.hpp"

namespace slope::seepage {

namespace {

// Share of the spacing by which a particle may move before the pair factors are worked out anew.
constexpr double follow_distance = 0.01;
// Distance of a particle from a seam at least, over the spacing; half of it in a lattice.
constexpr double least_distance = 0.25;

double checked(double spacing, double smoothing_ratio, const MirrorWalls& walls, int threads) {
  require_above(0.0, "spacing", spacing);
  require_above(0.0, "smoothing_ratio", smoothing_ratio);
  require(threads >= 1, "threads", "at least 1", threads);
  walls.check();
  return spacing;
}

}  // namespace

HeadOperator::HeadOperator(double spacing, double smoothing_ratio, const MirrorWalls& walls, int threads)
    : spacing_(checked(spacing, smoothing_ratio, walls, threads)),
      kernel_(smoothing_ratio * spacing),
      walls_(walls),
      threads_(threads),
      lattice_scale_(lattice_scale(kernel_, spacing)) {}

void HeadOperator::set_soils(std::span<const std::uint16_t> soil, std::vector<ConductivityCurve> curves) {
  soil_.assign(soil.begin(), soil.end());
  curves_ = std::move(curves);
}

bool HeadOperator::update(const Skeleton& skeleton) {
  const std::size_t n = skeleton.size();
  assert(skeleton.y.size() == n && skeleton.volume.size() == n && (soil_.empty() || soil_.size() == n));
  if (state_.x.size() == n && !moved_beyond(follow_distance * spacing_, skeleton, state_.x, state_.y)) {
    return false;
  }
  state_.x.assign(skeleton.x.begin(), skeleton.x.end());
  state_.y.assign(skeleton.y.begin(), skeleton.y.end());
  state_.volume.assign(skeleton.volume.begin(), skeleton.volume.end());
  find_pairs();
  state_.seam_pressure_head.assign(seams_.size(), 0.0);
  return true;
}

void HeadOperator::set_state(State state) {
  const std::size_t n = state.x.size();
  if (state.y.size() != n || state.volume.size() != n || (!soil_.empty() && soil_.size() != n)) {
    throw std::invalid_argument("the arrays of the head operator's state differ in length");
  }
  state_ = std::move(state);
  find_pairs();
  if (state_.seam_pressure_head.size() != seams_.size()) {
    throw std::invalid_argument("the head operator's state has another number of pairs across seams");
  }
}

void HeadOperator::find_pairs() {
  neighbours_ = find_neighbours(state_.x, state_.y, kernel_.support(), threads_);
  find_images({state_.x, state_.y, state_.volume, {}}, neighbours_, walls_, kernel_, lattice_scale_, images_);
  find_pair_factors();
  if (curves_.size() > 1) find_seams();
}

void HeadOperator::find_pair_factors() {
  const std::size_t n = state_.x.size();
  const MomentCorrection correction(images_, state_.volume, kernel_, spacing_, threads_);
  factor_.assign(neighbours_.index.size(), 0.0);
  conductance_.assign(factor_.size(), 0.0);
  diagonal_.resize(n);
  conductivity_.resize(n);
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t s = neighbours_.start[p];
    for (const Image& image : images_.of(p)) {
      if (image.particle == p) break;
      while (neighbours_.index[s] != image.particle) ++s;
      factor_[s] += 2.0 * state_.volume[p] * image.weight * correction(p, image);
    }
  }
}

// Takes the pairs across seams out of factor_.
void HeadOperator::find_seams() {
  seams_.clear();
  seam_at_.resize(neighbours_.index.size());
  for (std::uint32_t p = 0; p < neighbours_.size(); ++p) {
    for (std::size_t s = neighbours_.start[p]; s < neighbours_.start[p + 1]; ++s) {
      const std::uint32_t q = neighbours_.index[s];
      if (q < p || soil_[p] == soil_[q]) continue;
      const auto row = neighbours_.of(q);
      const auto back = neighbours_.start[q] + static_cast<std::size_t>(std::ranges::lower_bound(row, p) - row.begin());
      const double here = seam_distance(p, q), there = seam_distance(q, p);
      seam_at_[s] = seam_at_[back] = static_cast<std::uint32_t>(seams_.size());
      seams_.push_back({p, q, s, back, factor_[s], here / (here + there), {}});
      factor_[s] = factor_[back] = 0.0;
    }
  }
}

// Distance of p from the seam on the way to q, a particle of another soil.
double HeadOperator::seam_distance(std::size_t p, std::size_t q) const {
  const double to_x = state_.x[q] - state_.x[p], to_y = state_.y[q] - state_.y[p];
  double nearest = to_x * to_x + to_y * to_y;
  for (const std::uint32_t r : neighbours_.of(p)) {
    const double dx = state_.x[r] - state_.x[p], dy = state_.y[r] - state_.y[p];
    if (soil_[r] == soil_[q] && dx * to_x + dy * to_y > 0.0) nearest = std::min(nearest, dx * dx + dy * dy);
  }
  return std::max(std::sqrt(nearest) - 0.5 * spacing_, least_distance * spacing_);
}

SeamLeg HeadOperator::leg(std::size_t p, double share, double drop) const {
  return {conductivity_[p], &curves_[soil_[p]], share, share * drop};
}

SeamLeg HeadOperator::first_leg(const Seam& seam) const {
  return leg(seam.first, seam.share, state_.y[seam.first] - state_.y[seam.second]);
}

SeamLeg HeadOperator::second_leg(const Seam& seam) const {
  return leg(seam.second, 1.0 - seam.share, state_.y[seam.second] - state_.y[seam.first]);
}

void HeadOperator::set_conductivity(std::span<const double> conductivity) {
  for (std::size_t p = 0; p < diagonal_.size(); ++p) conductivity_[p] = {conductivity[p], 0.0, 0.0};
  find_conductances([this](std::size_t p, std::size_t q) {
    return logarithmic_mean(conductivity_[p].conductivity, conductivity_[q].conductivity);
  });
}

void HeadOperator::set_conductivity(std::span<const double> conductivity, std::span<const double> pressure_head,
                                    std::span<const double> potential) {
  for (std::size_t p = 0; p < diagonal_.size(); ++p) {
    conductivity_[p] = {conductivity[p], pressure_head[p], potential[p]};
  }
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t k = 0; k < seams_.size(); ++k) {
    Seam& seam = seams_[k];
    seam.mean = seam_mean(first_leg(seam), second_leg(seam), state_.seam_pressure_head[k]);
    state_.seam_pressure_head[k] = seam.mean.pressure_head;
    conductance_[seam.place] = conductance_[seam.back] = seam.factor * seam.mean.conductivity;
  }
  find_conductances([this](std::size_t p, std::size_t q) {
    return kirchhoff_mean(conductivity_[p], conductivity_[q], state_.y[p] - state_.y[q]);
  });
}

// The conductances of pairs in one soil, with the mean(p, q) of two particles' conductivities, and their sums with
// those across seams.
template <class Mean>
void HeadOperator::find_conductances(const Mean& mean) {
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t p = 0; p < diagonal_.size(); ++p) {
    double sum = 0.0;
    for (std::size_t s = neighbours_.start[p]; s < neighbours_.start[p + 1]; ++s) {
      if (factor_[s] != 0.0) {
        const std::size_t q = neighbours_.index[s];
        const auto [first, second] = std::minmax(p, q);  // the same for both particles, to the last digit
        conductance_[s] = factor_[s] * mean(first, second);
      }
      sum += conductance_[s];
    }
    diagonal_[p] = sum;
  }
}

double HeadOperator::flow_slope(std::size_t p, std::size_t s, double slope, double fall) const {
  const std::size_t q = neighbours_.index[s];
  if (!soil_.empty() && soil_[p] != soil_[q]) {
    const Seam& seam = seams_[seam_at_[s]];
    const bool from_first = p == seam.first;
    const double reach = from_first ? seam.mean.first_reach : 1.0 - seam.mean.first_reach;
    return seam.factor *
           (seam_flow_slope(from_first ? first_leg(seam) : second_leg(seam), seam.mean.pressure_head, reach, slope) -
            seam.mean.conductivity);
  }
  return factor_[s] * fall * kirchhoff_mean_slope(conductivity_[p], conductivity_[q], state_.y[p] - state_.y[q], slope);
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
