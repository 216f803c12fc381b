// Mandel's problem: a saturated slab squeezed between smooth, rigid plates drains sideways. Its middle takes over load
// from the drained flanks, so that the pressure there first rises: the test of two-way coupling in two dimensions.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "block.hpp"
#include "run/mixture.hpp"
#include "run/semi_implicit_scheme.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

constexpr double half_width = 1.0, height = 0.5;     // m; a quarter of the slab, by symmetry
constexpr double load = 10.0e3;                      // Pa, mean stress under the plates
constexpr double ramp = 0.3, drain_opens = 0.5;      // s
constexpr double consolidation_coefficient = 0.05;   // m2/s: slow against the waves, which cross in 0.01 s
constexpr std::array time_factors{0.02, 0.05, 0.1};  // c t / a2

// The exact solution (Mandel 1953; with a compressible fluid, Cheng and Detournay 1988). Instead of plates the stress
// that they exert, which the solution gives, acts on the slab.
class ExactSolution {
 public:
  ExactSolution(const solid::Elastic& elastic, double porosity, double water_bulk_modulus) {
    const double nu = elastic.poissons_ratio, storage = porosity / water_bulk_modulus;
    const double skempton = 1.0 / (1.0 + storage * elastic.bulk_modulus());
    const double nu_undrained = (3.0 * nu + skempton * (1.0 - 2.0 * nu)) / (3.0 - skempton * (1.0 - 2.0 * nu));
    start_ = load * skempton * (1.0 + nu_undrained) / 3.0;
    share_ = (nu_undrained - nu) / (1.0 - nu);
    const double ratio = 1.0 / share_;
    for (int i = 0; i < 200; ++i) {
      // tan(root) = ratio root, ratio > 1, one root in each interval (i pi, i pi + pi / 2)
      double low = i * std::numbers::pi + 1.0e-9, high = (i + 0.5) * std::numbers::pi - 1.0e-13;
      for (int k = 0; k < 100; ++k) {
        const double middle = 0.5 * (low + high);
        (std::tan(middle) < ratio * middle ? low : high) = middle;
      }
      roots_.push_back(0.5 * (low + high));
    }
  }

  [[nodiscard]] double start() const { return start_; }  // pressure after undrained loading (Pa)
  // x over the half width, from the middle
  [[nodiscard]] double pressure(double x, double time_factor) const {
    return 2.0 * start_ *
           sum(time_factor, [x](double root) { return std::sin(root) * (std::cos(root * x) - std::cos(root)); });
  }
  [[nodiscard]] double plate_stress(double x, double time_factor) const {
    return load * (1.0 + 2.0 * sum(time_factor, [this, x](double root) {
                           return std::sin(root) * (share_ * std::cos(root * x) - std::cos(root));
                         }));
  }

 private:
  template <class Term>
  [[nodiscard]] double sum(double time_factor, const Term& term) const {
    double total = 0.0;
    for (const double root : roots_) {
      const double decay = std::exp(-root * root * time_factor);
      total += term(root) / (root - std::sin(root) * std::cos(root)) * decay;
    }
    return total;
  }

  double start_ = 0.0, share_ = 0.0;
  std::vector<double> roots_;
};

struct Figures {
  double pressure = 0.0;  // largest error, over the pressure after undrained loading
  double peak = 0.0;      // largest pressure in the middle so far, over the exact one
};

Figures run_mandel(double cell_size) {
  Block block(half_width, height, cell_size, 2.0 * cell_size);
  couple::Case& input = block.input;
  input.gravity = 1.0e-6;
  const solid::Elastic& elastic = input.soils[0].solid.elastic;
  const double porosity = input.soils[0].porosity, bulk_modulus = input.water.bulk_modulus;
  const double storage = 1.0 / elastic.constrained_modulus() + porosity / bulk_modulus;
  input.soils[0].seepage.hydraulic_conductivity =
      consolidation_coefficient * storage * input.water.density * input.gravity;
  const ExactSolution exact(elastic, porosity, bulk_modulus);

  const couple::InitialParticles particles = block.particles();
  couple::Mixture mixture(input, particles, std::vector<double>(particles.x.size(), 0.0), 1);
  const std::vector<std::size_t> top = couple::particles_at({couple::Place::ground_surface}, particles);
  couple::Actions actions;
  actions.water.count = 1;
  seepage::Boundary drain;
  drain.count = 1;
  const double spacing = particles.spacing;
  for (const std::size_t p : couple::particles_at({couple::Place::right}, particles)) {
    drain.faces.push_back({static_cast<std::uint32_t>(p), 0, 0.0, 0.0, 0.5 * spacing, spacing});
  }

  couple::SemiImplicitScheme scheme(input.numerics.pressure_tolerance);
  const double largest_step = couple::SemiImplicitScheme::stable_step(mixture, input.numerics.courant_number);
  Figures figures;
  double time = 0.0, highest = 0.0, exact_highest = 0.0;
  const auto run_to = [&](double end) {
    const int steps = static_cast<int>(std::ceil((end - time) / largest_step));
    const double time_step = (end - time) / steps, start = time;
    for (int k = 1; k <= steps; ++k) {
      time = start + k * time_step;
      const double time_factor =
          consolidation_coefficient * std::max(0.0, time - drain_opens) / (half_width * half_width);
      const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * std::min(1.0, time / ramp));
      actions.tractions.clear();
      for (const std::size_t p : top) {
        const double stress =
            time <= drain_opens ? share * load : exact.plate_stress(particles.x[p] / half_width, time_factor);
        actions.tractions.push_back({p, 0.0, -stress, 0.0, 0.5 * spacing});
      }
      if (time > drain_opens) actions.water = drain;
      scheme.step(mixture, actions, time_step, 1.0);
      highest = std::max(highest, mixture.water.pressure()[0]);
      exact_highest = std::max(exact_highest, exact.pressure(0.0, time_factor));
    }
  };
  run_to(drain_opens);
  for (const double time_factor : time_factors) {
    run_to(drain_opens + time_factor * half_width * half_width / consolidation_coefficient);
    for (std::size_t p = 0; p < particles.x.size(); ++p) {
      const double error = mixture.water.pressure()[p] - exact.pressure(particles.x[p] / half_width, time_factor);
      figures.pressure = std::max(figures.pressure, std::abs(error) / exact.start());
    }
  }
  EXPECT_GT(highest, 1.03 * exact.start());
  figures.peak = highest / exact_highest;
  return figures;
}

TEST(Mandel, ConvergesAndSqueezesItsMiddle) {
  const Figures coarse = run_mandel(0.1);
  const Figures fine = run_mandel(0.05);
  EXPECT_TRUE(record("mandel-1", "Mandel's slab, 40 x 20 particles: pressure, T = 0.02 to 0.1", at_most(0.02),
                     fine.pressure, "%"));
  EXPECT_TRUE(record("mandel-2", "- pressure error on 20 x 10 over that on 40 x 20 particles", at_least(1.5),
                     coarse.pressure / fine.pressure, ""));
  EXPECT_TRUE(
      record("mandel-3", "- largest pressure in the middle, over the exact one", near(1.0, 0.01), fine.peak, ""));
}

}  // namespace
}  // namespace slope::testing
