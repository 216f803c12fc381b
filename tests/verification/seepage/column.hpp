#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "particles.hpp"
#include "slope/seepage/pore_flow.hpp"
#include "slope/seepage/rigid_step.hpp"
#include "slope/testing/curve.hpp"

namespace slope::seepage::testing {

/// A column of two particles' width between walls, for problems in one dimension.
struct Column {
  Column(double height, int rows) : spacing(height / rows), particles(lattice(columns, rows, spacing)) {}

  [[nodiscard]] std::vector<std::uint16_t> soil() const { return std::vector<std::uint16_t>(particles.size(), 0); }
  [[nodiscard]] FlowSettings settings() const {
    FlowSettings result;
    result.spacing = spacing;
    result.walls = {.left = 0.0, .right = columns * spacing};
    return result;
  }
  [[nodiscard]] std::uint32_t bottom(std::uint32_t column) const { return column; }
  [[nodiscard]] std::uint32_t top(std::uint32_t column) const {
    return static_cast<std::uint32_t>(particles.size()) - columns + column;
  }
  [[nodiscard]] Boundary held_face(bool at_top) const {
    Boundary boundary;
    boundary.count = 1;
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double rise = at_top ? 0.5 * spacing : -0.5 * spacing;
      boundary.faces.push_back({at_top ? top(column) : bottom(column), 0, 0.0, rise, 0.5 * spacing, spacing});
    }
    return boundary;
  }
  [[nodiscard]] double width() const { return columns * spacing; }
  /// A field of the first particle of each row, against its height.
  [[nodiscard]] slope::testing::Curve profile(std::span<const double> field, double factor) const {
    slope::testing::Curve curve;
    for (std::size_t p = 0; p < particles.size(); p += columns) {
      curve.x.push_back(particles.y[p]);
      curve.y.push_back(factor * field[p]);
    }
    return curve;
  }

  static constexpr int columns = 2;
  double spacing;
  Particles particles;
};

/// Advances to `end` in steps that grow while Newton's method takes them easily and shrink where it does not.
class Stepper {
 public:
  Stepper(double first, double longest) : step_(first), longest_(longest) {}

  /// @return whether it got there.
  bool advance(PoreFlow& flow, const Skeleton& skeleton, const Boundary& boundary, double end,
               double tolerance_pressure = 0.1) {
    while (time_ < end * (1.0 - 1.0e-12)) {
      const double taken = std::min(step_, end - time_);
      const SolveReport report = water_step_.advance(flow, taken, skeleton, boundary, tolerance_pressure);
      if (!report.converged) {
        step_ = 0.5 * taken;
        if (step_ < 1.0e-9) return false;
        continue;
      }
      time_ += taken;
      if (taken == step_) step_ = std::min(longest_, 1.1 * step_);
    }
    return true;
  }

 private:
  double step_, longest_;
  double time_ = 0.0;
  RigidStep water_step_;
};

}  // namespace slope::seepage::testing
