#include "slope/seepage/head_operator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "particles.hpp"
#include "slope/seepage/conjugate_gradients.hpp"

namespace slope::seepage {
namespace {

using testing::lattice;
using testing::Particles;

constexpr double smoothing_ratio = 1.2;

// Flow through the line x = position under the head h = x, for a conductivity of 1.
double conduction(const Particles& particles, const HeadOperator& op, double position) {
  double flow = 0.0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    if (particles.x[p] > position) continue;
    const auto row = op.neighbours().of(p);
    for (std::size_t s = 0; s < row.size(); ++s) {
      const double step = particles.x[row[s]] - particles.x[p];
      if (particles.x[row[s]] > position) flow += op.conductance()[op.neighbours().start[p] + s] * step;
    }
  }
  return flow;
}

TEST(HeadOperator, IsSymmetricWithPositiveConductances) {
  const auto block = lattice(9, 7, 0.5, 0.2);
  HeadOperator op(0.5, smoothing_ratio, {.left = 0.0, .base = 0.0}, 1);
  op.update(block.skeleton());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> conductivity(1.0e-9, 1.0e-5);
  std::vector<double> k(block.size());
  for (double& v : k) v = conductivity(random);
  op.set_conductivity(k);
  const Neighbours& near = op.neighbours();
  for (std::size_t p = 0; p < block.size(); ++p) {
    double sum = 0.0;
    for (std::size_t s = near.start[p]; s < near.start[p + 1]; ++s) {
      const std::size_t q = near.index[s];
      const auto back = std::lower_bound(near.of(q).begin(), near.of(q).end(), p) - near.of(q).begin();
      const double there = op.conductance()[near.start[q] + static_cast<std::size_t>(back)];
      EXPECT_GT(op.conductance()[s], 0.0);
      EXPECT_NEAR(op.conductance()[s], there, 1e-13 * there);
      sum += op.conductance()[s];
    }
    EXPECT_NEAR(op.diagonal()[p], sum, 1e-15 * sum);
  }
}

TEST(HeadOperator, IsPositiveSemidefiniteAndConservative) {
  const auto block = lattice(8, 8, 1.0, 0.15);
  HeadOperator op(1.0, smoothing_ratio, {.right = 8.0}, 1);
  op.update(block.skeleton());
  op.set_conductivity(std::vector<double>(block.size(), 1.0));
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::vector<double> h(block.size()), out(block.size());
  for (int trial = 0; trial < 200; ++trial) {
    for (double& v : h) v = normal(random);
    op.apply(h, out);
    double energy = 0.0, sum = 0.0;
    for (std::size_t p = 0; p < h.size(); ++p) {
      energy += h[p] * out[p];
      sum += out[p];
    }
    EXPECT_GT(energy, 0.0);
    EXPECT_NEAR(sum, 0.0, 1e-12) << "what leaves one particle enters another";
  }
}

TEST(HeadOperator, AUniformHeadIsExactlyStill) {
  const auto block = lattice(6, 6, 1.0, 0.3);
  HeadOperator op(1.0, smoothing_ratio, {.base = 0.0}, 1);
  op.update(block.skeleton());
  op.set_conductivity(std::vector<double>(block.size(), 1.0e-5));
  std::vector<double> out(block.size(), 1.0);
  op.apply(std::vector<double>(block.size(), 12.345678), out);
  for (const double v : out) EXPECT_EQ(v, 0.0);
}

TEST(HeadOperator, StripsOfAnyWidthConductAlongThemselvesExactly) {
  for (const int rows : {1, 2, 3, 4, 8}) {
    for (const bool on_a_wall : {false, true}) {
      const auto strip = lattice(12, rows, 0.25);
      MirrorWalls walls{.left = 0.0, .right = 3.0};
      if (on_a_wall) walls.base = 0.0;
      HeadOperator op(0.25, smoothing_ratio, walls, 1);
      op.update(strip.skeleton());
      op.set_conductivity(std::vector<double>(strip.size(), 1.0));
      EXPECT_NEAR(conduction(strip, op, 1.5) / (0.25 * rows), 1.0, 1e-3) << rows << " rows, wall: " << on_a_wall;
    }
  }
}

TEST(HeadOperator, ConductsTowardsAFreeSurfaceExactly) {
  const auto block = lattice(12, 8, 0.5);
  HeadOperator op(0.5, smoothing_ratio, {.base = 0.0, .top = 4.0}, 1);
  op.update(block.skeleton());
  op.set_conductivity(std::vector<double>(block.size(), 1.0));
  for (int line = 1; line < 12; ++line) EXPECT_NEAR(conduction(block, op, 0.5 * line) / 4.0, 1.0, 5e-4) << line;
}

TEST(HeadOperator, ConductsTowardsASurfaceOfThinOrThickParticles) {
  for (const double thickness : {0.5, 0.7, 1.3, 1.5}) {
    auto block = lattice(12, 8, 0.5);
    for (std::size_t p = 11; p < block.size(); p += 12) {
      block.x[p] = 0.5 * (11.0 + 0.5 * thickness);
      block.volume[p] *= thickness;
    }
    HeadOperator op(0.5, smoothing_ratio, {.base = 0.0, .top = 4.0}, 1);
    op.update(block.skeleton());
    op.set_conductivity(std::vector<double>(block.size(), 1.0));
    for (int line = 1; line < 12; ++line) {
      EXPECT_NEAR(conduction(block, op, 0.5 * line) / 4.0, 1.0, thickness < 0.6 ? 0.1 : 5e-4)
          << thickness << " " << line;
    }
  }
}

TEST(HeadOperator, ALatticeOfOblongsConductsExactlyInBothDirections) {
  auto block = lattice(15, 15, 1.0);
  for (double& y : block.y) y *= 0.8;
  for (double& v : block.volume) v *= 0.8;
  HeadOperator op(1.0, smoothing_ratio, {0.0, 15.0, 0.0, 12.0}, 1);
  op.update(block.skeleton());
  op.set_conductivity(std::vector<double>(block.size(), 1.0));
  EXPECT_NEAR(conduction(block, op, 7.0) / 12.0, 1.0, 2e-3);
  auto turned = block;
  std::swap(turned.x, turned.y);
  HeadOperator other(1.0, smoothing_ratio, {0.0, 12.0, 0.0, 15.0}, 1);
  other.update(turned.skeleton());
  other.set_conductivity(std::vector<double>(block.size(), 1.0));
  EXPECT_NEAR(conduction(turned, other, 5.6) / 15.0, 1.0, 2e-3);
}

TEST(HeadOperator, LinearHeadsLeaveLittleResidueAmongDisorder) {
  const auto block = lattice(24, 24, 1.0, 0.1);
  HeadOperator op(1.0, smoothing_ratio, {}, 1);
  op.update(block.skeleton());
  op.set_conductivity(std::vector<double>(block.size(), 1.0));
  std::vector<double> out(block.size());
  op.apply(block.x, out);
  double squares = 0.0;
  int inside = 0;
  for (std::size_t p = 0; p < block.size(); ++p) {
    if (std::min({block.x[p], block.y[p], 24.0 - block.x[p], 24.0 - block.y[p]}) < 3.0) continue;
    squares += out[p] * out[p];
    ++inside;
  }
  EXPECT_LT(std::sqrt(squares / inside), 0.02);  // 0.35 without the correction of first moments
}

// Squares cut off at the ground; of each what lies below it, at its centroid, and less than half a square joined to the
// one underneath.
Particles cut_squares(double width, double highest, double spacing, const std::function<double(double)>& ground,
                      double jitter) {
  struct Piece {
    double x, y, volume;
  };
  Particles result;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-jitter * spacing, jitter * spacing);
  for (double left = 0.0; left < width - 0.5 * spacing; left += spacing) {
    Piece rest{0.0, 0.0, 0.0};
    for (double row = std::ceil(highest / spacing) - 1.0; row >= 0.0; row -= 1.0) {
      constexpr int strips = 200;
      Piece piece = rest;
      for (int i = 0; i < strips; ++i) {
        const double x = left + (i + 0.5) * spacing / strips;
        const double height = std::clamp(ground(x) - row * spacing, 0.0, spacing);
        const double volume = height * spacing / strips;
        piece.x += volume * x;
        piece.y += volume * (row * spacing + 0.5 * height);
        piece.volume += volume;
      }
      const bool sliver = piece.volume < 0.499999 * spacing * spacing;
      rest = sliver ? piece : Piece{0.0, 0.0, 0.0};
      if (sliver) continue;
      result.x.push_back(piece.x / piece.volume + (jitter > 0.0 ? offset(random) : 0.0));
      result.y.push_back(piece.y / piece.volume + (jitter > 0.0 ? offset(random) : 0.0));
      result.volume.push_back(piece.volume);
    }
  }
  result.porosity.assign(result.x.size(), 0.4);
  return result;
}

