// Contact of the soil with frictional walls, node by node: unilateral, and Coulomb's friction.
//
// Of the normal force and the velocity away from the wall one is zero and none is negative, in every step. Friction
// that followed the normal force of each node at once would let sliding and vibration across the wall drive each other:
// an elastic body on a rigid base is unstable so at any coefficient, by modes that are nearly equal in frequency and by
// short waves without bound (Martins et al. 1995; Cochard and Rice 2000). A finite-element block of 2 x 1 m on a base
// of 0.5 grows by 15 per second at 14.5 Hz. Friction on a body as a whole does not do that, so friction follows the
// normal force of a stretch of wall soon, and its distribution along the stretch late. Its impulse is that of the
// normal force times the coefficient, whatever vibrates.

#include <algorithm>
#include <cmath>
#include <limits>

#include "slope/solid/material_point_method.hpp"

namespace slope::solid {

namespace {

constexpr double untouched = std::numeric_limits<double>::infinity();
// Times in which friction follows the normal force, in those in which a wave crosses the soil: fluctuations that the
// linear stability of blocks of 1 x 1, 2 x 1 and 8 x 0.5 m on bases of 0.2 to 0.8 needs to be slow.
constexpr double whole_crossings = 2.0;
constexpr double distribution_crossings = 10.0;
// Share of a particle's height within which its face touches the wall.
constexpr double skin = 0.01;

}  // namespace

void MaterialPointMethod::find_friction_times() {
  const auto extent = [](const std::vector<double>& place) {
    const auto [least, largest] = std::ranges::minmax(place);
    return largest - least;
  };
  if (state_.particles.size() == 0) return;
  const double crossing =
      std::min(extent(state_.particles.x), extent(state_.particles.y)) / grid_.cell_size * stable_step(1.0, {});
  state_.whole_time = whole_crossings * crossing;
  state_.distribution_time = distribution_crossings * crossing;
}

// What the nodes of the frictional walls see of the soil: how far it is, and the force of its pore water on the wall.
//
// The distance is the least one of the faces of the particles that reach a node. The half height of a particle on the
// wall has grown by its strain across the wall, whatever else it did. The water's pressure at the wall is that of the
// straight line through the means of the cells, whose noise the soil does not feel either; the length of wall that it
// acts on, that of Gauss's theorem.
void MaterialPointMethod::look_at_soil(std::span<const double> pressure) {
  for (WallNode& wall : wall_nodes_) wall.gap = untouched;
  near_wall_.assign(wall_nodes_.size(), {});
  for (std::size_t side = 0; side + 1 < first_wall_node_.size(); ++side) {
    const std::size_t first = first_wall_node_[side];
    if (first != first_wall_node_[side + 1] && wall_nodes_[first].wall == Wall::friction) look_at_soil(first, pressure);
  }
  for (std::size_t i = 0; i < wall_nodes_.size(); ++i) {
    const NearWall& near = near_wall_[i];
    wall_nodes_[i].water_force = 0.0;
    if (pressure.empty() || near.volume == 0.0) continue;
    const double distance = near.distance / near.volume;
    const double spread = near.square / near.volume - distance * distance;
    const double slope = spread > 1.0e-6 * grid_.cell_size * grid_.cell_size
                             ? (near.product - near.pressure * distance) / (near.volume * spread)
                             : 0.0;
    wall_nodes_[i].water_force = (near.pressure / near.volume - slope * distance) * near.length;
  }
}

void MaterialPointMethod::look_at_soil(std::size_t first_node, std::span<const double> pressure) {
  constexpr double reach = 1.5;            // cells, of a particle
  constexpr double largest_stretch = 2.0;  // of one that has tumbled, and whose strain means nothing
  const WallNode& first = wall_nodes_[first_node];
  const auto columns = std::size_t(grid_.node_columns());
  const bool base = first.normal == 1;
  const std::vector<double>& place = base ? state_.particles.y : state_.particles.x;
  const std::vector<double>& across = base ? state_.particles.eyy : state_.particles.exx;
  const std::vector<double>& along = base ? state_.particles.exx : state_.particles.eyy;
  const auto row_of = [&](std::size_t node) { return base ? node / columns : node % columns; };
  const auto number_of = [&](std::size_t node) { return base ? node % columns : node / columns; };
  const std::size_t on = row_of(first.on), outside = row_of(first.outside), before = number_of(grid_.node(-1, -1));
  const double at =
      first.inwards > 0.0 ? grid_.lower[std::size_t(first.normal)] : grid_.lower[0] + grid_.cell_size * grid_.columns;
  if (!pressure.empty()) {
    cell_means_.assign(grid_.cell_count(), {});
    for (std::size_t p = 0; p < state_.particles.size(); ++p) {
      const double volume = state_.particles.volume[p];
      CellMeans& cell = cell_means_[grid_cell_of_[p]];
      cell.volume += volume;
      cell.distance += volume * first.inwards * (place[p] - at);
      cell.pressure += volume * pressure[p];
    }
  }
  for (std::size_t p = 0; p < state_.particles.size(); ++p) {
    const double distance = first.inwards * (place[p] - at);
    if (distance > reach * grid_.cell_size) continue;
    const ParticleWeights& w = weights_[p];
    const double volume = state_.particles.volume[p];
    const double stretch = std::clamp(std::exp(0.5 * (across[p] - along[p])), 1.0 / largest_stretch, largest_stretch);
    const double gap = std::max(0.0, distance - (0.5 + skin) * std::sqrt(volume) * stretch);
    const double* value = base ? w.nx : w.ny;
    const double* gradient = base ? w.gy : w.gx;
    double slope = 0.0;
    for (std::size_t b = 0; b < 3; ++b) {
      const std::size_t row = row_of(w.node) + b;
      slope += row == on ? gradient[b] : row == outside ? 2.0 * gradient[b] : 0.0;
    }
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t number = number_of(w.node) + a - before;
      if (number < first.along) continue;
      const std::size_t node = first_node + number - first.along;
      wall_nodes_[node].gap = std::min(wall_nodes_[node].gap, gap);
      if (pressure.empty()) continue;
      const double share = value[a] * volume;
      const CellMeans& cell = cell_means_[grid_cell_of_[p]];
      const double away = cell.distance / cell.volume, mean = cell.pressure / cell.volume;
      NearWall& near = near_wall_[node];
      near.volume += share;
      near.distance += share * away;
      near.square += share * away * away;
      near.pressure += share * mean;
      near.product += share * away * mean;
      near.length -= first.inwards * share * slope;
    }
  }
}

