#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "slope/solid/grid.hpp"
#include "slope/solid/particles.hpp"
#include "slope/solid/soil.hpp"
#include "slope/solid/soil_faces.hpp"
#include "slope/solid/strength_law.hpp"
#include "slope/solid/tensor.hpp"

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
  double flip_fraction = -1.0;    ///< < 0: APIC; else the FLIP share in [0, 1] of a FLIP/PIC blend
  double gravity = 9.81;          ///< (m/s2), towards -y
  bool averages_pressure = true;  ///< pressure and volume change, over the hat functions of the grid's nodes; false:
                                  ///< every particle's own, as Eq. 17 has it
  double particle_spacing = 0.0;  ///< surface (m) that a particle's traction acts on: V / h of Eq. 17, undeformed
  int threads = 1;                ///< >= 1; results do not depend on it
};

/// An internal variable of the strength laws, as a field on the particles.
struct InternalField {
  std::string name, unit;
  std::vector<double> values;  ///< one per particle; zero in soils whose law has no such variable
};

/// What the skeleton needs to know of the pore water; views of one entry per particle. Empty views mean dry soil.
struct PoreState {
  std::span<const double>
      pressure;  ///< S_r P_w (Pa): the pore water's part of the total stress, positive in compression
  std::span<const double> water_mass;  ///< n S_r rho_w V (kg/m), the water that moves with the skeleton
};

/// A pressure p on the surface of the soil, such as of water that stands on it: the traction -p n of a field that goes
/// on inside; views of one entry per particle, empty without one. It acts by Gauss's theorem as a volume force,
/// -sum V (p grad N + N grad p), so that its resultant is exact whatever the shape of the surface, and that a pore
/// pressure equal to it leaves no force but buoyancy. Walls bear it as if it acted on the soil there too.
struct SurfacePressure {
  std::span<const double> pressure;    ///< p (Pa), positive towards the soil; zero where nothing stands
  std::span<const double> gradient_x;  ///< dp/dx (Pa/m)
  std::span<const double> gradient_y;  ///< dp/dy (Pa/m)
};

/// A traction on the face of one particle. It is handed on to the soil behind the face, three cells deep, so that soil
/// under uniform load is uniform wherever its surface lies in the grid.
struct ParticleTraction {
  std::size_t particle = 0;
  double x = 0.0;  ///< (Pa)
  double y = 0.0;  ///< (Pa)
  double face_x =
      0.0;  ///< where the face lies, seen from the particle (m); at the particle itself, as Eq. 17 has it, a
  double face_y = 0.0;  ///< load acts half a spacing too deep
};

/// What acts on the soil from outside in one step, besides gravity.
struct Loads {
  std::span<const ParticleTraction> tractions{};      ///< each acts over one particle spacing of surface (Eq. 17)
  std::array<double, 2> body_acceleration{0.0, 0.0};  ///< of a body force on soil and water (m/s2)
  SurfacePressure surface{};
};

/// What one step moves.
struct StepMode {
  bool yields = true;              ///< false: elastic, whatever the strength
  bool moves = true;               ///< false: stress builds up at fixed positions, volumes and porosity
  bool accumulates_strain = true;  ///< false: neither strain nor plastic strain is added up
  /// Share, in [0, 1], of what APIC takes from lasting motion that the particles get back. The transfer smooths what
  /// lies below the grid, as a viscosity would, which soil that creeps with a clock factor Theta > 1 feels Theta times
  /// as much as in real time; a share of 1 - 1 / Theta leaves it as much as in real time. Vibrations are damped all the
  /// same. Of no effect on linear shape functions and FLIP, and within two cells of an absorbing wall.
  double restored_losses = 0.0;
};

/// Sums over the grid of the latest step, for histories and control.
struct Balance {
  double kinetic_energy = 0.0;    ///< of the grid (J/m)
  double unbalanced_force = 0.0;  ///< sum of |internal + external force| over the free nodal components (N/m)
  double weight = 0.0;            ///< of all particles (N/m)

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("kinetic_energy", s.kinetic_energy);
    visit("unbalanced_force", s.unbalanced_force);
    visit("weight", s.weight);
  }
  bool operator==(const Balance&) const = default;
};