struct PatchError {
  double flow;  // over the exact one
  double head;  // largest error, in spacings
};

// Uniform downward flow, h = y, between the ground and a base at y = 0 that are both held at it, and two walls.
PatchError downward_flow(double width, double highest, const std::function<double(double)>& ground, double jitter) {
  constexpr double d = 0.5, step = d / 64.0;
  const Particles block = cut_squares(width, highest, d, ground, jitter);
  const std::size_t n = block.size();
  HeadOperator op(d, smoothing_ratio, {.left = 0.0, .right = width}, 1);
  op.update(block.skeleton());
  op.set_conductivity(std::vector<double>(n, 1.0));
  std::vector<double> base(n, 0.0), face(n, 0.0), load(n, 0.0), h(n, 0.0), diagonal(n);
  const auto owner = [&](double x, double y) {
    std::size_t nearest = 0;
    for (std::size_t p = 1; p < n; ++p) {
      if (std::hypot(block.x[p] - x, block.y[p] - y) < std::hypot(block.x[nearest] - x, block.y[nearest] - y)) {
        nearest = p;
      }
    }
    return nearest;
  };
  for (double x = 0.5 * step; x < width; x += step) {
    const std::size_t low = owner(x, 0.0);
    base[low] += step / block.y[low];
    // the foot of the particle's normal on the ground's tangent at x
    const double y = ground(x), slope = (ground(x + 0.25 * step) - ground(x - 0.25 * step)) / (0.5 * step);
    const std::size_t p = owner(x, y);
    const double stretch = std::hypot(1.0, slope);
    const double distance = std::max(0.05 * d, (y - block.y[p] - slope * (x - block.x[p])) / stretch);
    const double conductance = step * stretch / distance;
    face[p] += conductance;
    load[p] += conductance * (block.y[p] + distance / stretch);
  }
  for (std::size_t p = 0; p < n; ++p) diagonal[p] = op.diagonal()[p] + base[p] + face[p];
  const auto apply = [&](std::span<const double> in, std::span<double> out) {
    op.apply(in, out);
    for (std::size_t p = 0; p < n; ++p) out[p] += (base[p] + face[p]) * in[p];
  };
  ConjugateGradients solver;
  EXPECT_TRUE(solver.solve(apply, diagonal, load, h, 1.0e-10, 3000, 1).converged);
  PatchError error{0.0, 0.0};
  for (std::size_t p = 0; p < n; ++p) {
    error.flow += base[p] * h[p] / width;
    error.head = std::max(error.head, std::abs(h[p] - block.y[p]) / d);
  }
  return error;
}

