#include "slope/solid/particles.hpp"

namespace slope::solid {

Particles Particles::at(std::span<const double> x, std::span<const double> y, std::span<const double> volume,
                        std::span<const double> porosity, std::span<const std::uint16_t> soil_index,
                        std::span<const double> grain_density) {
  const std::size_t n = x.size();
  Particles p;
  for_each_field(p, [n](const char* /*name*/, auto& field) { field.resize(n); });
  p.internal.clear();  // whether there are any, the laws tell
  p.x.assign(x.begin(), x.end());
  p.y.assign(y.begin(), y.end());
  p.volume.assign(volume.begin(), volume.end());
  p.porosity.assign(porosity.begin(), porosity.end());
  p.soil.assign(soil_index.begin(), soil_index.end());
  for (std::size_t i = 0; i < n; ++i) {
    p.solid_mass[i] = (1.0 - porosity[i]) * grain_density[soil_index[i]] * volume[i];
  }
  return p;
}

}  // namespace slope::solid
