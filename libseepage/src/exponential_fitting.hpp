#pragma once

// The two functions of exponential fitting (Scharfetter and Gummel 1969).

#include <cmath>

namespace slope::seepage {

/// (e^t - 1) / t
inline double phi(double t) {
  return std::abs(t) < 1.0e-3 ? 1.0 + t * (0.5 + t / 6.0) : std::expm1(t) / t;
}

/// Slope of ln(phi).
inline double log_phi_slope(double t) {
  if (std::abs(t) < 1.0e-3) return 0.5 + t / 12.0;
  return -1.0 / std::expm1(-t) - 1.0 / t;
}

}  // namespace slope::seepage