/// What a wall that can move remembers at one of its nodes. Normal and friction force are on the soil, inwards and
/// along the wall's axis.
struct WallState {
  double normal_force = 0.0, friction_force = 0.0;  ///< of a frictional wall, in the latest step (N/m)
  double felt = 0.0, usual = 0.0;  ///< normal force, as the whole of the friction and its distribution follow it (N/m)
  std::array<double, 2> reaction{};      ///< force of an absorbing wall at rest (N/m)
  std::array<double, 2> displacement{};  ///< of an absorbing wall since the release (m)
  std::array<double, 2> dashpot{};       ///< of an absorbing wall (N s/m2), >= 0
  std::array<double, 2> spring{};        ///< of an absorbing wall (N/m2), >= 0

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("normal_force", s.normal_force), visit("friction_force", s.friction_force);
    visit("felt", s.felt), visit("usual", s.usual);
    visit("reaction", s.reaction);
    visit("displacement", s.displacement);
    visit("dashpot", s.dashpot), visit("spring", s.spring);
  }
  bool operator==(const WallState&) const = default;
};

/// What a frictional wall bears at one of its nodes.
struct WallReaction {
  double x = 0.0, y = 0.0;  ///< place of the node (m)
  double normal = 0.0;      ///< on the soil, away from the wall (N/m), >= 0
  double friction = 0.0;    ///< on the soil, along the wall's axis (N/m)
};

/// The material point method for the soil skeleton: momentum of the mixture on a background grid (paper, Eq. 17), in
/// four calls that leave room for the pore water between them:
///
///     predict(dt, ...)           particles to grid; v* from stress, the old pore pressure, gravity and tractions
///     volume_response(dt, q, dV) what volume change a pressure change q would cause (any number of times)
///     correct(dt, q)             the pressure change acts on the grid velocity
///     advance(dt, suction, mode) grid to particles: velocity, position, strain, volume, porosity, stress
///
/// The pore pressure acts through its projection Pi = N M^-1 N^T V on the bilinear hat functions N of the grid's nodes,
/// V the particles' volumes, M = N^T V 1 (lumped): each node takes the volume-weighted average over its hat, each
/// particle what the hats give back. The volumetric strain that the water, the volumes and the effective stress see is
/// projected alike; since Pi^T V = V Pi, force and strain are transposes of each other and no energy is made between
/// them. A particle's own volume change, four constraints to a cell, would lock soil that flows at constant volume.
/// The volume change of plastic flow is projected with it: the mean stress of a particle that dilates more than its
/// neighbours would else rise against theirs without end, for no total volume change that they share can undo it.
/// Where soils meet, the traction on the face between them is one: within half a cell of it no soil bears more along it
/// than the other does. Else the stronger soil would hold the weaker, which the grid shears with it over a cell.
/// With Settings::averages_pressure false each particle's own pressure and strain act instead; then volume_response()
/// and correct() are of no use.
///
/// What it is between two steps is its State; all else is given once or worked out in each step anew. A copy goes on as
/// the original does.
class MaterialPointMethod {
 public:
  struct State {
    Particles particles;
    std::vector<WallState> walls;  ///< of the nodes of the walls that can move: left, right, base
    bool walls_released = false;
    bool has_losses = false;  ///< whether the particles' losses are those of the latest steps; else they are zero
    double whole_time = 0.0, distribution_time = 0.0;  ///< in which friction follows the normal force (s)
    Balance balance;                                   ///< of the latest step

    template <class Self, class Visit>
    static void for_each_field(Self& s, const Visit& visit) {
      visit("particles", s.particles);
      visit("walls", s.walls);
      visit("walls_released", s.walls_released), visit("has_losses", s.has_losses);
      visit("whole_time", s.whole_time), visit("distribution_time", s.distribution_time);
      visit("balance", s.balance);
    }
    bool operator==(const State&) const = default;
  };

  /// @param particles  their internal variables are set by their stress
  /// @throws std::invalid_argument if there is no cell, soil or thread, if the particles' arrays differ in length or
  /// name a soil that is not there, or if the share of FLIP is above one
  MaterialPointMethod(const Grid& grid, std::vector<Soil> soils, Particles particles, const Settings& settings);

  /// Largest stable time step: Courant number x cell size / fastest drained P-wave (s), for the mixture density of the
  /// given water masses (empty: dry). Where the stiffness varies, it is that of the present stress.
  [[nodiscard]] double stable_step(double courant_number, std::span<const double> water_mass) const;

