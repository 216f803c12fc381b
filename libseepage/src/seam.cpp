#include "slope/seepage/seam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slope::seepage {

namespace {

constexpr double matched = 1.0e-10;  // difference of the two legs' flows over their sum
constexpr double nothing = 1.0e-10;  // difference of heads (m)
constexpr int most_iterations = 100;

// The flow from the end of a leg to the seam, times the length of the path.
struct LegFlow {
  double mean;   // conductivity of the leg (m/s)
  double flow;   // (m2/s)
  double slope;  // over the pressure head at the seam (m/s), < 0 save in soil that is very steep over the leg
};

LegFlow flow_of(const SeamLeg& leg, double pressure_head) {
  const ConductivityCurve::Value at_seam = leg.curve->at(pressure_head);
  const PotentialAt seam{at_seam.conductivity, pressure_head, at_seam.potential};
  const double mean = kirchhoff_mean(leg.end, seam, leg.drop);
  const double fall = leg.head() - pressure_head;
  const double bend = kirchhoff_mean_slope(seam, leg.end, -leg.drop, at_seam.slope);
  return {mean, mean * fall / leg.share, (bend * fall - mean) / leg.share};
}

}  // namespace

SeamMean seam_mean(const SeamLeg& a, const SeamLeg& b, double guess) {
  double low = std::min(a.head(), b.head()), high = std::max(a.head(), b.head());
  double seam = std::clamp(guess, low, high);
  double last_gain = std::numeric_limits<double>::infinity();
  for (int k = 0;; ++k) {
    const LegFlow first = flow_of(a, seam), second = flow_of(b, seam);
    const double gain = first.flow + second.flow;  // of the seam, which falls with its pressure
    const double slope = std::min(first.slope + second.slope, -1.0e-3 * (first.mean + second.mean));
    const double size = std::abs(gain);
    if (size <= matched * (std::abs(first.flow) + std::abs(second.flow)) || high - low <= nothing ||
        k == most_iterations) {
      return {1.0 / (a.share / first.mean + b.share / second.mean), seam, second.slope / slope};
    }
    (gain > 0.0 ? low : high) = seam;
    const double next = seam - gain / slope;
    const bool sound = size < 0.5 * last_gain && next > low && next < high;
    seam = sound ? next : 0.5 * (low + high);
    last_gain = size;
  }
}

double seam_flow_slope(const SeamLeg& leg, double pressure_head, double reach, double slope) {
  const ConductivityCurve::Value at_seam = leg.curve->at(pressure_head);
  const PotentialAt seam{at_seam.conductivity, pressure_head, at_seam.potential};
  const double mean = kirchhoff_mean(leg.end, seam, leg.drop);
  const double bend = kirchhoff_mean_slope(leg.end, seam, leg.drop, slope);
  return reach * (bend * (leg.head() - pressure_head) + mean) / leg.share;
}

}  // namespace slope::seepage
