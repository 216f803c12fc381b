// Walls by mirror images. A node outside of a wall is the image of one inside: opposite velocity components that the
// wall holds, equal ones that it leaves free. What the particles gave it goes to its image, momentum and force with
// that sign, mass as it is: the soil and its image are one body, whose velocity at a node is an average, which makes no
// energy. Linear shape functions do not reach such nodes.

#include <algorithm>

#include "slope/solid/material_point_method.hpp"

namespace slope::solid {

namespace {

constexpr double tangential_sign(Wall wall) {
  return wall == Wall::fixed ? -1.0 : 1.0;
}

// Calls act(outside, inside, signs) for each node outside of a wall, so that those in the corners reach the inside in
// two steps.
template <class Act>
void for_each_image(const Grid& grid, const Act& act) {
  const int nx = grid.columns, ny = grid.rows;
  const Walls& walls = grid.walls;
  for (int j = -1; j <= ny + 1; ++j) {
    if (walls.left != Wall::free) {
      act(grid.node(-1, j), grid.node(1, j), Eigen::Array2d(-1.0, tangential_sign(walls.left)));
    }
    if (walls.right != Wall::free) {
      act(grid.node(nx + 1, j), grid.node(nx - 1, j), Eigen::Array2d(-1.0, tangential_sign(walls.right)));
    }
  }
  for (int i = -1; i <= nx + 1 && walls.base != Wall::free; ++i) {
    act(grid.node(i, -1), grid.node(i, 1), Eigen::Array2d(tangential_sign(walls.base), -1.0));
  }
}

}  // namespace

void MaterialPointMethod::fold_walls() {
  for_each_image(grid_, [this](std::size_t outside, std::size_t inside, const Eigen::Array2d& sign) {
    Node& from = node_[outside];
    Node& to = node_[inside];
    to.momentum += sign * from.momentum;
    to.force += sign * from.force;
    to.mass += from.mass;
    from = {Eigen::Array2d::Zero(), Eigen::Array2d::Zero(), 0.0};
  });
}

// The same for a cell's gradient: of its 4 x 4 nodes, the first or last column or row may lie outside.
void MaterialPointMethod::fold_walls(std::size_t cell, CellGradient& gradient) const {
  const auto fold = [&gradient](std::size_t outside, std::size_t inside, double sign_x, double sign_y) {
    gradient[inside] += Eigen::Array2d(sign_x, sign_y) * gradient[outside];
    gradient[outside].setZero();
  };
  const std::size_t column = cell % std::size_t(grid_.columns);
  const std::size_t row = cell / std::size_t(grid_.columns);
  const Walls& walls = grid_.walls;
  if (column == 0 && walls.left != Wall::free) {
    for (std::size_t b = 0; b < 16; b += 4) fold(b, b + 2, -1.0, tangential_sign(walls.left));
  }
  if (column + 1 == std::size_t(grid_.columns) && walls.right != Wall::free) {
    for (std::size_t b = 0; b < 16; b += 4) fold(b + 3, b + 1, -1.0, tangential_sign(walls.right));
  }
  if (row == 0 && walls.base != Wall::free) {
    for (std::size_t a = 0; a < 4; ++a) fold(a, a + 8, tangential_sign(walls.base), -1.0);
  }
}

// Nodes on a wall: no impulse moves what it holds.
void MaterialPointMethod::hold_walls() {
  const auto hold = [this](int i, int j, bool x, bool y) {
    if (x) response_[grid_.node(i, j)].x() = 0.0;
    if (y) response_[grid_.node(i, j)].y() = 0.0;
  };
  const Walls& walls = grid_.walls;
  for (int j = -1; j <= grid_.rows + 1; ++j) {
    hold(0, j, walls.left != Wall::free, walls.left == Wall::fixed);
    hold(grid_.columns, j, walls.right != Wall::free, walls.right == Wall::fixed);
  }
  for (int i = -1; i <= grid_.columns + 1; ++i) hold(i, 0, walls.base == Wall::fixed, walls.base != Wall::free);
}

// Gives the nodes outside of the walls the velocity of their images; twice, for those in the corners.
void MaterialPointMethod::unfold_walls() {
  for (int pass = 0; pass < 2; ++pass) {
    for_each_image(grid_, [this](std::size_t outside, std::size_t inside, const Eigen::Array2d& sign) {
      velocity_[outside] = sign * velocity_[inside];
      old_velocity_[outside] = sign * old_velocity_[inside];
    });
  }
}

}  // namespace slope::solid
