#pragma once

#include <cmath>

namespace slope::seepage {

/// Radial factor F(r) = -W'(r)/r of Wendland's C2 kernel in two dimensions (Wendland 1995), with support 2h:
/// W = 7/(4 pi h^2) (1 - q/2)^4 (2q + 1), q = r/h.
class WendlandC2 {
 public:
  explicit WendlandC2(double smoothing_length)
      : support_(2.0 * smoothing_length), scale_(35.0 / (4.0 * pi * std::pow(smoothing_length, 4))) {}

  [[nodiscard]] double support() const { return support_; }  ///< radius beyond which F is zero (m)

  /// F (1/m4), > 0 inside the support.
  [[nodiscard]] double radial_factor(double r) const {
    const double t = 1.0 - r / support_;
    return t > 0.0 ? scale_ * t * t * t : 0.0;
  }
  /// W (1/m2).
  [[nodiscard]] double value(double r) const {
    const double q = 2.0 * r / support_;
    const double t = 1.0 - 0.5 * q;
    const double h = 0.5 * support_;
    return t > 0.0 ? 7.0 / (4.0 * pi * h * h) * t * t * t * t * (2.0 * q + 1.0) : 0.0;
  }

 private:
  static constexpr double pi = 3.14159265358979323846;
  double support_;
  double scale_;
};

}  // namespace slope::seepage
