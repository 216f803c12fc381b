#include "onset.hpp"

#include <algorithm>

namespace slope::couple {

namespace {

constexpr double samples_per_growth = 32.0;

}  // namespace

RunawayWatch::RunawayWatch(double growth, double at_once) : growth_(growth), at_once_(at_once) {}

bool RunawayWatch::observe(double time, double displacement) {
  if (time_) return false;
  const Sample before = latest_;
  latest_ = {time, std::max(displacement, before.displacement)};
  if (latest_.displacement - samples_.back().displacement < growth_ / samples_per_growth) return false;
  // what it came from too: it may have rested there for long
  if (before.time > samples_.back().time) samples_.push_back(before);
  samples_.push_back(latest_);
  find_kink();
  return time_.has_value();
}

// Goes from kink to kink while there is one that is sharp enough; one after which too little has moved may become the
// one that counts, so nothing is decided yet.
void RunawayWatch::find_kink() {
  const Sample& last = samples_.back();
  std::optional<std::size_t> found;
  for (std::size_t start = 0;;) {
    const std::size_t kink = deepest_after(start);
    if (kink == start) break;
    const Sample &first = samples_[start], &at = samples_[kink];
    const double before = (at.displacement - first.displacement) / (at.time - first.time);
    const double after = (last.displacement - at.displacement) / (last.time - at.time);
    if (after < runaway_ratio * before) break;
    if (last.displacement - at.displacement < growth_) return;
    if (goes_on_after(kink)) found = kink;
    start = kink;
  }
  if (!found && last.time <= at_once_ && goes_on_after(0)) found = 0;
  if (!found) return;
  time_ = samples_[*found].time;
  displacement_ = samples_[*found].displacement;
}

// Whether enough has moved after a sample, and not slower and slower.
bool RunawayWatch::goes_on_after(std::size_t kink) const {
  const Sample &at = samples_[kink], &last = samples_.back();
  if (last.displacement - at.displacement < growth_) return false;
  const double half = time_of(0.5 * (at.displacement + last.displacement), kink);
  return last.time - half <= slowing_ratio * (half - at.time);
}

// The time at which a displacement was passed, after a sample that has less.
double RunawayWatch::time_of(double displacement, std::size_t from) const {
  const auto after = std::find_if(samples_.begin() + static_cast<std::ptrdiff_t>(from) + 1, samples_.end(),
                                  [&](const Sample& sample) { return sample.displacement >= displacement; });
  const Sample &a = *(after - 1), &b = *after;
  return a.time + (b.time - a.time) * (displacement - a.displacement) / (b.displacement - a.displacement);
}

// The sample that lies deepest below the chord from one to the last; that one itself if none does.
std::size_t RunawayWatch::deepest_after(std::size_t start) const {
  const Sample &first = samples_[start], &last = samples_.back();
  const double chord = (last.displacement - first.displacement) / (last.time - first.time);
  std::size_t result = start;
  double deepest = 0.0;
  for (std::size_t k = start + 1; k + 1 < samples_.size(); ++k) {
    const double depth = chord * (samples_[k].time - first.time) - (samples_[k].displacement - first.displacement);
    if (depth <= deepest) continue;
    deepest = depth;
    result = k;
  }
  return result;
}

}  // namespace slope::couple