TEST(HeadOperator, ConductsThroughAnInclinedSurfaceExactly) {
  for (const double degrees : {0.0, 10.0, 20.0, 34.0, 45.0, 60.0}) {
    for (const double offset : {0.0, 0.125, 0.25, 0.4}) {
      for (const double jitter : {0.0, 0.1}) {
        const double width = degrees > 46.0 ? 3.0 : 5.0, slope = std::tan(degrees * std::numbers::pi / 180.0);
        const PatchError error = downward_flow(
            width, 2.0 + offset + slope * width, [=](double x) { return 2.0 + offset + slope * x; }, jitter);
        EXPECT_NEAR(error.flow, 1.0, 0.01) << degrees << " deg, offset " << offset << ", jitter " << jitter;
        EXPECT_LT(error.head, 0.1) << degrees << " deg, offset " << offset << ", jitter " << jitter;
      }
    }
  }
}

TEST(HeadOperator, ConductsThroughABrokenSurfaceExactly) {
  // a slope between two flats, with a bench half way up
  const auto slope = [](double x) { return 1.0 + std::clamp(x - 2.0, 0.0, 1.5) + std::clamp(x - 5.5, 0.0, 1.5); };
  // a dam
  const auto dam = [](double x) { return 1.0 + std::clamp(std::min(0.8 * (x - 1.0), 0.5 * (8.0 - x)), 0.0, 2.0); };
  for (const double raise : {0.1, 0.25, 0.4}) {
    for (const double jitter : {0.0, 0.1}) {
      for (const auto& shape : {std::function<double(double)>(slope), std::function<double(double)>(dam)}) {
        const PatchError error = downward_flow(
            9.0, 4.5, [&](double x) { return raise + shape(x); }, jitter);
        EXPECT_NEAR(error.flow, 1.0, 0.01) << raise << " " << jitter;
        EXPECT_LT(error.head, 0.1) << raise << " " << jitter;
      }
    }
  }
}