// The normal force of a wall on a node.
void MaterialPointMethod::press(const WallNode& wall, double dt) {
  Node& node = node_[wall.on];
  double& response = response_[wall.on][wall.normal];
  double& normal_force = memory_of(wall).normal_force;
  normal_force = 0.0;
  if (response == 0.0) return;
  const double mass = wall.mass[wall.normal];
  response = 1.0 / mass;
  if (wall.gap == untouched) return;
  const double leaves = wall.inwards * (node.momentum[wall.normal] / dt + node.force[wall.normal]);
  normal_force = std::max(0.0, -leaves - mass * wall.gap / (dt * dt));
  node.force[wall.normal] += wall.inwards * normal_force;
  if (normal_force > 0.0 && wall.gap == 0.0) response = 0.0;
}

// The friction of a wall on a node stops it, as far as its limit allows.
void MaterialPointMethod::rub(const WallNode& wall, double limit, double dt) {
  const Eigen::Index along = 1 - wall.normal;
  Node& node = node_[wall.on];
  double& response = response_[wall.on][along];
  double& friction_force = memory_of(wall).friction_force;
  friction_force = 0.0;
  if (response == 0.0) return;
  const double stops = -(node.momentum[along] / dt + node.force[along]);
  const bool slides = std::abs(stops) > limit;
  friction_force = slides ? std::copysign(limit, stops) : stops;
  node.force[along] += friction_force;
  response = slides ? 1.0 / wall.mass[along] : 0.0;
  // in a corner, the wall beside holds it too
  if ((node.momentum[along] + dt * node.force[along]) * wall.beside < 0.0) response = 0.0;
}

