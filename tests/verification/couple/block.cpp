#include "block.hpp"

namespace slope::testing {

Block::Block(double width, double height, double cell_size, double margin) {
  input.domain.upper = {width + margin, height + margin};
  input.domain.cell_size = cell_size;
  input.walls.right = couple::Wall::free;
  input.walls.base = couple::Wall::roller;
  couple::Soil soil;
  soil.solid.elastic = {10.0e6, 0.33};
  soil.solid.grain_density = 2700.0;
  soil.porosity = 0.35;
  soil.seepage.retention = seepage::VanGenuchten{.alpha = 0.05, .n = 3.0, .range = {}};
  soil.seepage.relative_permeability.law = seepage::HillelPower{.exponent = 2.0};
  soil.seepage.hydraulic_conductivity = 1.0e-5;
  input.soils = {soil};
  input.regions = {{0, {{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}}}};
  input.mixture_density = couple::MixtureDensity::saturated;
}

couple::InitialParticles Block::particles() const {
  return couple::fill_regions(input.domain, input.regions);
}

}  // namespace slope::testing