TEST(HeadOperator, ConductsExactlyWhenTheSoilHasSwollen) {
  constexpr double swelling = 1.12;
  auto block = lattice(12, 8, 0.5);
  HeadOperator op(0.5, smoothing_ratio, {.base = 0.0, .top = 4.0 * swelling}, 1);
  op.update(block.skeleton());
  for (double& x : block.x) x *= swelling;
  for (double& y : block.y) y *= swelling;
  for (double& v : block.volume) v *= swelling * swelling;
  op.update(block.skeleton());
  op.set_conductivity(std::vector<double>(block.size(), 1.0));
  for (int line = 1; line < 12; ++line) {
    EXPECT_NEAR(conduction(block, op, 0.5 * line * swelling) / (4.0 * swelling), 1.0, 0.01) << line;
  }
}

// Laplace's equation with h = x^2 - y^2 + x y at the faces of the unit square.
double laplace_error(int cells) {
  const double d = 1.0 / cells;
  const auto block = lattice(cells, cells, d);
  const std::size_t n = block.size();
  HeadOperator op(d, smoothing_ratio, {}, 1);
  op.update(block.skeleton());
  op.set_conductivity(std::vector<double>(n, 1.0));
  const auto exact = [](double x, double y) { return x * x - y * y + x * y; };
  std::vector<double> face(n, 0.0), load(n, 0.0), h(n, 0.0), diagonal(n);
  const auto add = [&](std::size_t p, double x, double y) {
    face[p] += 2.0;
    load[p] += 2.0 * exact(x, y);
  };
  for (std::size_t p = 0; p < n; ++p) {
    if (block.x[p] < d) add(p, 0.0, block.y[p]);
    if (block.x[p] > 1.0 - d) add(p, 1.0, block.y[p]);
    if (block.y[p] < d) add(p, block.x[p], 0.0);
    if (block.y[p] > 1.0 - d) add(p, block.x[p], 1.0);
    diagonal[p] = op.diagonal()[p] + face[p];
  }
  const auto apply = [&](std::span<const double> in, std::span<double> out) {
    op.apply(in, out);
    for (std::size_t p = 0; p < n; ++p) out[p] += face[p] * in[p];
  };
  ConjugateGradients solver;
  EXPECT_TRUE(solver.solve(apply, diagonal, load, h, 1.0e-10, 2000, 1).converged);
  double squares = 0.0;
  for (std::size_t p = 0; p < n; ++p) squares += std::pow(h[p] - exact(block.x[p], block.y[p]), 2);
  return std::sqrt(squares / static_cast<double>(n));
}

