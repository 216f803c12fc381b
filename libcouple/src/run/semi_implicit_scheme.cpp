#include "semi_implicit_scheme.hpp"

#include "skeleton_response.hpp"

namespace slope::couple {

seepage::SolveReport SemiImplicitScheme::step(Mixture& mixture, const Actions& actions, double time_step,
                                              double clock_factor) {
  solid::MaterialPointMethod& soil = mixture.soil;
  seepage::PoreFlow& water = mixture.water;
  const double duration = clock_factor * time_step;  // of the water
  seepage::SolveReport report;
  strain_.assign(soil.particles().size(), 0.0);

  // Predict: the soil's motion with the old pore pressure (Eq. 17), and the volume change that it brings.
  soil.predict(time_step, mixture.pore_state(), actions.loads(), 0.0);

  // Respond: the pressure for which flow, storage and volume change balance (Eqs. 4-7), the soil yielding to it.
  if (mixture.rigid()) {
    report = water_step_.solve(water, duration, mixture.skeleton(), strain_, actions.water, seepage::RigidSkeleton{},
                               pressure_tolerance_);
  } else {
    soil.volumetric_strain(time_step, strain_);
    report = water_step_.solve(water, duration, mixture.skeleton(), strain_, actions.water,
                               SkeletonResponse(soil, time_step), pressure_tolerance_);
  }

  // Correct: the pressure change acts on the soil.
  soil.correct(time_step, water_step_.pore_stress_change());

  // Advance: positions, strain, porosity, effective stress (Eqs. 11-16); then saturation, permeability and the books of
  // the water (Eqs. 8-10).
  soil.advance(time_step, water.suction(), {.restored_losses = 1.0 - 1.0 / clock_factor});
  water_step_.finish(water, mixture.skeleton());
  return report;
}

}  // namespace slope::couple
