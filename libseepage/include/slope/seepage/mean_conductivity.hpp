#pragma once

namespace slope::seepage {

/// Conductivity k k_rw (m/s), > 0, pressure head psi = P_w / gamma_w (m) and matric flux potential Phi (m2/s, the
/// integral of the conductivity over the pressure head, from anywhere) at one end of a path.
struct PotentialAt {
  double conductivity = 0.0;
  double pressure_head = 0.0;
  double potential = 0.0;
};

/// The conductivity (m/s) that gives the steady flow from one end of a straight path to the other, all in one soil,
/// when it is multiplied by the fall of the hydraulic head along it. Level it is exact, the fall of the potential over
/// that of the pressure head (Kirchhoff's transformation),
///
///     M = (Phi_a - Phi_b) / (psi_a - psi_b).
///
/// With the wetter end above, it is that of the steady flow in exponential soil with the same conductivities and
/// potentials at the ends, alpha = (K_a - K_b) / (Phi_a - Phi_b): on a path that drops by z from a to b
///
///     K (psi_a - psi_b + z) = K_b z + (Phi_a - Phi_b) / phi(-alpha z),   phi(t) = (e^t - 1) / t.
///
/// or M where that is more. Gravity so carries water over a front that is thinner than the distance of two particles.
/// With the wetter end below
/// there is a state without flow, where that would not vanish; there it is exponential fitting as of Scharfetter and
/// Gummel (1969), IEEE Trans. Electron Devices 16, with gravity for their drift,
///
///     G = K_b phi(d + x) / phi(x),   d = ln(K_a / K_b),   x = d z / (psi_a - psi_b),
///
/// times 1 + (M / L - 1) / (1 + |z / (psi_a - psi_b)|), with the level mean L = (K_a - K_b) / d of that exponential. In
/// exponential soil both are exact; the mean is the same from b to a.
/// @param drop  height of a above b (m), any sign
[[nodiscard]] double kirchhoff_mean(const PotentialAt& a, const PotentialAt& b, double drop);

/// Slope of the mean over the pressure head at a (1/s). @param slope  of the conductivity there, dK_a/dpsi_a (1/s), >=
/// 0
[[nodiscard]] double kirchhoff_mean_slope(const PotentialAt& a, const PotentialAt& b, double drop, double slope);

/// (a - b) / ln(a / b): the mean on a level path in soil that is exponential between two conductivities (m/s), > 0.
[[nodiscard]] double logarithmic_mean(double a, double b);

}  // namespace slope::seepage
