// Strain, volume, porosity and effective stress of the particles.

#include "hats.hpp"
#include "slope/solid/material_point_method.hpp"
#include "threads.hpp"

namespace slope::solid {

namespace {

// Brings a stress to the yield surface of whichever law it is, by a flow that keeps the volume where its change is in
// the stress already; whether the soil yields.
template <bool keeps_volume>
struct Yielding {
  double suction, plastic_strain;
  const Elastic& elastic;
  SymmetricTensor& stress;

  bool operator()(const NoYield& /*none*/) const { return false; }
  template <class Law>
  bool operator()(const Law& law) const {
    if constexpr (LawWithState<Law>) {
      return false;  // it comes later, and finds the stress turned by the spin
    } else if constexpr (keeps_volume) {
      return return_to_yield_surface(law.at(suction, plastic_strain).isochoric(), elastic, stress) != Return::elastic;
    } else {
      return return_to_yield_surface(law.at(suction, plastic_strain), elastic, stress) != Return::elastic;
    }
  }
};

// What the plastic flow of whichever law it is does to the volume at a trial stress (-).
struct Dilating {
  double suction, plastic_strain;
  const Elastic& elastic;
  SymmetricTensor trial;

  double operator()(const NoYield& /*none*/) const { return 0.0; }
  template <class Law>
  double operator()(const Law& law) const {
    if constexpr (LawWithState<Law>) {
      return 0.0;  // it changes its volume as it hardens
    } else {
      SymmetricTensor stress = trial;
      return_to_yield_surface(law.at(suction, plastic_strain), elastic, stress);
      return (trace(trial) - trace(stress)) / (3.0 * elastic.bulk_modulus());
    }
  }
};

// sqrt(2/3 de:de) of the plastic strain increment that took the deviator from the trial stress to the stress.
double plastic_increment(const SymmetricTensor& trial, const SymmetricTensor& stress, double shear) {
  const SymmetricTensor lost{trial.xx - stress.xx, trial.yy - stress.yy, trial.zz - stress.zz, trial.xy - stress.xy};
  return deviatoric_strain(lost) / (2.0 * shear);
}

}  // namespace

MaterialPointMethod::Material::Material(const Soil& soil, double cell_size)
    : elastic(soil.elastic),
      shear(soil.elastic.shear_modulus()),
      bulk(soil.elastic.bulk_modulus()),
      lame(soil.elastic.bulk_modulus() - 2.0 / 3.0 * soil.elastic.shear_modulus()),
      dilates(solid::dilates(soil.strength)),
      strength(make_strength_law(soil, cell_size)) {
  if (has_state) shear = bulk = lame = 0.0;
}

void MaterialPointMethod::update_stress(double dt, std::span<const double> suction, const StepMode& mode) {
  if (settings_.averages_pressure) find_hat_divergence(velocity_);
  if (shares_dilation_ && mode.yields) {
    strain_particles<true>(dt, suction, mode);
    yield_with_shared_dilation(suction, mode);
  } else {
    strain_particles<false>(dt, suction, mode);
  }
  if (stiffness_varies()) update_with_state(dt, suction, mode);
  if (mode.yields) bound_traction_between_soils(suction);
}

template <bool shares_dilation>
void MaterialPointMethod::strain_particles(double dt, std::span<const double> suction, const StepMode& mode) {
  for_each_index(state_.particles.size(), settings_.threads, [&](std::size_t p) {
    const Material& material = materials_[state_.particles.soil[p]];
    const auto [vx_x, vx_y, vy_x, vy_y] = velocity_gradient_[p];
    const double dxx = dt * vx_x;
    const double dyy = dt * vy_y;
    const double dxy = 0.5 * dt * (vx_y + vy_x);
    const double spin = 0.5 * dt * (vx_y - vy_x);
    if (mode.accumulates_strain) {
      state_.particles.exx[p] += dxx;
      state_.particles.eyy[p] += dyy;
      state_.particles.exy[p] += dxy;
    }
    const double strain = settings_.averages_pressure ? dt * from_hats(p) : dxx + dyy;
    if (mode.moves) {
      state_.particles.volume[p] *= 1.0 + strain;
      state_.particles.porosity[p] = 1.0 - (1.0 - state_.particles.porosity[p]) / (1.0 + strain);
    }
    // the volumetric strain that the stress sees is the projected one, the shear strain is the particle's own
    const double half_excess = 0.5 * (strain - dxx - dyy);
    const double stretch_x = 2.0 * material.shear * (dxx + half_excess);
    const double stretch_y = 2.0 * material.shear * (dyy + half_excess);
    // Jaumann rate
    const double sxx = state_.particles.sxx[p], syy = state_.particles.syy[p], sxy = state_.particles.sxy[p];
    const double volumetric = material.lame * strain;
    SymmetricTensor stress{sxx + 2.0 * spin * sxy + volumetric + stretch_x,
                           syy - 2.0 * spin * sxy + volumetric + stretch_y, state_.particles.szz[p] + volumetric,
                           sxy + spin * (syy - sxx) + 2.0 * material.shear * dxy};
    if constexpr (shares_dilation) {
      trial_stress_[p] = stress;
      dilation_[p] = 0.0;
      if (material.dilates) {
        const Dilating dilating{suction.empty() ? 0.0 : suction[p], state_.particles.plastic_strain[p],
                                material.elastic, stress};
        dilation_[p] = std::visit(dilating, material.strength);
      }
      return;
    }
    if (mode.yields) {
      const SymmetricTensor trial = stress;
      const Yielding<false> yielding{suction.empty() ? 0.0 : suction[p], state_.particles.plastic_strain[p],
                                     material.elastic, stress};
      if (std::visit(yielding, material.strength) && mode.accumulates_strain) {
        state_.particles.plastic_strain[p] += plastic_increment(trial, stress, material.shear);
      }
    }
    state_.particles.sxx[p] = stress.xx;
    state_.particles.syy[p] = stress.yy;
    state_.particles.szz[p] = stress.zz;
    state_.particles.sxy[p] = stress.xy;
  });
}

// Each particle meets the volume change of the plastic flow around it in its mean stress, and then yields by shear.
void MaterialPointMethod::yield_with_shared_dilation(std::span<const double> suction, const StepMode& mode) {
  sum_over_hats(dilation_);
  for (const Hat& hat : hats_) {
    if (hat.volume > 0.0) hat_value_[hat.node] /= hat.volume;
  }
  for_each_index(state_.particles.size(), settings_.threads, [&](std::size_t p) {
    const Material& material = materials_[state_.particles.soil[p]];
    dilation_[p] = from_hats(p);
    const double lost = material.bulk * dilation_[p];
    const SymmetricTensor& tried = trial_stress_[p];
    const SymmetricTensor trial{tried.xx - lost, tried.yy - lost, tried.zz - lost, tried.xy};
    SymmetricTensor stress = trial;
    const Yielding<true> yielding{suction.empty() ? 0.0 : suction[p], state_.particles.plastic_strain[p],
                                  material.elastic, stress};
    if (std::visit(yielding, material.strength) && mode.accumulates_strain) {
      state_.particles.plastic_strain[p] += plastic_increment(trial, stress, material.shear);
    }
    state_.particles.sxx[p] = stress.xx;
    state_.particles.syy[p] = stress.yy;
    state_.particles.szz[p] = stress.zz;
    state_.particles.sxy[p] = stress.xy;
  });
}

}  // namespace slope::solid
