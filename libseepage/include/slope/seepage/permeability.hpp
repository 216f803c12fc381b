#pragma once

#include <variant>

#include "slope/seepage/retention.hpp"

namespace slope::seepage {

/// Power of the degree of saturation (Hillel 1971), paper Eq. 10: k_rw = S_r^L.
struct HillelPower {
  double exponent = 2.0;  ///< L (-), > 0

  /// @param suction_head h_s (m); @param saturation S_r (-); @return k_rw (-), before the floor.
  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
};

/// Liakopoulos (1965), paper Eq. 21: k_rw = 1 - a (1 - S_r)^b.
struct LiakopoulosPermeability {
  double coefficient = 2.207;  ///< a (-), > 0
  double exponent = 1.0;       ///< b (-), > 0

  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
};

/// Exponential (Gardner 1958): k_rw = exp(-alpha h_s).
struct ExponentialPermeability {
  double alpha = 0.0;  ///< (1/m), > 0

  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
};

/// van Genuchten (1980) with Mualem's pore model: k_rw = sqrt(S_e) (1 - (1 - S_e^(1/m))^m)^2.
struct VanGenuchtenMualem {
  double n = 0.0;  ///< n' (-), > 1
  SaturationRange range;

  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
};

struct RelativePermeability {
  std::variant<HillelPower, LiakopoulosPermeability, ExponentialPermeability, VanGenuchtenMualem> law;
  double floor = 1.0e-6;  ///< lowest k_rw (-), in (0, 1): keeps every particle reachable for water

  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
};

}  // namespace slope::seepage
