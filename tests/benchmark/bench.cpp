// What one particle-step costs: the solid, the pressure step, the neighbour search, and beside each a plain kernel that
// does its bare memory traffic, so that ratios can be compared between machines. The column `per_particle` is the time
// per particle and step in seconds (400n: 400 ns). It is a benchmark, not a test.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "slope/seepage/coupled_step.hpp"
#include "slope/seepage/neighbours.hpp"
#include "slope/seepage/pore_flow.hpp"
#include "slope/solid/material_point_method.hpp"

namespace {

using slope::seepage::PoreFlow;
using slope::solid::MaterialPointMethod;

// A block of the paper's soil W2 that fills a box: four particles to a cell of 0.5 m, twice as wide as high.
struct Block {
  explicit Block(std::size_t wanted) {
    const int rows = static_cast<int>(std::lround(std::sqrt(static_cast<double>(wanted) / 8.0)));
    grid.cell_size = 2.0 * spacing;
    grid.columns = 2 * rows;
    grid.rows = rows + 2;
    grid.walls.right = slope::solid::Wall::roller;
    for (int j = 0; j < 2 * rows; ++j) {
      for (int i = 0; i < 4 * rows; ++i) {
        x.push_back((i + 0.5) * spacing);
        y.push_back((j + 0.5) * spacing);
      }
    }
    const double water_table = 0.5 * rows * grid.cell_size;
    for (const double height : y) pressure.push_back(water.unit_weight() * (water_table - height));
    volume.assign(x.size(), spacing * spacing);
    porosity.assign(x.size(), 0.35);
    soil.assign(x.size(), 0);
  }

  [[nodiscard]] slope::seepage::Skeleton skeleton() const { return {x, y, volume, porosity}; }

  [[nodiscard]] MaterialPointMethod solid(int threads) const {
    slope::solid::Soil sand;
    sand.elastic = {.youngs_modulus = 1.0e7, .poissons_ratio = 0.33};
    sand.strength = slope::solid::DruckerPrager{.cohesion = 1.0e3, .friction_angle = 0.436};
    sand.grain_density = 2700.0;
    slope::solid::Settings settings;
    settings.particle_spacing = spacing;
    settings.threads = threads;
    const std::vector<double> grain_density{sand.grain_density};
    auto particles = slope::solid::Particles::at(x, y, volume, porosity, soil, grain_density);
    return {grid, {sand}, std::move(particles), settings};
  }

  [[nodiscard]] PoreFlow water_flow(int threads) const {
    slope::seepage::Soil sand;
    sand.retention = slope::seepage::VanGenuchten{.alpha = 0.05, .n = 3.0, .range = {}};
    sand.relative_permeability.law = slope::seepage::HillelPower{.exponent = 2.0};
    sand.hydraulic_conductivity = 1.0e-5;
    slope::seepage::FlowSettings settings;
    settings.spacing = spacing;
    settings.walls = {.left = 0.0, .right = grid.columns * grid.cell_size, .base = 0.0};
    settings.threads = threads;
    return {{sand}, water, soil, pressure, skeleton(), settings};
  }

  const double spacing = 0.25;
  slope::seepage::Water water;
  slope::solid::Grid grid;
  std::vector<double> x, y, pressure, volume, porosity;
  std::vector<std::uint16_t> soil;
};

// The skeleton's answer to a pressure change, as the pressure step sees it.
struct GridResponse final : slope::seepage::VolumeResponse {
  GridResponse(const MaterialPointMethod& of, double time_step) : solid(of), step(time_step) {}
  const MaterialPointMethod& solid;
  double step;
  void apply(std::span<const double> q, std::span<double> change) const override {
    solid.volume_response(step, q, change);
  }
  void diagonal(std::span<double> diagonal) const override { solid.volume_response_diagonal(step, diagonal); }
};

void report(benchmark::State& state, std::size_t particles) {
  using benchmark::Counter;
  state.counters["particles"] = static_cast<double>(particles);
  state.counters["per_particle"] =
      Counter(static_cast<double>(particles), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void sizes_and_threads(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"particles", "threads"})->ArgsProduct({{5000, 100000}, {1, 2}})->UseRealTime();
  bench->Unit(benchmark::kMillisecond);
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"particles"})->Arg(5000)->Arg(100000)->UseRealTime()->Unit(benchmark::kMillisecond);
}

void solid_step(benchmark::State& state) {
  const Block block(static_cast<std::size_t>(state.range(0)));
  auto solid = block.solid(static_cast<int>(state.range(1)));
  const double step = solid.stable_step(0.25, {});
  const std::vector<double> pressure_change(block.x.size(), 0.0);
  for ([[maybe_unused]] auto _ : state) {
    solid.predict(step, {block.pressure, {}}, {}, 2.0);
    solid.correct(step, pressure_change);
    solid.advance(step, {});
  }
  report(state, block.x.size());
}
BENCHMARK(solid_step)->Apply(sizes_and_threads);

