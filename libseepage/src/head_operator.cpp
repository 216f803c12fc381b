#include "slope/seepage/head_operator.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "for_each_index.hpp"
#include "moment_correction.hpp"
#include "moved_beyond.hpp"
#include "require.hpp"

namespace slope::seepage {

namespace {

// Share of the spacing by which a particle may move before the pair factors are worked out anew.
constexpr double follow_distance = 0.01;
// Distance of a particle from a seam at least, over the spacing; half of it in a lattice.
constexpr double least_distance = 0.25;
// The pressure head for which a particle's conductances were worked out, when they were not: far from all (m).
constexpr double unknown = std::numeric_limits<double>::infinity();

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
  for (auto* field : {&state_.conductivity, &state_.potential}) field->assign(n, 0.0);
  state_.pressure_head.assign(n, unknown);
  for (auto* field : {&state_.seam_conductivity, &state_.seam_pressure_head, &state_.seam_reach}) {
    field->assign(seams_.size(), 0.0);
  }
  return true;
}

void HeadOperator::set_state(State state) {
  const std::size_t n = state.x.size();
  for (const auto* field : {&state.y, &state.volume, &state.conductivity, &state.pressure_head, &state.potential}) {
    if (field->size() != n || (!soil_.empty() && soil_.size() != n)) {
      throw std::invalid_argument("the arrays of the head operator's state differ in length");
    }
  }
  state_ = std::move(state);
  find_pairs();
  for (const auto* field : {&state_.seam_conductivity, &state_.seam_pressure_head, &state_.seam_reach}) {
    if (field->size() != seams_.size()) {
      throw std::invalid_argument("the head operator's state has another number of pairs across seams");
    }
  }
  for (std::size_t k = 0; k < seams_.size(); ++k) {
    set_conductance(seams_[k].place, seams_[k].factor * state_.seam_conductivity[k]);
  }
  std::ranges::fill(stale_, std::uint8_t{1});
  find_stale([this](std::size_t p, std::size_t q) { return mean_in_soil(p, q); });
}

void HeadOperator::find_pairs() {
  neighbours_ = find_neighbours(state_.x, state_.y, kernel_.support(), threads_);
  find_images({state_.x, state_.y, state_.volume, {}}, neighbours_, walls_, kernel_, lattice_scale_, images_);
  find_pair_factors();
  find_ways_back();
  if (curves_.size() > 1) find_seams();
}

void HeadOperator::find_pair_factors() {
  const std::size_t n = state_.x.size();
  const MomentCorrection correction(images_, state_.volume, kernel_, spacing_, threads_);
  factor_.assign(neighbours_.index.size(), 0.0);
  conductance_.assign(factor_.size(), 0.0);
  diagonal_.resize(n);
  stale_.assign(n, 0);
  for_each_index(n, threads_, [&](std::size_t p) {
    std::size_t s = neighbours_.start[p];
    for (const Image& image : images_.of(p)) {
      if (image.particle == p) break;
      while (neighbours_.index[s] != image.particle) ++s;
      factor_[s] += 2.0 * state_.volume[p] * image.weight * correction(p, image);
    }
  });
}

// Of a pair the particle that comes first in the order of all finds it after its own place, the other before.
void HeadOperator::find_ways_back() {
  after_.resize(neighbours_.size());
  back_.resize(neighbours_.index.size());
  std::vector<std::size_t> next(neighbours_.start.begin(), neighbours_.start.end() - 1);
  for (std::size_t p = 0; p < neighbours_.size(); ++p) {
    after_[p] = static_cast<std::uint32_t>(next[p]);
    for (std::size_t s = after_[p]; s < neighbours_.start[p + 1]; ++s) {
      const std::size_t back = next[neighbours_.index[s]]++;
      back_[s] = static_cast<std::uint32_t>(back);
      back_[back] = static_cast<std::uint32_t>(s);
    }
  }
}

void HeadOperator::set_conductance(std::size_t s, double conductance) {
  conductance_[s] = conductance_[back_[s]] = conductance;
}

// Takes the pairs across seams out of factor_.
void HeadOperator::find_seams() {
  seams_.clear();
  seam_at_.resize(neighbours_.index.size());
  for (std::uint32_t p = 0; p < neighbours_.size(); ++p) {
    for (std::size_t s = after_[p]; s < neighbours_.start[p + 1]; ++s) {
      const std::uint32_t q = neighbours_.index[s];
      if (soil_[p] == soil_[q]) continue;
      const double here = seam_distance(p, q), there = seam_distance(q, p);
      seam_at_[s] = seam_at_[back_[s]] = static_cast<std::uint32_t>(seams_.size());
      seams_.push_back({p, q, s, factor_[s], here / (here + there)});
      factor_[s] = factor_[back_[s]] = 0.0;
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

PotentialAt HeadOperator::potential_at(std::size_t p) const {
  return {state_.conductivity[p], state_.pressure_head[p], state_.potential[p]};
}

double HeadOperator::mean_in_soil(std::size_t p, std::size_t q) const {
  return kirchhoff_mean(potential_at(p), potential_at(q), state_.y[p] - state_.y[q]);
}

SeamLeg HeadOperator::leg(std::size_t p, double share, double drop) const {
  return {potential_at(p), &curves_[soil_[p]], share, share * drop};
}

SeamLeg HeadOperator::first_leg(const Seam& seam) const {
  return leg(seam.first, seam.share, state_.y[seam.first] - state_.y[seam.second]);
}

SeamLeg HeadOperator::second_leg(const Seam& seam) const {
  return leg(seam.second, 1.0 - seam.share, state_.y[seam.second] - state_.y[seam.first]);
}

void HeadOperator::set_conductivity(std::span<const double> conductivity) {
  for (std::size_t p = 0; p < diagonal_.size(); ++p) set_conductivity(p, {conductivity[p], unknown, 0.0});
  find_stale([this](std::size_t p, std::size_t q) {
    return logarithmic_mean(state_.conductivity[p], state_.conductivity[q]);
  });
}

void HeadOperator::find_conductances() {
  for_each_index(seams_.size(), threads_, [&](std::size_t k) {
    const Seam& seam = seams_[k];
    if ((stale_[seam.first] | stale_[seam.second]) == 0) return;
    const SeamMean mean = seam_mean(first_leg(seam), second_leg(seam), state_.seam_pressure_head[k]);
    state_.seam_conductivity[k] = mean.conductivity;
    state_.seam_pressure_head[k] = mean.pressure_head;
    state_.seam_reach[k] = mean.first_reach;
    set_conductance(seam.place, seam.factor * mean.conductivity);
  });
  find_stale([this](std::size_t p, std::size_t q) { return mean_in_soil(p, q); });
}

// The conductances of stale pairs in one soil, with the mean(p, q) of two particles' conductivities, and the sums of
// all.
template <class Mean>
void HeadOperator::find_stale(const Mean& mean) {
  const std::size_t n = diagonal_.size();
  if (std::ranges::find(stale_, 1) == stale_.end()) return;
  for_each_index(n, threads_, [&](std::size_t p) {
    for (std::size_t s = after_[p]; s < neighbours_.start[p + 1]; ++s) {
      const std::size_t q = neighbours_.index[s];
      if ((stale_[p] | stale_[q]) != 0 && factor_[s] != 0.0) set_conductance(s, factor_[s] * mean(p, q));
    }
  });
  for_each_index(n, threads_, [&](std::size_t p) {
    double sum = 0.0;
    for (std::size_t s = neighbours_.start[p]; s < neighbours_.start[p + 1]; ++s) sum += conductance_[s];
    diagonal_[p] = sum;
  });
  std::ranges::fill(stale_, std::uint8_t{0});
}

double HeadOperator::flow_slope(std::size_t p, std::size_t s, double slope, double fall) const {
  const std::size_t q = neighbours_.index[s];
  if (!soil_.empty() && soil_[p] != soil_[q]) {
    const std::size_t k = seam_at_[s];
    const Seam& seam = seams_[k];
    const bool from_first = p == seam.first;
    const double reach = from_first ? state_.seam_reach[k] : 1.0 - state_.seam_reach[k];
    return seam.factor * (seam_flow_slope(from_first ? first_leg(seam) : second_leg(seam), state_.seam_pressure_head[k],
                                          reach, slope) -
                          state_.seam_conductivity[k]);
  }
  return factor_[s] * fall * kirchhoff_mean_slope(potential_at(p), potential_at(q), state_.y[p] - state_.y[q], slope);
}

void HeadOperator::apply(std::span<const double> head, std::span<double> outflow) const {
  for_each_index(diagonal_.size(), threads_, [&](std::size_t p) {
    const double here = head[p];
    // four sums, so that one addition need not wait for another
    std::array<double, 4> sum{};
    std::size_t s = neighbours_.start[p];
    const std::size_t end = neighbours_.start[p + 1];
    for (; s + 4 <= end; s += 4) {
      for (std::size_t k = 0; k < 4; ++k) sum[k] += conductance_[s + k] * (here - head[neighbours_.index[s + k]]);
    }
    for (; s < end; ++s) sum[0] += conductance_[s] * (here - head[neighbours_.index[s]]);
    outflow[p] = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  });
}

void HeadOperator::gradient(std::span<const double> field, const Skeleton& skeleton, std::span<double> dx,
                            std::span<double> dy) const {
  for_each_index(skeleton.size(), threads_, [&](std::size_t p) {
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
  });
}

}  // namespace slope::seepage
