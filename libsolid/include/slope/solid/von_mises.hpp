#pragma once

#include "slope/solid/return.hpp"
#include "slope/solid/soil.hpp"
#include "slope/solid/tensor.hpp"

namespace slope::solid {

/// The yield function f = sqrt(J_2) - s_u at one plastic strain. Where the soil flows in plane strain, sigma_zz lies
/// midway between the two others and sqrt(J_2) is half of their difference; in triaxial compression that difference
/// reaches sqrt(3) s_u.
struct YieldCylinder {
  double undrained_strength = 0.0;  ///< s_u (Pa)

  /// f (Pa); <= 0 inside.
  [[nodiscard]] double value(const SymmetricTensor& stress) const;
  /// The largest shear stress along a plane on which soil slides (Pa): s_u whatever the normal stress.
  [[nodiscard]] double shear_along_slip(double normal_stress) const;
  /// Its own flow keeps the volume.
  [[nodiscard]] YieldCylinder isochoric() const { return *this; }
};

/// The cylinder as a function of plastic strain.
class SofteningCylinder {
 public:
  explicit SofteningCylinder(const VonMises& strength) : strength_(strength) {}
  /// @param suction  does not matter
  /// @param plastic_strain  accumulated, deviatoric (-), >= 0
  [[nodiscard]] YieldCylinder at(double suction, double plastic_strain = 0.0) const;

 private:
  VonMises strength_;
};

/// Brings a trial stress back to the yield surface by shrinking its deviator; the mean stress stays, tension included.
/// @param stress  trial effective stress in, admissible stress out (Pa)
Return return_to_yield_surface(const YieldCylinder& cylinder, const Elastic& elastic, SymmetricTensor& stress);

}  // namespace slope::solid
