// Walls by mirror images. A node outside of a wall is the image of one inside: opposite velocity components that the
// wall holds, equal ones that it leaves free. What the particles gave it goes to its image, momentum and force with
// that sign, mass as it is: the soil and its image are one body, whose velocity at a node is an average, which makes no
// energy. Linear shape functions do not reach such nodes.
//
// Where the node on the wall moves with v_w, by friction or because the wall absorbs, images are seen from there: the
// velocity outside is 2 v_w - v of the node inside. With that constraint the momenta of the three nodes give two
// equations for v_w and v, which are solved as they stand, with the mass that couples them: lumping it would make
// energy. At rest such a wall is a fixed one, to the last bit.

#include <algorithm>
#include <cmath>

#include "pair.hpp"
#include "slope/solid/material_point_method.hpp"

namespace slope::solid {

namespace {

using Eigen::Array2d;

constexpr bool moves(Wall wall) {
  return wall == Wall::friction || wall == Wall::absorbing;
}

constexpr double tangential_sign(Wall wall) {
  return wall == Wall::roller ? 1.0 : -1.0;
}

struct Side {
  Wall wall;
  double friction;
  std::size_t number;   // left, right, base
  Eigen::Index normal;  // axis
  double inwards;       // sign of the inner normal along that axis

  [[nodiscard]] Array2d sign() const {
    Array2d sign = Array2d::Constant(tangential_sign(wall));
    sign[normal] = -1.0;
    return sign;
  }
};

// A node outside of a wall.
struct Image {
  std::size_t outside, on, inside;
  std::size_t along;  // number of the node along the wall
  Array2d sign;
  bool moving;  // whether the node on the wall can move
  bool corner;  // whether it is one of a frictional base's in the corner with a frictional side
};

// Calls act(side, image) for each node outside of a wall, so that those in the corners reach the inside in two steps.
// Where two walls meet that can both move, the nodes are those of the base.
template <class Act>
void for_each_image(const Grid& grid, const Act& act) {
  const int nx = grid.columns, ny = grid.rows;
  const Walls& walls = grid.walls;
  const Side left{walls.left, walls.left_friction, 0, 0, 1.0}, right{walls.right, walls.right_friction, 1, 0, -1.0};
  const Side base{walls.base, walls.base_friction, 2, 1, 1.0};
  for (int j = -1; j <= ny + 1; ++j) {
    const auto along = std::size_t(j + 1);
    const bool above_base = j > 0 || !moves(base.wall);
    const auto look = [&](const Side& side, int on, int inwards) {
      if (side.wall == Wall::free) return;
      const bool corner = !above_base && side.wall == Wall::friction && base.wall == Wall::friction;
      act(side, Image{grid.node(on - inwards, j), grid.node(on, j), grid.node(on + inwards, j), along, side.sign(),
                      moves(side.wall) && above_base, corner});
    };
    look(left, 0, 1);
    look(right, nx, -1);
  }
  for (int i = -1; i <= nx + 1 && base.wall != Wall::free; ++i) {
    act(base, Image{grid.node(i, -1), grid.node(i, 0), grid.node(i, 1), std::size_t(i + 1), base.sign(),
                    moves(base.wall), false});
  }
}

}  // namespace

void MaterialPointMethod::find_wall_nodes() {
  for (std::size_t number = 0; number <= base_side; ++number) {
    for_each_image(grid_, [&](const Side& side, const Image& image) {
      if (!image.moving || side.number != number) return;
      WallNode node;
      node.outside = image.outside;
      node.on = image.on;
      node.inside = image.inside;
      node.along = image.along;
      node.normal = side.normal;
      node.inwards = side.inwards;
      node.wall = side.wall;
      node.friction = side.friction;
      node.number = wall_nodes_.size();
      wall_nodes_.push_back(node);
    });
    first_wall_node_[number + 1] = wall_nodes_.size();
  }
  state_.walls.resize(wall_nodes_.size());
  const auto absorbs = [](Wall wall) { return wall == Wall::absorbing; };
  beside_absorbing_wall_.assign(grid_.cell_count(), 0);
  for (int row = 0; row < grid_.rows; ++row) {
    for (int column = 0; column < grid_.columns; ++column) {
      const bool beside = (absorbs(grid_.walls.left) && column < 2) || (absorbs(grid_.walls.base) && row < 2) ||
                          (absorbs(grid_.walls.right) && column >= grid_.columns - 2);
      beside_absorbing_wall_[std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column)] = beside;
    }
  }
  for (WallNode& wall : wall_nodes_) {
    if (wall.normal != 1) continue;
    if (wall.on == grid_.node(0, 0) && grid_.walls.left == Wall::friction) wall.beside = 1.0;
    if (wall.on == grid_.node(grid_.columns, 0) && grid_.walls.right == Wall::friction) wall.beside = -1.0;
  }
}