// Forces of the frictional walls on their nodes, one stretch with soil after the other.
void MaterialPointMethod::resist_by_friction(double dt) {
  const auto has_soil = [this](const WallNode& wall) { return node_[wall.on].mass > 0.0; };
  for (std::size_t side = 0; side < first_wall_node_.size() - 1; ++side) {
    const std::span nodes =
        std::span(wall_nodes_).subspan(first_wall_node_[side], first_wall_node_[side + 1] - first_wall_node_[side]);
    if (nodes.empty() || nodes.front().wall != Wall::friction) continue;
    // what friction has still to do for a node that the soil has just left is done beside it
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (has_soil(nodes[i])) continue;
      WallState& left = memory_of(nodes[i]);
      const bool before = i > 0 && has_soil(nodes[i - 1]), after = i + 1 < nodes.size() && has_soil(nodes[i + 1]);
      const double part = before && after ? 0.5 : 1.0;
      if (before) memory_of(nodes[i - 1]).felt += part * left.felt;
      if (after) memory_of(nodes[i + 1]).felt += part * left.felt;
      left.normal_force = left.friction_force = left.felt = left.usual = 0.0;
    }
    for (std::size_t first = 0; first < nodes.size(); ++first) {
      std::size_t end = first;
      while (end < nodes.size() && has_soil(nodes[end])) ++end;
      if (end > first) resist_by_friction(nodes.subspan(first, end - first), dt);
      first = end;
    }
  }
}

void MaterialPointMethod::resist_by_friction(std::span<WallNode> stretch, double dt) {
  const double whole_share = dt / (dt + state_.whole_time), distribution_share = dt / (dt + state_.distribution_time);
  const bool touches = std::ranges::any_of(stretch, [](const WallNode& wall) { return wall.gap == 0.0; });
  double felt = 0.0, usual = 0.0;
  for (WallNode& wall : stretch) {
    press(wall, dt);
    WallState& memory = memory_of(wall);
    const double effective = memory.normal_force > 0.0 ? std::max(0.0, memory.normal_force - wall.water_force) : 0.0;
    // soil off the wall owes it the rest of the friction of its last impact
    memory.felt += whole_share * (effective - (touches ? memory.felt : 0.0));
    memory.usual += (memory.usual == 0.0 ? 1.0 : distribution_share) * (effective - memory.usual);
    felt += memory.felt;
    if (wall.gap == 0.0) usual += memory.usual;
  }
  for (WallNode& wall : stretch) {
    rub(wall, wall.gap == 0.0 && usual > 0.0 ? wall.friction * felt * memory_of(wall).usual / usual : 0.0, dt);
  }
}

std::vector<WallReaction> MaterialPointMethod::wall_reactions() const {
  std::vector<WallReaction> reactions;
  const auto columns = std::size_t(grid_.node_columns());
  const std::size_t corner = grid_.node(0, 0);
  const auto place = [this](double lower, std::size_t node, std::size_t first) {
    return lower + grid_.cell_size * (static_cast<double>(node) - static_cast<double>(first));
  };
  for (const WallNode& wall : wall_nodes_) {
    if (wall.wall != Wall::friction) continue;
    reactions.push_back({.x = place(grid_.lower[0], wall.on % columns, corner % columns),
                         .y = place(grid_.lower[1], wall.on / columns, corner / columns),
                         .normal = memory_of(wall).normal_force,
                         .friction = memory_of(wall).friction_force});
  }
  return reactions;
}

}  // namespace slope::solid
