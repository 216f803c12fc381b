#pragma once

#include "slope/seepage/conductivity_curve.hpp"
#include "slope/seepage/mean_conductivity.hpp"

namespace slope::seepage {

/// The part of a straight path that lies in one soil: from an end to the seam where the other soil begins.
struct SeamLeg {
  PotentialAt end;                           ///< of the path
  const ConductivityCurve* curve = nullptr;  ///< of the leg's soil
  double share = 0.5;                        ///< of the path's length (-), in (0, 1)
  double drop = 0.0;                         ///< height of the end above the seam (m), any sign

  /// Head of the end above the seam's height (m).
  [[nodiscard]] double head() const { return end.pressure_head + drop; }
};

/// What a path through two soils conducts.
struct SeamMean {
  double conductivity = 0.0;   ///< (m/s); times the fall of the head from end to end it is the flow times the length
  double pressure_head = 0.0;  ///< at the seam (m)
  double first_reach =
      0.5;  ///< share of what the first end changes in the flow of its leg that becomes flow through
            ///< both (-), in [0, 1] unless a leg is very steep; of what the second end changes it is the rest
};

/// The mean conductivity of a path from a to b through two soils. The pressure at the seam is the same for both, and
/// the flow through it too:
///
///     K_a (h_a - h_s) / l_a = K_b (h_s - h_b) / l_b,     1 / K = l_a / K_a + l_b / K_b,
///
/// with the head h_s at the seam, the legs' shares l, and in each leg the kirchhoff_mean() of its own soil between
/// its end and the seam. h_s lies between the heads of the ends. Saturated, it is the harmonic mean; it changes
/// steadily with the pressures at the ends, also through saturation and where the flow turns.
/// @param guess  of the pressure head at the seam (m); what is found depends on it by rounding only
[[nodiscard]] SeamMean seam_mean(const SeamLeg& a, const SeamLeg& b, double guess);

/// How the flow out of the end of a leg, times the length of the path, changes with the pressure head at that end
/// (m/s).
/// @param pressure_head  at the seam (m); @param reach  of the leg; @param slope  of the conductivity at the end over
/// the pressure head (1/s), >= 0
[[nodiscard]] double seam_flow_slope(const SeamLeg& leg, double pressure_head, double reach, double slope);

}  // namespace slope::seepage