// Images that cannot move come first: in a corner they leave theirs to the wall that can. Where soil did not press
// against a frictional side just above a frictional base in the step before, what it has beyond the corner goes with
// the corner's own node.
void MaterialPointMethod::fold_walls() {
  for (std::size_t side = 0; side < base_side; ++side) {
    const std::size_t above = first_wall_node_[side];
    corner_off_[side] = above < first_wall_node_[side + 1] && state_.walls[above].normal_force == 0.0;
  }
  for_each_image(grid_, [&](const Side& side, const Image& image) {
    if (image.moving) return;
    const bool off = image.corner && corner_off_[side.number];
    const Array2d sign = off ? Array2d::Ones() : image.sign;
    Node& from = node_[image.outside];
    Node& to = node_[off ? image.on : image.inside];
    to.momentum += sign * from.momentum;
    to.force += sign * from.force;
    to.mass += from.mass;
    from = {Array2d::Zero(), Array2d::Zero(), 0.0};
  });
  for (WallNode& wall : wall_nodes_) {
    Node& from = node_[wall.outside];
    Node& on = node_[wall.on];
    Node& inside = node_[wall.inside];
    on.momentum += 2.0 * from.momentum;
    on.force += 2.0 * from.force;
    inside.momentum -= from.momentum;
    inside.force -= from.force;
    inside.mass += from.mass;
    wall.image_mass = from.mass;
    from = {Array2d::Zero(), Array2d::Zero(), 0.0};
  }
}

// The same for a hat's gradient: of its 5 x 5 nodes, one column or row may lie outside. (A hat on the wall has another
// one there, which its particles do not reach.)
void MaterialPointMethod::fold_walls(Hat& hat) const {
  const auto fold = [&hat](Wall wall, int outside, int inwards, const Array2d& sign) {
    Array2d* from = hat.gradient.data() + outside;
    if (moves(wall)) from[inwards] += 2.0 * *from;
    from[2 * inwards] += sign * *from;
    from->setZero();
  };
  const Walls& walls = grid_.walls;
  if (hat.column <= 1 && walls.left != Wall::free) {
    for (int b = 0; b < 25; b += 5) fold(walls.left, b + 1 - hat.column, 1, {-1.0, tangential_sign(walls.left)});
  }
  const int from_right = grid_.columns - hat.column;
  if (from_right <= 1 && walls.right != Wall::free) {
    for (int b = 0; b < 25; b += 5) fold(walls.right, b + 3 + from_right, -1, {-1.0, tangential_sign(walls.right)});
  }
  if (hat.row <= 1 && walls.base != Wall::free) {
    for (int a = 0; a < 5; ++a) fold(walls.base, 5 * (1 - hat.row) + a, 5, {tangential_sign(walls.base), -1.0});
  }
}

// Nodes on a wall: no impulse moves what it holds.
void MaterialPointMethod::hold_walls() {
  const auto hold = [this](int i, int j, bool x, bool y) {
    if (x) response_[grid_.node(i, j)].x() = 0.0;
    if (y) response_[grid_.node(i, j)].y() = 0.0;
  };
  const auto holds = [this](Wall wall) {
    return wall == Wall::fixed || (wall == Wall::absorbing && !state_.walls_released);
  };
  const auto holds_normal = [&holds](Wall wall) { return wall == Wall::roller || holds(wall); };
  const Walls& walls = grid_.walls;
  for (int j = -1; j <= grid_.rows + 1; ++j) {
    hold(0, j, holds_normal(walls.left), holds(walls.left));
    hold(grid_.columns, j, holds_normal(walls.right), holds(walls.right));
  }
  for (int i = -1; i <= grid_.columns + 1; ++i) hold(i, 0, holds(walls.base), holds_normal(walls.base));
}

