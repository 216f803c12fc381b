// Rain on a column of soil that does not move: the pore water alone, with slope::seepage.
// Prints down to what height half of the suction is gone, and fails if the water budget does not close.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <slope/seepage/pore_flow.hpp>
#include <slope/seepage/rigid_step.hpp>
#include <vector>

using namespace slope::seepage;

int main() {
  // A column 0.4 m wide and 5 m high on a lattice of particles; the water table is at its base.
  const double spacing = 0.1;
  const int columns = 4;
  const int rows = 50;
  const Water water;
  std::vector<double> x, y, pressure;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      x.push_back((column + 0.5) * spacing);
      y.push_back((row + 0.5) * spacing);
      pressure.push_back(-water.unit_weight() * y.back());
    }
  }
  const std::vector<double> volume(x.size(), spacing * spacing);
  const std::vector<double> porosity(x.size(), 0.35);
  const std::vector<std::uint16_t> soil_of_particle(x.size(), 0);
  const Skeleton skeleton{x, y, volume, porosity};

  // The paper's soil W2.
  Soil soil;
  soil.retention = VanGenuchten{.alpha = 0.05, .n = 3.0, .range = {}};
  soil.relative_permeability.law = HillelPower{.exponent = 2.0};
  soil.hydraulic_conductivity = 1.0e-5;

  FlowSettings settings;
  settings.spacing = spacing;
  settings.walls = {.left = 0.0, .right = columns * spacing, .base = 0.0};
  PoreFlow flow({soil}, water, soil_of_particle, pressure, skeleton, settings);
  RigidStep water_step;

  // Rain keeps the surface at zero pressure.
  Boundary rain;
  rain.count = 1;
  for (int column = 0; column < columns; ++column) {
    FacePressure face;
    face.particle = static_cast<std::uint32_t>((rows - 1) * columns + column);
    face.rise = face.distance = 0.5 * spacing;
    face.area = spacing;
    rain.faces.push_back(face);
  }

  const double stored_at_start = flow.stored_water();
  const double step = 0.5;
  std::printf("%8s %20s %20s\n", "time (s)", "half dry up to (m)", "infiltrated (mm)");
  double wet_above = rows * spacing;
  for (int n = 1; n <= 120; ++n) {
    if (!water_step.advance(flow, step, skeleton, rain, 1.0e-3).converged) return 1;
    if (n % 24 != 0) continue;
    const auto suction = flow.suction();
    double dry = 0.0;
    for (std::size_t p = 0; p < suction.size(); ++p) {
      if (suction[p] > 0.5 * water.unit_weight() * y[p]) dry = std::fmax(dry, y[p]);
    }
    std::printf("%8.0f %20.2f %20.3f\n", n * step, dry, 1.0e3 * flow.cumulative_inflow()[0] / (columns * spacing));
    if (dry > wet_above) return 1;  // water does not climb back
    wet_above = dry;
  }

  const double infiltrated = flow.cumulative_inflow()[0];
  const double stored = flow.stored_water() - stored_at_start;
  std::printf("infiltrated %.6g m2, stored %.6g m2\n", infiltrated, stored);
  const bool wetted = wet_above < rows * spacing - 0.5;
  const bool closed = infiltrated > 0.0 && std::abs(infiltrated - stored) < 1.0e-4 * infiltrated;
  return wetted && closed ? 0 : 1;
}
