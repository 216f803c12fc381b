#include "synthetic_slope.hpp"

#include <algorithm>
#include <cmath>

#include "particle_file.hpp"
#include "scratch_folder.hpp"

namespace slope::tools::test {
namespace {

constexpr double gamma_w = 9810.0;  // N/m3

double ground_height(double x) {
  if (x <= 10.0) {
    return 5.0;
  }
  return x >= 22.6 ? 12.0 : 5.0 + (x - 10.0) * 7.0 / 12.6;
}

void add_particle(couple::ParticleTable& table, couple::Point position, double volume) {
  table.position.push_back(position);
  table.volume.push_back(volume);
  table.displacement.push_back({0.0, 0.0});
  table.velocity.push_back({0.0, 0.0});
  table.darcy_velocity.push_back({0.0, 0.0});
  table.stress_effective.push_back({});
  table.strain.push_back({});
  table.deviatoric_strain.push_back(0.0);
  table.plastic_strain.push_back(0.0);
  table.saturation.push_back(1.0);
  table.porosity.push_back(0.35);
  table.soil.push_back(0);
  for (auto& field : table.internal) field.values.push_back(1.0e4 * (1.0 + position[0]));
}

void set_suction(couple::ParticleTable& table, double suction) {
  table.suction.push_back(suction);
  table.pore_pressure.push_back(-suction);
}

}  // namespace

couple::ParticleTable synthetic_slope(double time, double slide, double wet_depth) {
  constexpr double spacing = 0.25;
  constexpr couple::Point centre{9.5, 17.5};
  constexpr double radius = 13.0;
  couple::ParticleTable table;
  table.time = time;
  table.internal = {
      {"preconsolidation_pressure", "Pa", {}}, {"mechanism_speed", "-", {}}, {"mechanism_shear_strain", "-", {}}};
  for (int j = 0; j < 48; ++j) {
    for (int i = 0; i < 144; ++i) {
      const double x = (i + 0.5) * spacing;
      const double y = (j + 0.5) * spacing;
      const double depth = ground_height(x) - y;
      if (depth <= 0.0) {
        continue;
      }
      const double from_centre = std::hypot(x - centre[0], y - centre[1]);
      const double inside = 0.5 * (1.0 - std::tanh((from_centre - radius) / 0.4));
      const couple::Point along{-(centre[1] - y) / from_centre, -(x - centre[0]) / from_centre};
      add_particle(table, {x + slide * inside * along[0], y + slide * inside * along[1]}, spacing * spacing);
      table.displacement.back() = {slide * inside * along[0], slide * inside * along[1]};
      table.deviatoric_strain.back() = slide * std::exp(-std::pow((from_centre - radius) / 0.4, 2));
      const double dry = gamma_w * (y - 3.0);
      const double front = wet_depth > 0.0 ? 1.0 / (1.0 + std::exp((depth - wet_depth) / (0.2 * wet_depth))) : 0.0;
      set_suction(table, dry > 0.0 ? dry * (1.0 - front) - 0.6 * gamma_w * depth * front : dry);
    }
  }
  return table;
}

couple::ParticleTable synthetic_column(double time, double top_head) {
  constexpr double spacing = 0.02;
  couple::ParticleTable table;
  table.time = time;
  for (int j = 0; j < 50; ++j) {
    for (int i = 0; i < 4; ++i) {
      const double y = (j + 0.5) * spacing;
      add_particle(table, {(i + 0.5) * spacing, y}, spacing * spacing);
      set_suction(table, gamma_w * top_head * std::pow(y, 1.5));
    }
  }
  return table;
}

vtkSmartPointer<vtkPolyData> as_polydata(const couple::ParticleTable& table) {
  const ScratchFolder folder;
  return read_particles(ParticleFileSeries(folder.path()).write(table));
}

}  // namespace slope::tools::test