TEST(HeadOperator, ConvergesWithOrderTwo) {
  EXPECT_GT(std::log2(laplace_error(16) / laplace_error(64)) / 2.0, 1.8);
}

TEST(HeadOperator, TheMeanOfExponentialConductivitiesIsExactToFourthOrder) {
  const auto pair = lattice(2, 1, 1.0);
  HeadOperator op(1.0, smoothing_ratio, {}, 1);
  op.update(pair.skeleton());
  op.set_conductivity(std::vector<double>{1.0, 1.0});
  const double unit = op.conductance()[0];
  for (const double difference : {0.1, 1.0}) {
    op.set_conductivity(std::vector<double>{1.0, std::exp(-difference)});
    const double exact = (1.0 - std::exp(-difference)) / difference;
    EXPECT_NEAR(op.conductance()[0] / unit / exact, 1.0, 4e-4 * std::pow(difference, 4));
  }
}

TEST(HeadOperator, FollowsOnlyWhatHasMoved) {
  auto block = lattice(5, 5, 1.0);
  HeadOperator op(1.0, smoothing_ratio, {}, 1);
  EXPECT_TRUE(op.update(block.skeleton()));
  EXPECT_FALSE(op.update(block.skeleton()));
  block.x[7] += 0.005;
  EXPECT_FALSE(op.update(block.skeleton()));
  block.x[7] += 0.01;
  EXPECT_TRUE(op.update(block.skeleton()));
}

TEST(HeadOperator, DoesNotDependOnTheThreads) {
  const auto block = lattice(50, 50, 1.0, 0.2);
  std::vector<double> k(block.size()), h(block.size()), one(block.size()), two(block.size());
  for (std::size_t p = 0; p < block.size(); ++p) {
    k[p] = std::exp(-block.y[p] / 50.0);
    h[p] = std::sin(block.x[p]);
  }
  HeadOperator first(1.0, smoothing_ratio, {.base = 0.0}, 1), second(1.0, smoothing_ratio, {.base = 0.0}, 2);
  for (auto* op : {&first, &second}) {
    op->update(block.skeleton());
    op->set_conductivity(k);
    op->apply(h, op == &first ? one : two);
  }
  EXPECT_EQ(one, two);
}

TEST(HeadOperator, LoneParticlesDoNotDisturb) {
  auto block = lattice(5, 5, 1.0);
  block.x.back() = 100.0;  // nobody near
  block.x[0] = -50.0;      // a pair far away
  block.x[1] = -51.0;
  HeadOperator op(1.0, smoothing_ratio, {}, 1);
  op.update(block.skeleton());
  op.set_conductivity(std::vector<double>(block.size(), 1.0));
  EXPECT_EQ(op.diagonal().back(), 0.0);
  EXPECT_GT(op.diagonal()[0], 0.0);
  for (const double g : op.conductance()) EXPECT_TRUE(std::isfinite(g) && g > 0.0);
}

TEST(HeadOperator, GradientOfALinearFieldIsExact) {
  const auto block = lattice(7, 7, 0.5, 0.3);
  HeadOperator op(0.5, smoothing_ratio, {}, 1);
  op.update(block.skeleton());
  std::vector<double> field(block.size()), dx(block.size()), dy(block.size());
  for (std::size_t p = 0; p < block.size(); ++p) field[p] = 3.0 - 2.0 * block.x[p] + 5.0 * block.y[p];
  op.gradient(field, block.skeleton(), dx, dy);
  for (std::size_t p = 0; p < block.size(); ++p) {
    EXPECT_NEAR(dx[p], -2.0, 1e-10);
    EXPECT_NEAR(dy[p], 5.0, 1e-10);
  }
}

}  // namespace
}  // namespace slope::seepage
