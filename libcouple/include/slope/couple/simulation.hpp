#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::couple {

/// Broken physics: names the time, the particle, the field and the value.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Components of a symmetric tensor in plane strain; xz and yz are zero.
struct PlaneTensor {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0;
};

/// The state of all particles at one time, in the order of their ids, SI units, tension positive,
/// pore pressure positive in compression.
struct ParticleTable {
  double time = 0.0;                          ///< since the start of the rain (s)
  std::vector<Point> position;                ///< (m)
  std::vector<Point> displacement;            ///< (m)
  std::vector<Point> velocity;                ///< of the skeleton, in physical time (m/s)
  std::vector<Point> darcy_velocity;          ///< w of Eq. 4 (m/s)
  std::vector<PlaneTensor> stress_effective;  ///< (Pa)
  std::vector<PlaneTensor> strain;            ///< accumulated (-)
  std::vector<double> deviatoric_strain;      ///< eps_q = sqrt(2/3 e:e) (-)
  std::vector<double> plastic_strain;         ///< accumulated deviatoric plastic strain (-)
  std::vector<double> pore_pressure;          ///< P_w (Pa)
  std::vector<double> suction;                ///< s = -P_w (Pa)
  std::vector<double> saturation;             ///< S_r (-)
  std::vector<double> porosity;               ///< n (-)
  std::vector<double> volume;                 ///< per metre of thickness (m2)
  std::vector<int> soil;                      ///< index into Case::soils
};

/// One column of the history or budget table.
struct HistoryColumn {
  std::string name;  ///< e.g. "A1 displacement"
  std::string unit;  ///< e.g. "m"; "-" if it has none
};

/// The particles whose deviatoric strain exceeds the case's threshold.
struct FailureZone {
  double length = 0.0;           ///< horizontal extent (m)
  double height = 0.0;           ///< vertical extent (m)
  double depth = 0.0;            ///< largest depth, normal to the ground surface at the start (m)
  double area = 0.0;             ///< (m2)
  double lowest = 0.0;           ///< y of its lowest point (m)
  double highest = 0.0;          ///< y of its highest point (m)
  double largest_suction = 0.0;  ///< left anywhere in the slope (Pa)
};

/// The soil that has moved by more than the onset displacement, and how far it ran. Unlike the failure zone, which is
/// the band that shears, this is the mass that slid, whatever the cell size.
struct Slide {
  double area = 0.0;                             ///< present volume per metre of thickness (m2)
  double direction = 0.0;                        ///< +1 to the right, -1 to the left, by its mean; 0: nothing slid
  double largest_horizontal_displacement = 0.0;  ///< of any particle (m), >= 0
  std::optional<Point> toe;  ///< first toe: lowest point of the face that it stood on, before the start (m); none:
                             ///< nothing slid, or the ground falls all the way to the side of the domain
  /// Advance of the ground line beyond its first toe, horizontally (m), >= 0: how much further than before the start
  /// the soil reaches that stood behind the first toe and above it, to its foremost particle that has another within
  /// two spacings; or further, as far as it has pushed up the ground ahead, by more than half a spacing and the onset
  /// displacement. Zero if nothing slid or what slid stays behind the toe; none: no toe.
  std::optional<double> run_out = 0.0;
  bool reaches_wall = false;  ///< the front has come to the last cell before the side of the domain
};

/// What a run says of the slope.
enum class Verdict {
  undecided,       ///< it stands so far, but the run has not come to its end
  stands,          ///< no onset of failure until the end
  fails,           ///< it stood before the start, and failed then
  does_not_stand,  ///< no balance was found before the start
  water_alone,     ///< the soil was not asked
};

/// Water that has crossed the boundary and been stored since the start, per metre of thickness (m3/m).
struct WaterBudget {
  double infiltration = 0.0;                  ///< in through all boundaries
  double outflow = 0.0;                       ///< out through all boundaries
  double storage = 0.0;                       ///< change of what the pores hold
  double error = 0.0;                         ///< (infiltration - outflow - storage) / max(infiltration, outflow) (-)
  std::map<std::string, double> by_boundary;  ///< net inflow of each named boundary (m3/m)
  // of the free surface, where the case has rain; rain = rain_infiltration + run_off
  double rain = 0.0;               ///< what fell
  double rain_infiltration = 0.0;  ///< of it into the soil
  double run_off = 0.0;            ///< of it along the ground and away
  double seepage = 0.0;            ///< out of the soil, as water
  double evaporation = 0.0;        ///< out of the soil, into the air
};