  /// Whether the stiffness of a soil depends on its stress; if so, so does the stable step.
  [[nodiscard]] bool stiffness_varies() const;
  /// What a particle answers a small strain with (Pa, -).
  [[nodiscard]] Elastic stiffness(std::size_t particle) const;
  /// The same if its effective stress were a pressure in all directions (Pa, >= 0).
  [[nodiscard]] Elastic stiffness(std::size_t particle, double mean_stress) const;

  /// Makes the present stress that which the soil was found under: sets the laws' internal variables by it. Done when
  /// the object is made; to be done again once an initial stress has been found.
  void set_internal_variables();
  /// Each variable once, in the order of the soils.
  [[nodiscard]] std::vector<InternalField> internal_fields() const;

  /// v* = (v + dt M^-1 f) / (1 + damping dt).
  /// @param damping  mass-proportional viscous damping (1/s), >= 0; it slows what follows in the same step alike
  /// @throws SolidError if a particle is outside of the grid; std::invalid_argument if there are tractions but no
  /// particle spacing in the settings
  void predict(double dt, const PoreState& pore, const Loads& loads, double damping);

  /// Lets absorbing walls yield. Until then they are fixed, so that an initial state can be found; from then on they
  /// bear what they bore in the latest step, and resist what moves them: by a dashpot of the impedance of the drained
  /// soil at the wall (Lysmer and Kuhlemeyer 1969), and by a spring of the soil's stiffness over the absorbing depth,
  /// without which a change of load would move them for ever. If the stiffness varies, all three, and the times of the
  /// friction, are those of the present stress.
  /// @param water_mass  as in stable_step()
  void release_walls(std::span<const double> water_mass);

  /// Volumetric strain increment dt div v of the present grid velocity, projected (-), one per particle.
  void volumetric_strain(double dt, std::span<double> strain) const;

  /// dV = dt^2 V Pi D M^-1 D^T V Pi q: the volume change (m2) that a pore pressure change q (Pa) causes within the
  /// step. Symmetric and positive semidefinite in q.
  void volume_response(double dt, std::span<const double> q, std::span<double> volume_change) const;

  /// A bound of the diagonal of volume_response from above, no more than about three times it (m2/Pa): enough to
  /// scale an iterative solver with, for a fraction of the price.
  void volume_response_diagonal(double dt, std::span<double> diagonal) const;

  /// v += dt M^-1 D^T V Pi q.
  void correct(double dt, std::span<const double> q);

  /// Grid to particles, then strain, volume, porosity and effective stress (Jaumann rate, return mapping at the given
  /// suction, Pa; empty: zero).
  /// @throws SolidError
  void advance(double dt, std::span<const double> suction, const StepMode& mode = {});

  [[nodiscard]] const State& state() const { return state_; }
  /// Goes on from a state that one with the same grid and soils had.
  /// @throws std::invalid_argument if arrays differ in length, or the number of wall nodes is another
  void set_state(State state);
  [[nodiscard]] const Particles& particles() const { return state_.particles; }
  [[nodiscard]] Particles& particles() { return state_.particles; }
  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<Soil>& soils() const { return soils_; }
  [[nodiscard]] const Balance& balance() const { return state_.balance; }
  /// Reactions of the frictional walls in the latest step, one per node of theirs.
  [[nodiscard]] std::vector<WallReaction> wall_reactions() const;
  /// Brings all particles to rest.
  void stop();

  /// The same soil in the same state with strengths, those of frictional walls too, divided by a factor: whatever they
  /// are by suction and plastic strain. Laws with state keep theirs.
  /// @param factor  F (-), > 0; @param where  of each particle, whether it is weakened; empty: all soil and the walls
  [[nodiscard]] MaterialPointMethod weakened(double factor, std::span<const std::uint8_t> where = {}) const;

