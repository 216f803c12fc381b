#include "explicit_scheme.hpp"

#include <algorithm>
#include <cmath>

namespace slope::couple {

double ExplicitScheme::stable_step(const Mixture& mixture, double courant_number) {
  const solid::Particles& p = mixture.soil.particles();
  const std::vector<double> water_mass = mixture.water_mass();
  double fastest = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double modulus =
        mixture.soil.stiffness(i).constrained_modulus() + mixture.water.water().bulk_modulus / p.porosity[i];
    fastest = std::max(fastest, modulus * p.volume[i] / (p.solid_mass[i] + water_mass[i]));
  }
  const double wave = mixture.soil.grid().cell_size / std::sqrt(fastest);
  return courant_number * std::min(wave, seepage::ExplicitStep::stable_step(mixture.water, mixture.skeleton()));
}

double ExplicitScheme::largest_clock_factor(const Mixture& mixture, double courant_number) {
  return courant_number * seepage::ExplicitStep::stable_step(mixture.water, mixture.skeleton()) /
         stable_step(mixture, courant_number);
}

seepage::SolveReport ExplicitScheme::step(Mixture& mixture, const Actions& actions, double time_step,
                                          double clock_factor) {
  solid::MaterialPointMethod& soil = mixture.soil;
  seepage::PoreFlow& water = mixture.water;

  // 1 to 5: the soil with the total stress of the step before
  soil.predict(time_step, mixture.pore_state(), actions.loads(), 0.0);
  soil.advance(time_step, water.suction(), {.restored_losses = 1.0 - 1.0 / clock_factor});

  // 6 to 9: the water with the soil's new positions and velocities
  const std::size_t n = soil.particles().size();
  vx_.assign(n, 0.0);
  vy_.assign(n, 0.0);
  if (!mixture.rigid()) {
    for (std::size_t p = 0; p < n; ++p) {
      vx_[p] = soil.particles().vx[p] / clock_factor;
      vy_[p] = soil.particles().vy[p] / clock_factor;
    }
  }
  water_step_.advance(water, clock_factor * time_step, mixture.skeleton(), vx_, vy_, actions.water);
  return {};
}

}  // namespace slope::couple
