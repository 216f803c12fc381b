#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "slope/solid/grid.hpp"
#include "slope/solid/particles.hpp"
#include "slope/solid/soil.hpp"

namespace slope::solid {

/// Broken physics of the skeleton: a particle outside of the grid, a volume that is not positive, a velocity that is
/// not a number.
class SolidError : public std::runtime_error {
 public:
  SolidError(std::size_t particle, const std::string& field, double value);
  std::size_t particle;  ///< index
  std::string field;
  double value;
};

enum class ShapeFunction { quadratic_bspline, linear };

struct Settings {
  ShapeFunction shape_function = ShapeFunction::quadratic_bspline;
  double flip_fraction = -1.0;  ///< < 0: APIC; else the FLIP share in [0, 1] of a FLIP/PIC blend
  double gravity = 9.81;        ///< (m/s2), towards -y
  double particle_spacing = 0.0;  ///< thickness h of the boundary layer that carries tractions in Eq. 17 (m)
  int threads = 1;              ///< >= 1; results do not depend on it
};

/// What the skeleton needs to know of the pore water; views of one entry per particle. Empty views mean dry soil.
struct PoreState {
  std::span<const double> pressure;    ///< S_r P_w (Pa): the pore water's part of the total stress, positive in compression
  std::span<const double> water_mass;  ///< n S_r rho_w V (kg/m), the water that moves with the skeleton
};

/// A traction on one particle (Pa).
struct ParticleTraction {
  std::size_t particle = 0;
  double x = 0.0;
  double y = 0.0;
};

/// What one step moves.
struct StepMode {
  bool yields = true;           ///< false: elastic, whatever the strength
  bool moves = true;            ///< false: stress builds up at fixed positions, volumes and porosity
  bool accumulates_strain = true;
};

/// Sums over the grid of the latest step, for histories and control.
struct Balance {
  double kinetic_energy = 0.0;    ///< of the grid (J/m)
  double unbalanced_force = 0.0;  ///< sum of |internal + external force| over the free nodal components (N/m)
  double weight = 0.0;            ///< sum of the gravity forces (N/m)
};

/// The material point method for the soil skeleton: momentum of the mixture on a background grid (paper, Eq. 17), in
/// four calls that leave room for the pore water between them:
///
///     predict(dt, ...)           particles to grid; v* from stress, the old pore pressure, gravity and tractions
///     volume_response(dt, q, dV) what volume change a pressure change q would cause (any number of times)
///     correct(dt, q)             the pressure change acts on the grid velocity
///     advance(dt, suction, mode) grid to particles: velocity, position, strain, volume, porosity, stress
///
/// The pore pressure acts through its volume-weighted average over the particles of each cell, and so does the
/// volumetric strain: the two are transposes of each other, so that no energy is made between them.
class MaterialPointMethod {
 public:
  MaterialPointMethod(const Grid& grid, std::vector<Soil> soils, Particles particles, const Settings& settings);

  /// Largest stable time step: Courant number x cell size / fastest drained P-wave (s), for the mixture density of the
  /// given water masses (empty: dry).
  [[nodiscard]] double stable_step(double courant_number, std::span<const double> water_mass) const;

  /// v* = (v + dt M^-1 f) / (1 + damping dt).
  /// @param damping  mass-proportional viscous damping (1/s), >= 0
  void predict(double dt, const PoreState& pore, std::span<const ParticleTraction> tractions, double damping);

  /// Volumetric strain increment dt div v of the present grid velocity, averaged over each cell (-), one per particle.
  void volumetric_strain(double dt, std::span<double> strain) const;

  /// dV = V Pi D (dt M^-1 D^T V Pi q) dt: the volume change (m2) that a pore pressure change q (Pa) causes within the
  /// step. Symmetric and positive semidefinite in q.
  void volume_response(double dt, std::span<const double> q, std::span<double> volume_change) const;

  /// Diagonal of volume_response (m2/Pa).
  void volume_response_diagonal(double dt, std::span<double> diagonal) const;

  /// v += dt M^-1 D^T V Pi q.
  void correct(double dt, std::span<const double> q);

  /// Grid to particles, then strain, volume, porosity and effective stress (Jaumann rate, return mapping at the given
  /// suction, Pa; empty: zero).
  /// @throws SolidError
  void advance(double dt, std::span<const double> suction, const StepMode& mode = {});

  [[nodiscard]] const Particles& particles() const { return particles_; }
  [[nodiscard]] Particles& particles() { return particles_; }
  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<Soil>& soils() const { return soils_; }
  [[nodiscard]] const Balance& balance() const { return balance_; }
  /// Brings all particles to rest.
  void stop();

 private:
  struct ParticleWeights {
    std::size_t node = 0;  // of the first node
    double dx = 0.0, dy = 0.0;  // from the particle to the first node (m)
    double nx[3], ny[3], gx[3], gy[3];
  };
  // sum over the particles of a cell of V G_ip, for the 4 x 4 nodes that they reach, wall conditions folded in
  struct CellGradient {
    double x[16], y[16];
  };

  template <class Shape>
  void find_weights();
  void sort_into_cells();
  void sum_cell_gradients();
  void scatter(const PoreState& pore);
  void add_tractions(std::span<const ParticleTraction> tractions);
  void fold_walls();
  void update_velocity(double dt, double damping);
  void add_pressure_force(std::span<const double> q, std::vector<double>& fx, std::vector<double>& fy) const;
  void cell_averages(std::span<const double> q) const;
  void cell_divergence(const std::vector<double>& vx, const std::vector<double>& vy) const;
  void unfold_walls();
  template <bool affine>
  void gather(double dt, const StepMode& mode);
  void update_stress(double dt, std::span<const double> suction, const StepMode& mode);
  void check() const;
  [[nodiscard]] std::size_t cell_first_node(std::size_t cell) const;

  Grid grid_;
  std::vector<Soil> soils_;
  Particles particles_;
  Settings settings_;
  Balance balance_;

  std::vector<ParticleWeights> weights_;
  std::vector<std::size_t> cell_of_;         // active cell of each particle
  std::vector<std::size_t> active_cells_;    // grid cells that hold particles, in grid order
  std::vector<std::size_t> cell_start_;      // into cell_particles_, per active cell
  std::vector<std::size_t> cell_particles_;  // particles by cell
  std::vector<CellGradient> cell_gradient_;
  std::vector<double> cell_volume_;
  struct Chunk {
    std::size_t first_cell, last_cell, first_node, last_node;
  };
  std::vector<Chunk> chunks_;  // fixed by the particles, not by the threads
  mutable std::vector<std::vector<double>> chunk_nodes_;

  static constexpr std::size_t fields = 8;  // per node: mass x, mass y, momentum x, y, force x, y, two unused
  std::vector<double> node_;
  std::vector<double> old_vx_, old_vy_, vx_, vy_, inverse_mass_x_, inverse_mass_y_;
  std::vector<double> gradient_of_velocity_;  // 4 per particle: dvx/dx, dvx/dy, dvy/dx, dvy/dy
  mutable std::vector<double> work_x_, work_y_, cell_value_;
};

}  // namespace slope::solid
