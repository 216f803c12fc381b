#pragma once

#include <variant>

#include "slope/seepage/exponential_permeability.hpp"
#include "slope/seepage/hillel_permeability.hpp"
#include "slope/seepage/liakopoulos_permeability.hpp"
#include "slope/seepage/van_genuchten_mualem.hpp"

namespace slope::seepage {

/// The relative permeability of a soil: one of the laws, each with evaluate(suction head, saturation) -> k_rw, and a
/// floor.
struct RelativePermeability {
  std::variant<HillelPower, LiakopoulosPermeability, ExponentialPermeability, VanGenuchtenMualem> law;
  double floor = 1.0e-6;  ///< lowest k_rw (-), in (0, 1): keeps every particle reachable for water

  /// @param suction_head h_s (m), any sign; @param saturation S_r (-); @return k_rw (-), in [floor, 1].
  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
};

}  // namespace slope::seepage
