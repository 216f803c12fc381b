#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "slope/seepage/images.hpp"
#include "slope/seepage/kernel.hpp"
#include "slope/seepage/neighbours.hpp"
#include "slope/seepage/skeleton.hpp"

namespace slope::seepage {

/// The paper's own discretisation of Darcy's law and of the mass balance (Eqs. 18, 19): the gradient of the pressure,
/// then the divergence of the velocity, each a plain SPH sum, explicit in time. A reference for short runs: on
/// disordered particles it grows without bound whatever the time step, and it does not see a checkerboard of pressures.
/// Use HeadOperator to compute.
///
/// As printed, but for what method and notation need: each term carries the volume V_q of the neighbour; gravity is the
/// particle's own b, so that Eq. 18 is w = -k k_rw grad h with the head h = P_w / gamma_w + y (the acceleration a is
/// left out); the skeleton's part of Eq. 19 is S_r div v, as in Eq. 7. At walls the mirror images of the neighbours
/// take part, with mirrored velocities and the head of the original. The kernel is scaled so that the gradient of a
/// linear field is exact inside the square lattice.
class TwoPassOperator {
 public:
  /// @param spacing  particle spacing (m); @param smoothing_ratio  smoothing length over spacing (-)
  /// @throws std::invalid_argument naming the field that is out of its range
  TwoPassOperator(double spacing, double smoothing_ratio, const MirrorWalls& walls);

  /// Finds the neighbours at the skeleton's present positions; call before the others.
  void update(const Skeleton& skeleton);

  /// Eq. 18: w_p (m/s) from the heads (m) and the conductivities k k_rw (m/s).
  void darcy_velocity(std::span<const double> head, std::span<const double> conductivity, std::span<double> wx,
                      std::span<double> wy) const;

  /// The sums of Eq. 19: divergence (1/s) of a velocity w or v (m/s).
  void divergence(std::span<const double> wx, std::span<const double> wy, std::span<double> divergence) const;

 private:
  WendlandC2 kernel_;
  MirrorWalls walls_;
  double scale_;
  Neighbours neighbours_;
  Images images_;
};

}  // namespace slope::seepage
