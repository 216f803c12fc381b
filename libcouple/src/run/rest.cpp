#include "rest.hpp"

#include <algorithm>
#include <cmath>

namespace slope::couple {

void RestWatch::begin(double since_onset, std::span<const double> ux, std::span<const double> uy) {
  state_.ux.assign(ux.begin(), ux.end());
  state_.uy.assign(uy.begin(), uy.end());
  state_.began = since_onset;
  state_.own_time = 0.0;
}

bool RestWatch::observe(double since_onset, double own_step, double moved, std::span<const double> ux,
                        std::span<const double> uy) {
  if (state_.ux.empty()) begin(since_onset, ux, uy);
  state_.own_time += own_step;
  if (since_onset < 1.5 * state_.began || since_onset < state_.began + shortest_ || state_.own_time < shortest_)
    return false;
  double farthest = 0.0;
  for (std::size_t p = 0; p < ux.size(); ++p)
    farthest = std::max(farthest, std::hypot(ux[p] - state_.ux[p], uy[p] - state_.uy[p]));
  begin(since_onset, ux, uy);
  return farthest <= rest_share * moved;
}

}  // namespace slope::couple
