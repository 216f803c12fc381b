#include "clock_control.hpp"

#include <algorithm>
#include <cmath>

namespace slope::couple {

namespace {

// In the soil's own time; T is the first period of the layer.
constexpr double block_share = 0.05;   // T between two judgements of the factor
constexpr double growth_time = 3.0;    // T in which the factor grows by e at most: a slide needs time to follow
constexpr double shrinkage = 0.8;      // of the factor after a lively block
constexpr double calm_pressure = 1.3;  // change in a block, over the inertia limit, below which the factor grows

}  // namespace

ClockControl::ClockControl(const Clock& limits, const SlopeScale& scale, std::vector<double> change_times)
    : limits_(limits), scale_(scale), change_times_(std::move(change_times)) {}

ClockControl::Pace ClockControl::pace(double time, double next, double time_step, double prescribed_rate) {
  double factor = factor_;
  if (limits_.adaptive) {
    double since = time;
    for (const double change : change_times_) {
      if (change <= time) since = time - change;
    }
    const double settled = limits_.change_fraction * since / scale_.period();
    const double calm = calm_pressure * limits_.inertia_limit * scale_.overburden;
    const double block = block_share * scale_.period();
    const double steady = prescribed_rate > 0.0 ? calm / (prescribed_rate * block) : never;
    factor = std::min(factor, std::max(1.0, std::min(settled, steady)));
  }
  const double steps = std::ceil((next - time) / (factor * time_step) * (1.0 - 1.0e-12));
  const double water_step = (next - time) / std::max(steps, 1.0);
  Pace pace;
  pace.time_step = std::min(time_step, water_step);
  pace.factor = water_step / pace.time_step;
  pace.velocity_scale = std::min(1.0, factor / last_factor_);
  last_factor_ = factor;
  return pace;
}

double ClockControl::next_change(double time) const {
  const auto next = std::ranges::upper_bound(change_times_, time);
  return next == change_times_.end() ? never : *next;
}

void ClockControl::observe(double time_step, std::span<const double> ux, std::span<const double> uy,
                           std::span<const double> pressure) {
  if (!limits_.adaptive) return;
  const auto begin_block = [&] {
    ux_.assign(ux.begin(), ux.end());
    uy_.assign(uy.begin(), uy.end());
    pressure_.assign(pressure.begin(), pressure.end());
    block_time_ = 0.0;
  };
  if (ux_.empty()) {
    begin_block();
    return;
  }
  block_time_ += time_step;
  if (block_time_ < block_share * scale_.period()) return;
  double farthest = 0.0, pressure_change = 0.0;
  for (std::size_t p = 0; p < ux.size(); ++p) {
    const double dx = ux[p] - ux_[p], dy = uy[p] - uy_[p];
    farthest = std::max(farthest, dx * dx + dy * dy);
    pressure_change = std::max(pressure_change, std::abs(pressure[p] - pressure_[p]));
  }
  // the stress rho c v that a velocity brings into play, over the overburden rho g H
  const double inertia = scale_.wave_speed * std::sqrt(farthest) / block_time_ / (scale_.gravity * scale_.height);
  const double pressure_ratio = pressure_change / scale_.overburden;
  if (inertia > limits_.inertia_limit || pressure_ratio > 2.0 * limits_.inertia_limit) {
    factor_ *= shrinkage;
  } else if (inertia < 0.65 * limits_.inertia_limit && pressure_ratio < calm_pressure * limits_.inertia_limit) {
    factor_ *= std::exp(block_time_ / (growth_time * scale_.period()));
  }
  factor_ = std::clamp(factor_, 1.0, limits_.maximum_factor);
  begin_block();
}

}  // namespace slope::couple
