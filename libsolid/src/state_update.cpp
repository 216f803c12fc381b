// Soils whose law has a stiffness and a memory of its own. Their stress has a loop of its own: a branch in the other
// one changes what the compiler contracts there, and with it the last bits of linear elastic soil.

#include <algorithm>

#include "hats.hpp"
#include "slope/solid/material_point_method.hpp"
#include "threads.hpp"

namespace slope::solid {

std::span<double> MaterialPointMethod::internal_of(std::size_t p) {
  return std::span(state_.particles.internal).subspan(p * internal_count_, internal_count_);
}

void MaterialPointMethod::set_internal_variables() {
  Particles& all = state_.particles;
  all.internal.assign(all.size() * internal_count_, 0.0);
  if (internal_count_ == 0) return;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const SymmetricTensor stress{all.sxx[p], all.syy[p], all.szz[p], all.sxy[p]};
    with_state(materials_[all.soil[p]].strength, [&](const auto& law) { law.initial(stress, internal_of(p)); });
  }
}

std::vector<InternalField> MaterialPointMethod::internal_fields() const {
  const Particles& all = state_.particles;
  std::vector<InternalField> fields;
  const auto field_of = [&](const InternalVariable& variable) -> InternalField& {
    const auto known = std::ranges::find(fields, variable.name, &InternalField::name);
    if (known != fields.end()) return *known;
    fields.push_back({variable.name, variable.unit, std::vector<double>(all.size())});
    return fields.back();
  };
  for (std::size_t soil = 0; soil < materials_.size(); ++soil) {
    with_state(materials_[soil].strength, [&](const auto& law) {
      for (std::size_t i = 0; i < law.internal_variables.size(); ++i) {
        InternalField& field = field_of(law.internal_variables[i]);
        for (std::size_t p = 0; p < all.size(); ++p) {
          if (all.soil[p] == soil) field.values[p] = all.internal[p * internal_count_ + i];
        }
      }
    });
  }
  return fields;
}

bool MaterialPointMethod::stiffness_varies() const {
  return std::ranges::any_of(materials_, &Material::has_state);
}

Elastic MaterialPointMethod::stiffness(std::size_t p) const {
  const Particles& all = state_.particles;
  return stiffness(p, {all.sxx[p], all.syy[p], all.szz[p], all.sxy[p]});
}

Elastic MaterialPointMethod::stiffness(std::size_t p, double mean_stress) const {
  return stiffness(p, {-mean_stress, -mean_stress, -mean_stress, 0.0});
}

Elastic MaterialPointMethod::stiffness(std::size_t p, const SymmetricTensor& stress) const {
  const Material& material = materials_[state_.particles.soil[p]];
  Elastic result = material.elastic;
  with_state(material.strength,
             [&](const auto& law) { result = law.stiffness(stress, 1.0 / (1.0 - state_.particles.porosity[p])); });
  return result;
}

// The answer of the laws with state to a strain increment, from a stress that has been turned already. As for the other
// laws the volumetric strain is the projected one, the shear strain the particle's own; what other soil around dilates
// is none of it.
void MaterialPointMethod::update_with_state(double dt, std::span<const double> suction, const StepMode& mode) {
  Particles& all = state_.particles;
  const bool beside_dilation = shares_dilation_ && mode.yields;
  if (beside_dilation) find_hat_divergence(velocity_);
  for_each_index(all.size(), settings_.threads, [&](std::size_t p) {
    const Material& material = materials_[all.soil[p]];
    if (!material.has_state) return;
    const auto [vx_x, vx_y, vy_x, vy_y] = velocity_gradient_[p];
    const double volumetric = dt * (settings_.averages_pressure ? from_hats(p) : vx_x + vy_y);
    const double shared = beside_dilation ? dilation_[p] : 0.0;
    const double half_excess = 0.5 * (volumetric - shared - dt * (vx_x + vy_y));
    const double before = mode.moves ? 1.0 + volumetric : 1.0;  // v was smaller by this
    const StrainStep step{{dt * vx_x + half_excess, dt * vy_y + half_excess, 0.0, 0.5 * dt * (vx_y + vy_x)},
                          suction.empty() ? 0.0 : suction[p],
                          1.0 / ((1.0 - all.porosity[p]) * before),
                          mode.yields};
    SymmetricTensor stress{all.sxx[p], all.syy[p], all.szz[p], all.sxy[p]};
    with_state(material.strength, [&](const auto& law) {
      const double plastic_strain = law.update(step, internal_of(p), stress);
      if (mode.accumulates_strain) all.plastic_strain[p] += plastic_strain;
    });
    all.sxx[p] = stress.xx;
    all.syy[p] = stress.yy;
    all.szz[p] = stress.zz;
    all.sxy[p] = stress.xy;
  });
}

}  // namespace slope::solid
