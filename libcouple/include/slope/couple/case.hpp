#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "slope/seepage/soil.hpp"
#include "slope/solid/soil.hpp"

namespace slope::couple {

/// A point of the vertical plane: x to the right (m), y upwards (m).
using Point = std::array<double, 2>;

inline constexpr double never = std::numeric_limits<double>::infinity();

/// How particles fill the squares of the lattice that an outline cuts: not at all or whole, or by what is inside.
enum class SurfaceParticles { lattice, clipped };

/// The background grid. Its sides are the walls; the top is open.
struct Domain {
  Point lower{0.0, 0.0};       ///< lower left corner (m)
  Point upper{0.0, 0.0};       ///< upper right corner (m); each side a whole number of cells
  double cell_size = 0.0;      ///< (m), > 0
  int particles_per_cell = 4;  ///< 1, 4, 9 or 16: a square lattice in each cell
  SurfaceParticles surface_particles = SurfaceParticles::clipped;
};

enum class Wall { free, roller, fixed, friction, absorbing };

struct Walls {
  Wall left = Wall::roller;
  Wall right = Wall::roller;
  Wall base = Wall::fixed;
  std::optional<double> left_friction, right_friction, base_friction;  ///< coefficient of a wall with friction (-)
  std::optional<double> absorbing_depth;  ///< how far the soil goes on behind an absorbing wall until it is fixed (m)
};

/// One named soil: what each solver needs of it.
struct Soil {
  std::string name;
  solid::Soil solid;
  seepage::Soil seepage;
  double porosity = 0.0;  ///< initial n (-), in (0, 1)
};

/// A polygon filled with one soil. Later regions overwrite earlier ones.
struct Region {
  std::size_t soil = 0;  ///< index into Case::soils
  std::vector<Point> polygon;
};

/// Hydrostatic pressure below and suction above a level water table.
struct HydrostaticWater {
  double water_table = 0.0;        ///< y of P_w = 0 (m)
  double maximum_suction = never;  ///< cap of the suction (Pa), >= 0
};
/// Hydrostatic pressure below and suction above a water table given as a line, column by column. Where the line is
/// inclined this is not at rest: it begins to flow.
struct WaterTable {
  std::vector<Point> points;       ///< from left to right (m), x ascending; level beyond the first and the last
  double maximum_suction = never;  ///< cap of the suction (Pa), >= 0

  /// y of P_w = 0 (m)
  [[nodiscard]] double height_at(double x) const;
};
/// The same pore pressure everywhere (Pa, positive in compression).
struct UniformWater {
  double pressure = 0.0;
};
/// Steady seepage under the water boundaries that hold before the rain (those with `initial: true`).
struct SteadyWater {
  double water_table = 0.0;  ///< y of P_w = 0 in the first guess (m)
};
using InitialWater = std::variant<HydrostaticWater, WaterTable, UniformWater, SteadyWater>;

/// How the effective stress before the start is found. `k0`: the vertical one from the weight of the column above, the
/// horizontal ones in a given ratio to it.
enum class InitialStress { self_weight, k0, none };

/// The particles that a condition acts on, chosen at the start and followed as they move; those of the free surface are
/// found anew as the soil moves.
enum class Place { ground_surface, base, left, right, free_surface };

struct PlaceRange {
  Place place = Place::ground_surface;
  double from = -never;  ///< x (surface, base) or y (left, right) range (m)
  double to = never;
};

/// A value at a time (s).
struct TimedValue {
  double time = 0.0;
  double value = 0.0;
};

/// A value that changes with time: linear between its points, constant before the first and after the last.
struct TimeSeries {
  std::vector<TimedValue> points{{}};  ///< times ascending, at least one

