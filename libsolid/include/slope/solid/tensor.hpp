#pragma once

#include <cmath>

namespace slope::solid {

/// Symmetric tensor in plane strain: the components xz and yz are zero. Tension positive.
/// `xy` is the tensor component, half of the engineering shear strain.
struct SymmetricTensor {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
  double xy = 0.0;
};

[[nodiscard]] inline double trace(const SymmetricTensor& t) {
  return t.xx + t.yy + t.zz;
}

[[nodiscard]] inline SymmetricTensor deviator(const SymmetricTensor& t) {
  const double mean = trace(t) / 3.0;
  return {t.xx - mean, t.yy - mean, t.zz - mean, t.xy};
}

/// Second invariant J_2 = s:s / 2 of the deviator s of t.
[[nodiscard]] inline double second_invariant(const SymmetricTensor& t) {
  const SymmetricTensor s = deviator(t);
  return 0.5 * (s.xx * s.xx + s.yy * s.yy + s.zz * s.zz) + s.xy * s.xy;
}

/// eps_q = sqrt(2/3 e:e), e the deviator of the strain tensor (-).
[[nodiscard]] inline double deviatoric_strain(const SymmetricTensor& strain) {
  return std::sqrt(4.0 / 3.0 * second_invariant(strain));
}

}  // namespace slope::solid
