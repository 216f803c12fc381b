#include "rest.hpp"

#include <algorithm>
#include <cmath>

namespace slope::couple {

void RestWatch::begin(double since_onset, std::span<const double> ux, std::span<const double> uy) {
  ux_.assign(ux.begin(), ux.end());
  uy_.assign(uy.begin(), uy.end());
  began_ = since_onset;
  own_time_ = 0.0;
}

bool RestWatch::observe(double since_onset, double own_step, double moved, std::span<const double> ux,
                        std::span<const double> uy) {
  if (ux_.empty()) begin(since_onset, ux, uy);
  own_time_ += own_step;
  if (since_onset < 1.5 * began_ || since_onset < began_ + shortest_ || own_time_ < shortest_) return false;
  double farthest = 0.0;
  for (std::size_t p = 0; p < ux.size(); ++p) farthest = std::max(farthest, std::hypot(ux[p] - ux_[p], uy[p] - uy_[p]));
  begin(since_onset, ux, uy);
  return farthest <= rest_share * moved;
}

}  // namespace slope::couple
