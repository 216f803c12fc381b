#include "onset.hpp"

#include <algorithm>

namespace slope::couple {

namespace {

constexpr double samples_per_growth = 32.0;

}  // namespace

RunawayWatch::RunawayWatch(double growth, double at_once) : growth_(growth), at_once_(at_once) {}

bool RunawayWatch::observe(double time, double displacement) {
  if (state_.time) return false;
  const Sample before = state_.latest;
  state_.latest = {time, std::max(displacement, before.displacement)};
  if (state_.latest.displacement - state_.samples.back().displacement < growth_ / samples_per_growth) return false;
  // what it came from too: it may have rested there for long
  if (before.time > state_.samples.back().time) state_.samples.push_back(before);
  state_.samples.push_back(state_.latest);
  find_kink();
  return state_.time.has_value();
}

// Goes from kink to kink while there is one that is sharp enough; one after which too little has moved may become the
// one that counts, so nothing is decided yet.
void RunawayWatch::find_kink() {
  const Sample& last = state_.samples.back();
  std::optional<std::size_t> found;
  for (std::size_t start = 0;;) {
    const std::size_t kink = deepest_after(start);
    if (kink == start) break;
    const Sample &first = state_.samples[start], &at = state_.samples[kink];
    const double before = (at.displacement - first.displacement) / (at.time - first.time);
    const double after = (last.displacement - at.displacement) / (last.time - at.time);
    if (after < runaway_ratio * before) break;
    if (last.displacement - at.displacement < growth_) return;
    if (goes_on_after(kink)) found = kink;
    start = kink;
  }
  if (!found && last.time <= at_once_ && goes_on_after(0)) found = 0;
  if (!found) return;
  state_.time = state_.samples[*found].time;
  state_.displacement = state_.samples[*found].displacement;
}

// Whether enough has moved after a sample, and not slower and slower.
bool RunawayWatch::goes_on_after(std::size_t kink) const {
  const Sample &at = state_.samples[kink], &last = state_.samples.back();
  if (last.displacement - at.displacement < growth_) return false;
  const double half = time_of(0.5 * (at.displacement + last.displacement), kink);
  return last.time - half <= slowing_ratio * (half - at.time);
}

// The time at which a displacement was passed, after a sample that has less.
double RunawayWatch::time_of(double displacement, std::size_t from) const {
  const auto after = std::find_if(state_.samples.begin() + static_cast<std::ptrdiff_t>(from) + 1, state_.samples.end(),
                                  [&](const Sample& sample) { return sample.displacement >= displacement; });
  const Sample &a = *(after - 1), &b = *after;
  return a.time + (b.time - a.time) * (displacement - a.displacement) / (b.displacement - a.displacement);
}

// The sample that lies deepest below the chord from one to the last; that one itself if none does.
std::size_t RunawayWatch::deepest_after(std::size_t start) const {
  const Sample &first = state_.samples[start], &last = state_.samples.back();
  const double chord = (last.displacement - first.displacement) / (last.time - first.time);
  std::size_t result = start;
  double deepest = 0.0;
  for (std::size_t k = start + 1; k + 1 < state_.samples.size(); ++k) {
    const double depth =
        chord * (state_.samples[k].time - first.time) - (state_.samples[k].displacement - first.displacement);
    if (depth <= deepest) continue;
    deepest = depth;
    result = k;
  }
  return result;
}

}  // namespace slope::couple
