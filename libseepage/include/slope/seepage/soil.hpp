#pragma once

#include "slope/seepage/permeability.hpp"
#include "slope/seepage/retention.hpp"

namespace slope::seepage {

/// What the pore water feels of one material.
struct Soil {
  Retention retention;
  RelativePermeability relative_permeability;
  double hydraulic_conductivity = 0.0;  ///< k (m/s), > 0: saturated conductivity

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
};

/// The pore water and the gravity it feels.
struct Water {
  double density = 1000.0;      ///< rho_w (kg/m3), > 0
  double bulk_modulus = 2.0e9;  ///< K_w (Pa), > 0
  double gravity = 9.81;        ///< g (m/s2), > 0, acting towards -y

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
  [[nodiscard]] double unit_weight() const { return density * gravity; }  ///< gamma_w (N/m3)
};

}  // namespace slope::seepage
