#pragma once

#include <variant>

#include "slope/seepage/exponential_permeability.hpp"
#include "slope/seepage/hillel_permeability.hpp"
#include "slope/seepage/liakopoulos_permeability.hpp"
#include "slope/seepage/saturation.hpp"
#include "slope/seepage/van_genuchten_mualem.hpp"

namespace slope::seepage {

/// The relative permeability of a soil: one of the laws, each with evaluate(suction head, saturation) -> k_rw and
/// slope() -> dk_rw/dh_s and check(), and a floor.
struct RelativePermeability {
  std::variant<HillelPower, LiakopoulosPermeability, ExponentialPermeability, VanGenuchtenMualem> law;
  double floor = 1.0e-14;  ///< lowest k_rw (-), in (0, 1): what laws that reach or pass 0 end at

  /// @throws std::invalid_argument naming the field that is out of its range
  void check() const;
  /// @param suction_head h_s (m), any sign; @param saturation S_r (-); @return k_rw (-), in [floor, 1].
  [[nodiscard]] double evaluate(double suction_head, double saturation) const;
  /// dk_rw/dh_s (1/m), <= 0; 0 where the floor holds. @param saturation  S_r and its slope at h_s
  [[nodiscard]] double slope(double suction_head, const Saturation& saturation) const;
};

}  // namespace slope::seepage