 private:
  struct ParticleWeights {
    std::size_t node = 0;       // the first of 3 x 3
    double dx = 0.0, dy = 0.0;  // from the particle to the first node (m)
    double nx[3], ny[3], gx[3], gy[3];
  };
  struct Node {
    Eigen::Array2d momentum, force;
    double mass;
  };
  // A particle behind a loaded face.
  struct Behind {
    std::size_t particle;
    double distance;  // of the face (m)
    double share;     // of the load
  };
  // Grid cells that hold particles.
  struct Cell {
    std::size_t corner;    // node at the lower left
    std::size_t particle;  // the first one, in cell_particles_
  };
  // The bilinear hat functions of the four corners of a particle's cell, at the particle.
  struct HatWeights {
    std::size_t corner = 0;         // the lower left node
    std::array<double, 4> value{};  // of it, of that to its right, and of the two above
  };
  // The hat function of a grid node, over the particles that it reaches.
  struct Hat {
    int column, row;
    std::size_t node, first;                  // its own node, and the first of the 5 x 5 around it
    double volume;                            // M_n: sum of N_n V over the particles
    std::array<Eigen::Array2d, 25> gradient;  // per node i, sum of N_n V G_i over M_n, wall conditions folded in
  };
  // A node on a wall that can move: one with friction, or absorbing. Beyond it the soil is the mirror image, turned
  // over, of the soil inside as seen from the moving node.
  struct WallNode {
    std::size_t outside = 0, on = 0, inside = 0;
    std::size_t number = 0;   // in wall_nodes_, and in the state
    std::size_t along = 0;    // number along the wall
    Eigen::Index normal = 0;  // axis
    double inwards = 1.0;     // sign of the inner normal along that axis
    Wall wall = Wall::friction;
    double image_mass = 0.0;                        // what the particles gave the node outside (kg/m)
    Eigen::Array2d share = Eigen::Array2d::Zero();  // of the momentum of the node inside that moves it (-)
    Eigen::Array2d mass = Eigen::Array2d::Zero();   // that it moves (kg/m)

    double friction = 0.0;     // coefficient (-)
    double gap = 0.0;          // to the soil (m)
    double water_force = 0.0;  // of the pore water on the wall (N/m)
    double beside = 0.0;       // sign of the inner normal of a wall with friction that it meets there, if it does
  };
  // Sums over the particles of a cell, weighted by volume.
  struct CellMeans {
    double volume = 0.0, distance = 0.0, pressure = 0.0;
  };
  // Sums over the particles near a node of a frictional wall.
  struct NearWall {
    double volume = 0.0, distance = 0.0, square = 0.0, pressure = 0.0, product = 0.0;  // weighted by volume
    double length = 0.0;                                                               // of wall (m)
  };
  // From grid to particles; restoring: what APIC loses of lasting motion is given back.
  enum class Transfer { apic, restoring_apic, flip };
  // What the loop over the particles needs of a soil, worked out once.
  struct Material {
    Material(const Soil& soil, double cell_size);
    Elastic elastic;
    double shear, bulk, lame;
    bool dilates;
    StrengthLaw strength;
    bool has_state = is_law_with_state(strength);  // elastic then says nothing; the three moduli are zero
  };

