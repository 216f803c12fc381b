#include "clock_control.hpp"

#include <algorithm>
#include <cmath>

namespace slope::couple {

namespace {

// In the soil's own time; T is the first period of the layer.
constexpr double block_share = 0.05;     // T between two judgements of the factor
constexpr double growth_time = 3.0;      // T in which the factor grows by e at most: a slide needs time to follow
constexpr double shrinkage = 0.8;        // of the factor after a lively block
constexpr double lively = 1.5;           // times what lets the factor grow, from which on it falls
constexpr double calm_pressure = 0.005;  // change of a pressure in a block, over the overburden, that lets it grow
constexpr double little_water = 0.01;  // change of the pore pressures, over the overburden, up to which the limit stays
constexpr double settling_time = 2.0;  // T that the soil gets to settle after a change of the boundary conditions

}  // namespace

ClockControl::ClockControl(const Clock& limits, const SlopeScale& scale, std::vector<double> change_times)
    : limits_(limits), scale_(scale), change_times_(std::move(change_times)) {}

ClockControl::Pace ClockControl::pace(double time, double next, double time_step, double prescribed_rate) {
  double factor = state_.factor;
  if (limits_.adaptive) {
    double since = time;
    for (const double change : change_times_) {
      if (change <= time) since = time - change;
    }
    const double settled = since / (settling_time * scale_.period());
    const double calm = calm_pressure * scale_.overburden / (block_share * scale_.period());  // Pa/s of the soil's time
    const double steady = prescribed_rate > 0.0 ? calm / prescribed_rate : never;
    factor = std::min(factor, std::max(1.0, std::min(settled, steady)));
  }
  const double steps = std::ceil((next - time) / (factor * time_step) * (1.0 - 1.0e-12));
  const double water_step = (next - time) / std::max(steps, 1.0);
  Pace pace;
  pace.time_step = std::min(time_step, water_step);
  pace.factor = water_step / pace.time_step;
  pace.velocity_scale = std::min(1.0, factor / state_.last_factor);
  state_.last_factor = factor;
  return pace;
}

void ClockControl::begin_block(std::span<const double> pressure) {
  state_.pressure.assign(pressure.begin(), pressure.end());
  state_.block_time = state_.block_unbalanced = 0.0;
}

double ClockControl::unbalanced_limit() const {
  return limits_.unbalanced_limit * std::max(1.0, state_.water_change / little_water);
}

void ClockControl::observe(double time_step, double unbalanced_ratio, std::span<const double> first_pressure,
                           std::span<const double> pressure) {
  if (!limits_.adaptive) return;
  if (state_.pressure.empty()) {
    begin_block(pressure);
    return;
  }
  state_.block_time += time_step;
  state_.block_unbalanced += unbalanced_ratio * time_step;
  if (state_.block_time < block_share * scale_.period()) return;
  double pressure_change = 0.0, since_start = 0.0;
  for (std::size_t p = 0; p < pressure.size(); ++p) {
    pressure_change = std::max(pressure_change, std::abs(pressure[p] - state_.pressure[p]));
    since_start += std::abs(pressure[p] - first_pressure[p]);
  }
  const double mean = since_start / static_cast<double>(pressure.size());
  state_.water_change = std::max(state_.water_change, mean / scale_.overburden);
  const double unbalanced = state_.block_unbalanced / state_.block_time;
  if (state_.last_factor > 1.0) state_.largest_unbalanced_ratio = std::max(state_.largest_unbalanced_ratio, unbalanced);
  const double liveliness =
      std::max(unbalanced / unbalanced_limit(), pressure_change / (calm_pressure * scale_.overburden));
  if (liveliness > lively) {
    state_.factor *= shrinkage;
  } else if (liveliness < 1.0) {
    state_.factor *= std::exp(state_.block_time / (growth_time * scale_.period()));
  }
  state_.factor = std::clamp(state_.factor, 1.0, limits_.maximum_factor);
  begin_block(pressure);
}

}  // namespace slope::couple