// Forces of the walls that can move, and what the motion of their nodes brings to those inside. `response_` is zero
// where a wall holds.
void MaterialPointMethod::move_walls(double dt) {
  for (WallNode& wall : wall_nodes_) {
    Node& node = node_[wall.on];
    const Node& inside = node_[wall.inside];
    // the equation of the node inside, taken out of that of the node on the wall
    wall.share = (response_[wall.inside] > 0.0).select(Array2d::Constant(2.0 * wall.image_mass / inside.mass), 0.0);
    wall.mass = node.mass + wall.image_mass * (4.0 - 2.0 * wall.share);
    node.momentum += wall.share * inside.momentum;
    node.force += wall.share * inside.force;
  }
  resist_by_friction(dt);
  for (WallNode& wall : wall_nodes_) {
    Node& node = node_[wall.on];
    Array2d& response = response_[wall.on];
    if (wall.wall == Wall::absorbing) {
      if (state_.walls_released) {
        WallState& memory = memory_of(wall);
        node.force += pair(memory.reaction) - pair(memory.spring) * pair(memory.displacement);
        response = (response > 0.0).select(1.0 / (wall.mass + dt * pair(memory.dashpot)), 0.0);
      } else {
        pair(memory_of(wall).reaction) = -node.force;
      }
    }
    const Array2d before = node.momentum * response;
    const Array2d after = (node.momentum + dt * node.force) * response;
    Node& inside = node_[wall.inside];
    inside.momentum += 2.0 * wall.image_mass * before;
    inside.force += 2.0 * wall.image_mass / dt * (after - before);
  }
}

// Velocity per impulse of forces on the nodes. What acts on a node next to a wall moves that on the wall too if it can
// move, and back.
void MaterialPointMethod::respond(std::vector<Array2d>& force) const {
  for (const WallNode& wall : wall_nodes_) force[wall.on] += wall.share * force[wall.inside];
  for (std::size_t i = 0; i < force.size(); ++i) force[i] *= response_[i];
  for (auto wall = wall_nodes_.rbegin(); wall != wall_nodes_.rend(); ++wall) {
    force[wall->inside] += wall->share * force[wall->on];
  }
}

void MaterialPointMethod::release_walls(std::span<const double> water_mass) {
  state_.walls_released = true;
  if (stiffness_varies()) find_friction_times();
  const double h = grid_.cell_size;
  for (const WallNode& wall : wall_nodes_) {
    if (wall.wall != Wall::absorbing) continue;
    WallState& memory = memory_of(wall);
    memory.dashpot = memory.spring = {};
    const auto columns = std::size_t(grid_.node_columns());
    const Array2d place(grid_.lower[0] + h * (double(wall.on % columns) - 2.0),
                        grid_.lower[1] + h * (double(wall.on / columns) - 2.0));
    const Eigen::Index along = 1 - wall.normal;
    for (std::size_t p = 0; p < state_.particles.size(); ++p) {
      const Array2d away = Array2d(state_.particles.x[p], state_.particles.y[p]) - place;
      if (std::abs(away[wall.normal]) >= h || std::abs(away[along]) >= h) continue;
      // the length of wall that the particle stands for: its share of the cell at the wall
      const double length = (1.0 - std::abs(away[along]) / h) * state_.particles.volume[p] / h;
      const double mass = state_.particles.solid_mass[p] + (water_mass.empty() ? 0.0 : water_mass[p]);
      const Elastic elastic = stiffness(p);
      Array2d modulus;
      modulus[wall.normal] = elastic.constrained_modulus();
      modulus[along] = elastic.shear_modulus();
      pair(memory.dashpot) += length * (modulus * mass / state_.particles.volume[p]).sqrt();
      pair(memory.spring) += length / grid_.walls.absorbing_depth * modulus;
    }
  }
}

// Gives the nodes outside of the walls the velocity of their images; twice, for those in the corners.
void MaterialPointMethod::unfold_walls() {
  for (int pass = 0; pass < 2; ++pass) {
    for_each_image(grid_, [this](const Side& side, const Image& image) {
      if (image.corner && corner_off_[side.number]) {
        velocity_[image.outside] = velocity_[image.on];
        old_velocity_[image.outside] = old_velocity_[image.on];
        return;
      }
      velocity_[image.outside] = image.sign * velocity_[image.inside];
      old_velocity_[image.outside] = image.sign * old_velocity_[image.inside];
      if (!image.moving) return;
      velocity_[image.outside] += 2.0 * velocity_[image.on];
      old_velocity_[image.outside] += 2.0 * old_velocity_[image.on];
    });
  }
}

}  // namespace slope::solid