  void place_on_grid();
  template <class Shape>
  void find_weights();
  void sort_into_cells();
  template <class Visit>
  void for_each_in_bands(const std::vector<std::size_t>& bands, const Visit& visit) const;
  template <class Visit>
  void for_each_cell(const Visit& visit) const;
  PoreState less_outside(const PoreState& pore, const SurfacePressure& surface);
  void scatter(const PoreState& pore, const SurfacePressure& surface, const Eigen::Array2d& acceleration);
  void add_tractions(std::span<const ParticleTraction> tractions);
  void find_strip(const ParticleTraction& traction, double nx, double ny, double limit);
  void fold_walls();
  void hold_walls();
  void find_wall_nodes();
  void look_at_soil(std::span<const double> pressure);
  void look_at_soil(std::size_t first_node, std::span<const double> pressure);
  void move_walls(double dt);
  void find_friction_times();
  void resist_by_friction(double dt);
  void resist_by_friction(std::span<WallNode> stretch, double dt);
  void press(const WallNode& wall, double dt);
  void rub(const WallNode& wall, double limit, double dt);
  void respond(std::vector<Eigen::Array2d>& force) const;
  void unfold_walls();
  void update_velocity(double dt, double damping);
  void find_hats();
  void fold_walls(Hat& hat) const;
  void sum_over_hats(std::span<const double> q) const;
  void find_pressure_force(std::span<const double> q) const;
  void find_hat_divergence(const std::vector<Eigen::Array2d>& velocity) const;
  [[nodiscard]] double from_hats(std::size_t p) const;
  template <Transfer transfer>
  void gather(double dt, const StepMode& mode);
  void forget_losses();
  void remap_velocity();
  void update_stress(double dt, std::span<const double> suction, const StepMode& mode);
  template <bool shares_dilation>
  void strain_particles(double dt, std::span<const double> suction, const StepMode& mode);
  void yield_with_shared_dilation(std::span<const double> suction, const StepMode& mode);
  void bound_traction_between_soils(std::span<const double> suction);
  void update_with_state(double dt, std::span<const double> suction, const StepMode& mode);
  [[nodiscard]] std::span<double> internal_of(std::size_t p);
  [[nodiscard]] Elastic stiffness(std::size_t p, const SymmetricTensor& stress) const;
  [[nodiscard]] std::span<const std::size_t> particles_in(std::size_t cell) const;
  [[nodiscard]] bool holds_x_of(std::size_t p) const;
  [[nodiscard]] bool holds_y_of(std::size_t p) const;
  [[noreturn]] void refuse_place(std::size_t p) const;
  void check() const;
  [[nodiscard]] WallState& memory_of(const WallNode& wall) { return state_.walls[wall.number]; }
  [[nodiscard]] const WallState& memory_of(const WallNode& wall) const { return state_.walls[wall.number]; }

  Grid grid_;
  std::vector<Soil> soils_;
  std::vector<Material> materials_;
  std::size_t internal_count_ = 0;  // entries of a particle in Particles::internal
  Settings settings_;
  State state_;

  std::vector<double> placed_x_, placed_y_, placed_volume_;  // for which the particles were placed on the grid
  std::vector<ParticleWeights> weights_;
  std::vector<double> mass_;                 // of each particle, with its water (kg/m)
  std::vector<double> excess_;               // pore pressure less the pressure on the surface (Pa)
  std::vector<std::size_t> grid_cell_of_;    // of each particle
  std::vector<std::size_t> cell_start_;      // into cell_particles_, per grid cell
  std::vector<std::size_t> cell_particles_;  // particles by cell
  std::vector<Cell> cells_;                  // in grid order; one more at the end, for its first particle
  std::vector<std::size_t> bands_;           // first cell of each band of rows, see for_each_cell()

  std::size_t kinds_ = 0;  // of soil: those given at first; a weakened soil is of the kind of its own
  SoilFaces faces_;

  std::vector<HatWeights> hat_weights_;  // of each particle
  std::vector<std::size_t> hat_at_;      // index in hats_, per node
  std::vector<Hat> hats_;                // those that reach a particle, in grid order
  std::vector<std::size_t> hat_bands_;   // first hat of each band of rows

  static constexpr std::size_t base_side = 2;     // after left and right
  std::vector<WallNode> wall_nodes_;              // by side
  std::array<std::size_t, 4> first_wall_node_{};  // of each side, and the end
  std::array<bool, 2> corner_off_{};              // whether the soil is off the left or right side in its corner
  std::vector<NearWall> near_wall_;               // of each wall node
  std::vector<CellMeans> cell_means_;

  std::vector<Node> node_;
  std::vector<Eigen::Array2d> old_velocity_, velocity_;
  std::vector<char> beside_absorbing_wall_;  // of each grid cell: whether particles in it feel the wall's dashpots
  std::vector<Eigen::Array2d> response_;  // velocity per impulse: 1 / mass, slowed by the damping; 0 where a wall holds
  std::vector<std::array<double, 4>> velocity_gradient_;  // of each particle: dvx/dx, dvx/dy, dvy/dx, dvy/dy
  std::vector<Behind> strip_;                             // of the traction at hand
  // where soil may dilate: of each particle, the stress before it yields; the volumetric strain of its plastic flow,
  // and then its share of that around it
  bool shares_dilation_ = false;
  std::vector<SymmetricTensor> trial_stress_;
  std::vector<double> dilation_;
  // work space of the pressure's force and the divergence; it carries nothing from one call to the next
  mutable std::vector<Eigen::Array2d> pressure_force_;
  mutable std::vector<double> hat_value_;  // per node
};

}  // namespace slope::solid
