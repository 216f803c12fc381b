#pragma once

namespace slope::seepage {

/// Conductivity k k_rw (m/s), > 0, and pressure head P_w / gamma_w (m) at one end of a path.
struct ConductivityAt {
  double conductivity = 0.0;
  double pressure_head = 0.0;
};

/// The conductivity (m/s) that gives the steady flow from one end of a straight path to the other when it is multiplied
/// by the fall of the hydraulic head along it, in soil whose conductivity is exponential in the pressure head:
///
///     K = K_b phi(d + x) / phi(x),   phi(t) = (e^t - 1) / t,   d = ln(K_a / K_b),   x = d z / (psi_a - psi_b),
///
/// with z the drop from a to b; where both ends are alike, a shorter formula within a quarter of a percent. It is the
/// same from b to a. Level, it is the logarithmic mean; straight down into dry soil it goes from that to the
/// conductivity of the wet end as the path gets longer than 1/alpha: gravity carries water over a front that is thinner
/// than the distance of two particles. Exponential fitting as of Scharfetter and Gummel (1969), IEEE Trans. Electron
/// Devices 16, whose drift is gravity here.
/// @param drop  height of a above b (m), any sign
[[nodiscard]] double mean_conductivity(const ConductivityAt& a, const ConductivityAt& b, double drop);

/// Slope of the mean over the pressure head at a (1/s). @param slope  of the conductivity there, dK_a/dpsi_a (1/s), >=
/// 0
[[nodiscard]] double mean_conductivity_slope(const ConductivityAt& a, const ConductivityAt& b, double drop,
                                             double slope);

/// Conductivity k k_rw (m/s), > 0, pressure head (m) and matric flux potential (m2/s, the integral of the conductivity
/// over the pressure head, from anywhere) at one end of a path.
struct PotentialAt {
  double conductivity = 0.0;
  double pressure_head = 0.0;
  double potential = 0.0;
};

/// The same mean in soil whose curve is known between the ends. Level it is exact, the fall of the potential over that
/// of the pressure (Kirchhoff's transformation): ends of which one lies where the curve is flat and the other where it
/// is steep are far from an exponential. With gravity it keeps, between that and the conductivity of the end to which
/// the mean tends on a long way down or up, the place that the exponential has, whose length 1/alpha is then the fall
/// of the potential over that of the conductivity.
[[nodiscard]] double kirchhoff_mean(const PotentialAt& a, const PotentialAt& b, double drop);
[[nodiscard]] double kirchhoff_mean_slope(const PotentialAt& a, const PotentialAt& b, double drop, double slope);

}  // namespace slope::seepage
