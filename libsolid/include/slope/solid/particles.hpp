#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slope::solid {

/// State of the soil skeleton: a structure of arrays, one entry per particle, SI units, per metre of thickness.
/// Stress and strain are tensors, tension positive.
struct Particles {
  std::vector<double> x, y;                ///< position (m)
  std::vector<double> ux, uy;              ///< displacement since the start (m)
  std::vector<double> vx, vy;              ///< velocity (m/s)
  std::vector<double> cxx, cxy, cyx, cyy;  ///< affine velocity field dv_x/dx, dv_x/dy, dv_y/dx, dv_y/dy of APIC (1/s)
  /// What a transfer to the grid and back takes from velocity (m/s) and affine field (1/s), averaged over the latest
  /// steps that gave it back; see StepMode::restored_losses.
  std::vector<double> lost_vx, lost_vy, lost_cxx, lost_cxy, lost_cyx, lost_cyy;
  std::vector<double> sxx, syy, szz, sxy;  ///< effective stress sigma' (Pa)
  std::vector<double> exx, eyy, exy;       ///< accumulated strain (-); e_zz = 0
  std::vector<double> plastic_strain;      ///< accumulated deviatoric plastic strain, sum of sqrt(2/3 de:de) (-), >= 0
  /// Internal variables of the strength laws, particle by particle, each with as many as the law that has most; empty
  /// if none has any.
  std::vector<double> internal;
  std::vector<double> volume;       ///< V (m2)
  std::vector<double> solid_mass;   ///< (1 - n) rho_s V, constant (kg/m)
  std::vector<double> porosity;     ///< n (-)
  std::vector<std::uint16_t> soil;  ///< index of the soil

  [[nodiscard]] std::size_t size() const { return x.size(); }

  /// Calls visit(name, array) for each array of a Particles, const or not. All but `internal` have one entry a
  /// particle.
  template <class Self, class Visit>
  static void for_each_field(Self& p, const Visit& visit) {
    visit("x", p.x), visit("y", p.y);
    visit("ux", p.ux), visit("uy", p.uy);
    visit("vx", p.vx), visit("vy", p.vy);
    visit("cxx", p.cxx), visit("cxy", p.cxy), visit("cyx", p.cyx), visit("cyy", p.cyy);
    visit("lost_vx", p.lost_vx), visit("lost_vy", p.lost_vy);
    visit("lost_cxx", p.lost_cxx), visit("lost_cxy", p.lost_cxy);
    visit("lost_cyx", p.lost_cyx), visit("lost_cyy", p.lost_cyy);
    visit("sxx", p.sxx), visit("syy", p.syy), visit("szz", p.szz), visit("sxy", p.sxy);
    visit("exx", p.exx), visit("eyy", p.eyy), visit("exy", p.exy);
    visit("plastic_strain", p.plastic_strain);
    visit("internal", p.internal);
    visit("volume", p.volume);
    visit("solid_mass", p.solid_mass);
    visit("porosity", p.porosity);
    visit("soil", p.soil);
  }
  /// Calls visit(array) for each array that is proportional to the velocity.
  template <class Visit>
  void for_each_velocity(const Visit& visit) {
    for (auto* field : {&vx, &vy, &cxx, &cxy, &cyx, &cyy}) visit(*field);
    for_each_loss(visit);
  }
  /// Calls visit(array) for each array of losses.
  template <class Visit>
  void for_each_loss(const Visit& visit) {
    for (auto* field : {&lost_vx, &lost_vy, &lost_cxx, &lost_cxy, &lost_cyx, &lost_cyy}) visit(*field);
  }
  bool operator==(const Particles&) const = default;

  /// Particles at rest and free of stress.
  /// @param grain_density  rho_s of each soil (kg/m3), indexed by `soil_index`
  static Particles at(std::span<const double> x, std::span<const double> y, std::span<const double> volume,
                      std::span<const double> porosity, std::span<const std::uint16_t> soil_index,
                      std::span<const double> grain_density);
};

}  // namespace slope::solid
