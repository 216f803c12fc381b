#pragma once

#include <cstddef>
#include <vector>

#include "slope/seepage/soil.hpp"

namespace slope::seepage {

/// The conductivity k k_rw of a soil over the pressure head, and its integral, from a table: for where they are wanted
/// at a pressure that no particle has, many times in a step. Its entries lie sixteen to a factor of e of suction;
/// between them the logarithm of the conductivity is cubic, and it is within 1e-4 of the soil's own laws. Where a law
/// has a kink, as one that comes to its floor has, no cubic follows it: there the logarithm is straight. Conductivity
/// and potential never fall with the pressure.
class ConductivityCurve {
 public:
  struct Value {
    double conductivity = 0.0;  ///< k k_rw (m/s), > 0
    double slope = 0.0;         ///< over the pressure head (1/s), >= 0
    double potential = 0.0;  ///< matric flux potential: the conductivity's integral over the pressure head, from that
                             ///< of very dry soil on (m2/s)
  };

  /// @throws std::invalid_argument as Soil::check() does
  explicit ConductivityCurve(const Soil& soil);

  /// @param pressure_head  P_w / gamma_w (m), any sign
  [[nodiscard]] Value at(double pressure_head) const;
  /// Suction head (m) at which the conductivity has come down to a share of the saturated one, in (0, 1).
  [[nodiscard]] double suction_head_at(double share) const;
  /// The potential alone (m2/s).
  [[nodiscard]] double potential(double pressure_head) const;
  /// Suction head up to which the soil conducts like saturated soil (m), >= 0.
  [[nodiscard]] double wet_until() const { return wet_; }
  /// Conductivity of the saturated soil (m/s).
  [[nodiscard]] double saturated() const { return saturated_; }

 private:
  void integrate();
  void find_kinks();
  [[nodiscard]] bool falls(std::size_t i) const;
  [[nodiscard]] double log_between(std::size_t i, double t) const;
  [[nodiscard]] double potential_between(std::size_t i, double t) const;

  double saturated_;
  double wet_;    // suction head up to which the soil conducts like saturated soil (m)
  double first_;  // suction head of the first entry (m), > wet_ or equal
  double first_log_;
  double wet_potential_ = 0.0;  // at wet_
  // ln K and its slope; the potential, its slope and curvature; all over the number of the entry
  std::vector<double> log_, slope_, potential_, potential_slope_, potential_curvature_;
  std::vector<bool> kink_;  // between an entry and the next
};

}  // namespace slope::seepage