void pressure_step(benchmark::State& state) {
  const Block block(static_cast<std::size_t>(state.range(0)));
  auto solid = block.solid(static_cast<int>(state.range(1)));
  auto flow = block.water_flow(static_cast<int>(state.range(1)));
  slope::seepage::CoupledStep water_step;
  const double step = solid.stable_step(0.25, {});
  std::vector<double> strain(block.x.size());
  solid.predict(step, {flow.pore_stress(), {}}, {}, 0.0);
  solid.volumetric_strain(step, strain);
  double iterations = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    iterations +=
        water_step.solve(flow, step, block.skeleton(), strain, {}, GridResponse(solid, step), 1.0e-2).iterations;
    water_step.finish(flow, block.skeleton());
  }
  report(state, block.x.size());
  state.counters["iterations"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
}
BENCHMARK(pressure_step)->Apply(sizes_and_threads);

void neighbour_search(benchmark::State& state) {
  const Block block(static_cast<std::size_t>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) {
    auto found =
        slope::seepage::find_neighbours(block.x, block.y, 2.4 * block.spacing, static_cast<int>(state.range(1)));
    benchmark::DoNotOptimize(found.index.data());
  }
  report(state, block.x.size());
}
BENCHMARK(neighbour_search)->Apply(sizes_and_threads);

// Mass and momentum to the nine nodes of a quadratic B-spline and back, one particle after the other.
void plain_grid_transfer(benchmark::State& state) {
  const Block block(static_cast<std::size_t>(state.range(0)));
  const std::size_t n = block.x.size();
  const auto row = static_cast<std::size_t>(block.grid.columns) + 3;
  std::vector<double> vx(n, 0.1), vy(n, -0.1);
  std::vector<double> nodes(3 * row * (static_cast<std::size_t>(block.grid.rows) + 3));
  const auto visit = [&](std::size_t p, auto&& act) {
    const double gx = block.x[p] / block.grid.cell_size + 0.5;
    const double gy = block.y[p] / block.grid.cell_size + 0.5;
    const double fx = gx - std::floor(gx);
    const double fy = gy - std::floor(gy);
    const double wx[3] = {0.5 * (1.0 - fx) * (1.0 - fx), 0.75 - (fx - 0.5) * (fx - 0.5), 0.5 * fx * fx};
    const double wy[3] = {0.5 * (1.0 - fy) * (1.0 - fy), 0.75 - (fy - 0.5) * (fy - 0.5), 0.5 * fy * fy};
    const std::size_t first = static_cast<std::size_t>(gy) * row + static_cast<std::size_t>(gx);
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) act(nodes.data() + 3 * (first + j * row + i), wx[i] * wy[j]);
    }
  };
  for ([[maybe_unused]] auto _ : state) {
    std::fill(nodes.begin(), nodes.end(), 0.0);
    for (std::size_t p = 0; p < n; ++p) {
      visit(p, [&](double* node, double weight) {
        node[0] += weight;
        node[1] += weight * vx[p];
        node[2] += weight * vy[p];
      });
    }
    for (std::size_t p = 0; p < n; ++p) {
      double px = 0.0;
      double py = 0.0;
      visit(p, [&](const double* node, double weight) {
        px += weight * node[1];
        py += weight * node[2];
      });
      vx[p] = 0.999 * px;
      vy[p] = 0.999 * py;
    }
    benchmark::ClobberMemory();
  }
  report(state, n);
}
BENCHMARK(plain_grid_transfer)->Apply(sizes);

// One sum over the neighbours of each particle, as each iteration of the pressure step has it.
void plain_neighbour_sum(benchmark::State& state) {
  const Block block(static_cast<std::size_t>(state.range(0)));
  const auto neighbours = slope::seepage::find_neighbours(block.x, block.y, 2.4 * block.spacing);
  const std::vector<double> conductance(neighbours.index.size(), 1.0);
  std::vector<double> outflow(block.x.size());
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t p = 0; p < outflow.size(); ++p) {
      double sum = 0.0;
      for (std::size_t k = neighbours.start[p]; k < neighbours.start[p + 1]; ++k) {
        sum += conductance[k] * (block.pressure[p] - block.pressure[neighbours.index[k]]);
      }
      outflow[p] = sum;
    }
    benchmark::DoNotOptimize(outflow.data());
    benchmark::ClobberMemory();
  }
  report(state, block.x.size());
}
BENCHMARK(plain_neighbour_sum)->Apply(sizes);

}  // namespace