  [[nodiscard]] double at(double time) const;
  /// Slope just after a time (1/s).
  [[nodiscard]] double rate_after(double time) const;
  [[nodiscard]] double highest() const;
};

/// A pressure (or head) that is prescribed on particles.
struct PrescribedPressure {
  TimeSeries pressure;                   ///< P_w at the particle or face (Pa)
  std::optional<TimeSeries> total_head;  ///< if given, h = P_w/gamma_w + y (m) is prescribed instead
  bool at_face = true;                   ///< false: in the particle, half a spacing inside the ground
};
/// A flux into the soil per area of the particles' face (m/s), positive inwards.
struct PrescribedFlux {
  TimeSeries flux;
};
/// Water leaves downwards by its own weight, as if the soil went on for ever below and the water table were far down.
struct FreeDrainage {};

/// Rain from a time on (s), per horizontal metre (m/s); negative: what the air could evaporate.
struct RainStep {
  double time = 0.0;
  double intensity = 0.0;
};

/// Rain on the free surface. What the soil cannot take runs off; where water comes out, it leaves; none is sucked in.
struct Rain {
  std::vector<RainStep> hyetograph;    ///< times ascending; no rain before the first
  double ponding_depth = 0.0;          ///< of the water that stays on the ground when rain runs off (m), >= 0
  double evaporation_limit = 1.0e5;    ///< suction to which the air dries the surface (Pa), > 0
  std::optional<double> before_start;  ///< intensity in the steady state before the start (m/s); none: the first one
};

/// Water that stands on the free surface. Below its level the face bears its pressure, and the soil its weight; above
/// it the surface is a seepage face, or takes the rain that falls there.
struct Reservoir {
  TimeSeries level;  ///< y of the water's surface (m)
};

struct WaterBoundary {
  std::string name;
  PlaceRange where;
  std::variant<PrescribedPressure, PrescribedFlux, FreeDrainage, Rain, Reservoir> condition;
  double start = 0.0;    ///< time from which it holds (s)
  double ramp = 0.0;     ///< time over which it goes linearly from what is there to the prescribed value (s)
  bool initial = false;  ///< holds before the start too: in the steady flow, and a reservoir's weight in the stress
};

/// A pseudo-static earthquake: a body force on soil and water, in shares of their weight. One that acts in full from
/// the start on is in the initial stress.
struct Seismic {
  double horizontal_coefficient = 0.0;  ///< k_h (-), positive towards +x
  double vertical_coefficient = 0.0;    ///< k_v (-), positive upwards
  double start = 0.0;                   ///< time from which it acts (s)
  double ramp = 0.0;                    ///< time over which it grows linearly (s)
};

/// A traction (Pa; x and y components) on the particles of a place; on the ground surface and the base per horizontal
/// metre, on a side per vertical one.
struct Traction {
  std::string name;
  PlaceRange where;
  Point traction{0.0, 0.0};
  double start = 0.0;
  double ramp = 0.0;
};

enum class Scheme { semi_implicit, explicit_two_pass, seepage };
enum class Skeleton { deformable, rigid };
enum class MixtureDensity { by_saturation, saturated };
enum class ShapeFunction { quadratic_bspline, linear };

struct Numerics {
  ShapeFunction shape_function = ShapeFunction::quadratic_bspline;
  std::optional<double> flip_fraction;  ///< none: APIC; else the FLIP share in [0, 1] of a FLIP/PIC blend
  double courant_number = 0.8;          ///< dt over cell size / P-wave speed, in (0, 1)
  double pressure_tolerance = 5.0e-2;   ///< residual reduction of the pressure step, in (0, 1)
  double smoothing_length = 1.2;        ///< SPH smoothing length over particle spacing, in [1, 2]
};

/// How much faster than the solid's own clock physical time may run.
struct Clock {
  bool adaptive = true;              ///< false: real time throughout
  double unbalanced_limit = 1.0e-5;  ///< unbalanced forces over the weight (-), > 0: below it the factor grows, above
                                     ///< 1.5 times it the factor falls. It grows with the change of the pore pressures
                                     ///< since the start once that is, in the mean, above 1 % of the overburden
  double maximum_factor = 1.0e9;     ///< largest factor (-), >= 1
};

/// What counts as the onset of failure: the largest displacement passes a value, or the motion runs away.
enum class Onset { displacement, runaway };

/// When the run ends; the first that is met.
struct Stop {
  double time = 0.0;            ///< (s), > 0
  double displacement = never;  ///< largest displacement (m)
  double after_onset = never;   ///< time after the onset of failure (s)
  bool at_rest = false;         ///< when the slide has come to rest after its onset
};

/// A point of the initial geometry whose nearest particle is followed.
struct VerificationPoint {
  std::string name;
  Point position{0.0, 0.0};
};

struct Output {
  std::vector<double> snapshots;     ///< times of the particle files (s), those of the figures among them; start,
                                     ///< onset and end are always written
  double snapshot_interval = never;  ///< (s)
  double history_interval = 1.0;     ///< (s), > 0; not given: a thousandth of stop.time, but 1 s at least
};

/// When the factor of safety is asked for, and of what.
struct SafetyQuestions {
  std::vector<double> times;  ///< (s), >= 0
  double interval = never;    ///< at every multiple of this as well, from the start on (s), > 0
  double tolerance = 0.005;   ///< width of the bracket around the factor, over the factor (-), in (0, 1)
  std::vector<Point> within;  ///< polygon in which strength is reduced, at the positions of the start (m); empty: all
};

/// What slope-render draws beside the standard pictures.
struct Figures {
  std::vector<double> profile_times;  ///< times of suction-against-height profiles (s); empty: no profile figure
  std::string profile_reference;      ///< CSV with columns z_m and suction_head_m_t<time>; path relative to the case;
                                      ///< may be empty
  std::vector<double> contour_times;  ///< times of contour pictures (s); empty: start, onset and end
};

/// Everything that a run needs, in SI units. Built from YAML by read_case().
struct Case {
  std::string path;  ///< file it was read from
  std::string title;
  double gravity = 9.81;  ///< (m/s2), > 0
  Domain domain;
  Walls walls;
  std::vector<Soil> soils;
  std::vector<Region> regions;
  seepage::Water water;
  InitialWater initial_water;
  InitialStress initial_stress = InitialStress::self_weight;
  std::optional<double> k0_coefficient;  ///< horizontal over vertical effective stress (-); none: 1 - sin(phi') (Jaky)
  std::vector<WaterBoundary> water_boundaries;
  std::vector<Traction> tractions;
  Seismic seismic;
  Scheme scheme = Scheme::semi_implicit;
  Skeleton skeleton = Skeleton::deformable;
  MixtureDensity mixture_density = MixtureDensity::by_saturation;
  Numerics numerics;
  Clock clock;
  Onset onset = Onset::displacement;
  double onset_displacement = 0.02;   ///< largest displacement at which the slope has failed, or by which it grows when
                                      ///< the motion runs away; and what has moved by more has slid (m), > 0
  double failure_zone_strain = 0.02;  ///< deviatoric strain threshold (-), > 0
  Stop stop;
  std::vector<VerificationPoint> points;
  Output output;
  Figures figures;
  SafetyQuestions safety;
};

}  // namespace slope::couple
