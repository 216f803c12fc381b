// Where soils meet. The traction on the face between them is the same from both sides, so near it no soil bears more
// along the face than the other does. The grid cannot let one soil slide along another without shearing both over a
// cell or two: without that bound the stronger one would hold the weaker.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "slope/solid/material_point_method.hpp"
#include "threads.hpp"

namespace slope::solid {

namespace {

// What a soil bears along a plane on which it slides (Pa). A law that is not known by that sets no bound.
struct BorneAlongSlip {
  double suction, plastic_strain;
  double normal_stress;  // effective (Pa)

  double operator()(const NoYield& /*none*/) const { return std::numeric_limits<double>::infinity(); }
  template <class Law>
  double operator()(const Law& law) const {
    if constexpr (LawWithState<Law>) {
      return std::numeric_limits<double>::infinity();
    } else {
      return std::max(law.at(suction, plastic_strain).shear_along_slip(normal_stress), 0.0);
    }
  }
};

}  // namespace

void MaterialPointMethod::bound_traction_between_soils(std::span<const double> suction) {
  Particles& all = state_.particles;
  const std::span<const std::size_t> beside = faces_.particles_beside();
  for_each_index(beside.size(), settings_.threads, [&](std::size_t k) {
    const std::size_t p = beside[k];
    faces_.for_each_face_of(p, [&](const SoilFaces::Beside& face) {
      const double nx = face.normal[0], ny = face.normal[1];
      const double normal = all.sxx[p] * nx * nx + all.syy[p] * ny * ny + 2.0 * all.sxy[p] * nx * ny;
      const double shear = (all.syy[p] - all.sxx[p]) * nx * ny + all.sxy[p] * (nx * nx - ny * ny);
      const auto borne_by = [&](std::size_t q) {
        const BorneAlongSlip borne{suction.empty() ? 0.0 : suction[q], all.plastic_strain[q], normal};
        return std::visit(borne, materials_[all.soil[q]].strength);
      };
      const double most = borne_by(face.other);
      if (std::abs(shear) <= most || borne_by(p) <= most) return;
      // a layer is a weak seam only between stronger soils
      if (!face.close && borne_by(face.beyond) <= most) return;
      // by so much the shear along t = (-ny, nx) grows from the face to the particle, at rest, by the weight between
      const double weight = -settings_.gravity * nx * mass_[p] / all.volume[p] * face.gap;
      const double lost = shear - std::clamp(shear, -most + std::min(weight, 0.0), most + std::max(weight, 0.0));
      // only the shear along the face goes; the stresses normal to it and along it stay
      all.sxx[p] += 2.0 * nx * ny * lost;
      all.syy[p] -= 2.0 * nx * ny * lost;
      all.sxy[p] -= (nx * nx - ny * ny) * lost;
    });
  });
}

}  // namespace slope::solid