/// What a progress line shows.
struct Progress {
  double time = 0.0;                  ///< simulated (s)
  double share = 0.0;                 ///< of the run that is done (-), in [0, 1]
  double clock_factor = 1.0;          ///< physical time over the solid's own time (-)
  double largest_displacement = 0.0;  ///< (m)
  std::size_t steps = 0;
  WaterBudget water;  ///< since the start
};

/// How far the search for the state before the start has come.
struct InitialProgress {
  std::string stage;     ///< "steady flow", "elastic stress" or "stress"
  double measure = 0.0;  ///< of what still changes: of the pressures in a step (Pa), or unbalanced over gravity forces
  double wanted = 0.0;   ///< the measure at which the stage ends, in the same unit
  double step_time = 0.0;  ///< of steady flow: the length of the step (s), which has to become long
};

/// Is told the progress every now and then, and answers whether to go on.
using InitialObserver = std::function<bool(const InitialProgress&)>;

/// When the largest displacement passed a value.
struct DisplacementTime {
  double displacement = 0.0;   ///< (m)
  std::optional<double> time;  ///< (s); none: it did not
};

struct Summary {
  std::string end_reason;  ///< "time", "displacement", "after_onset", "at_rest", or "running"
  Verdict verdict = Verdict::undecided;
  bool stands_before = true;                 ///< a balance was found before the start, or none was asked for
  double time = 0.0;                         ///< simulated (s)
  double onset_criterion = 0.0;              ///< displacement that counts as failure (m)
  std::optional<double> onset_time;          ///< by the criterion that the case chose (s); none: no failure
  std::optional<double> displacement_onset;  ///< the largest displacement passed onset_criterion (s)
  std::optional<double> runaway_onset;       ///< the motion ran away: the kink of the displacement (s)
  Point onset_position{0.0, 0.0};            ///< where the largest displacement was when the onset was found (m)
  std::vector<DisplacementTime> displacement_times;  ///< 1, 2, 5, 10, 30 and 100 cm
  std::optional<FailureZone> zone_at_onset;          ///< when the onset was found
  std::optional<FailureZone> zone_at_10_cm;          ///< at a largest displacement of 10 cm
  FailureZone zone_at_end;
  std::optional<Slide> slide_at_10_cm;  ///< at a largest displacement of 10 cm
  Slide slide_at_end;
  WaterBudget water;
  double largest_displacement = 0.0;      ///< (m)
  double pressure_checkerboard = 0.0;     ///< largest over the run, of the measure defined in README (-)
  double initial_head_flux = 0.0;         ///< largest Darcy flux of the head operator before the rain, over k (-)
  double initial_unbalanced_ratio = 0.0;  ///< unbalanced over gravity forces left by the initial state (-)
  double largest_unbalanced_ratio = 0.0;  ///< unbalanced forces over the weight while the water's time ran ahead (-)
  std::size_t particles = 0;
  std::size_t steps = 0;
  double mean_pressure_iterations = 0.0;
  std::size_t unsettled_steps = 0;  ///< whose pressures were taken as they were after the last iteration allowed
};

/// What advance() came to.
struct Event {
  bool history = false;   ///< a history row is due: ask history_row()
  bool snapshot = false;  ///< a particle file is due: ask particles()
  std::string label;      ///< of the snapshot: "onset", "end", or empty
  bool finished = false;  ///< the run is over
};

/// A case being run: both solvers, the exchange between them, and the clock.
class Simulation {
 public:
  /// Fills the regions with particles and builds both solvers.
  /// @param threads  >= 1; the result does not depend on it.
  /// @throws InputError if the case cannot be set up.
  explicit Simulation(Case input, int threads = 1);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Initial pore pressure and self-weight stress at fixed positions; time is zero afterwards.
  /// @param observer  none: it goes on to the end. @return whether it did; if not, the state is readable as it was left
  /// @throws SimulationError when the physics breaks or no steady flow is found.
  bool initialise(const InitialObserver& observer = {});
  /// Steps until something is due, or at most a few hundred steps.
  /// @throws SimulationError when the physics breaks; the state before the step stays readable.
  Event advance();

  [[nodiscard]] const Case& input() const;
  [[nodiscard]] Progress progress() const;
  [[nodiscard]] ParticleTable particles() const;
  [[nodiscard]] std::vector<HistoryColumn> history_columns() const;  ///< the first is the time (s)
  [[nodiscard]] std::vector<double> history_row() const;
  /// The water's books, due with the history (m3/m): cumulative, from the start.
  [[nodiscard]] static std::vector<HistoryColumn> budget_columns();  ///< the first is the time (s)
  [[nodiscard]] std::vector<double> budget_row() const;
  [[nodiscard]] Summary summary() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slope::couple
