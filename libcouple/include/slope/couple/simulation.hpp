#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "slope/couple/case.hpp"
#include "slope/couple/state.hpp"
#include "slope/couple/summary.hpp"

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
  /// What the strength laws keep, such as preconsolidation_pressure (Pa); empty if none keeps anything.
  std::vector<solid::InternalField> internal;
};

/// One column of the history or budget table.
struct HistoryColumn {
  std::string name;  ///< e.g. "A1 displacement"
  std::string unit;  ///< e.g. "m"; "-" if it has none
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
  double step_time = 0.0;                ///< of steady flow: the length of the step (s), which has to become long
  std::string search = "initial state";  ///< or "factor of safety": what is searched for
};

/// Is told the progress every now and then, and answers whether to go on.
using InitialObserver = std::function<bool(const InitialProgress&)>;

/// What advance() came to.
struct Event {
  bool history = false;   ///< a history row is due: ask history_row()
  bool snapshot = false;  ///< a particle file is due: ask particles()
  std::string label;      ///< of the snapshot: "onset", "end", or empty
  bool finished = false;  ///< the run is over
};

/// How a slope would flow with the least reduction of its strength that it does not bear: of each particle, shares of
/// the largest (-), in [0, 1].
struct Mechanism {
  std::vector<double> speed;
  std::vector<double> shear_strain;  ///< deviatoric, of the flow in a moment
};

/// A case being run: both solvers, the exchange between them, and the clock. What it is between two steps is its State;
/// a copy goes on as the original does, to the last bit, and so does one that is made from the case and the state.
class Simulation {
 public:
  using State = SimulationState;

  /// Fills the regions with particles and builds both solvers.
  /// @param threads  >= 1; the result does not depend on it.
  /// @throws InputError if the case cannot be set up.
  explicit Simulation(Case input, int threads = 1);
  /// Goes on from a state, with the case that it comes from or one that differs from it: other boundary conditions,
  /// loads, outputs or ends, and the same ground, walls and soils. Instead of initialise(). Histories and snapshots
  /// that lie before the state's time are taken as done; ramps of pressures begin at those before the start.
  /// @throws InputError if the state is of another ground, or later than the end of the case
  Simulation(Case input, State state, int threads = 1);
  ~Simulation();
  Simulation(const Simulation& other);
  Simulation& operator=(const Simulation& other);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Initial pore pressure and self-weight stress at fixed positions; time is zero afterwards.
  /// @param observer  none: it goes on to the end. @return whether it did; if not, the state is readable as it was left
  /// @throws SimulationError when the physics breaks or no steady flow is found.
  bool initialise(const InitialObserver& observer = {});
  /// Steps until something is due, or at most a few hundred steps. A step that breaks is tried again from its start
  /// with a half, a quarter and an eighth of its length.
  /// @throws SimulationError when the physics breaks all the same; the state is that before the step.
  Event advance();
  /// All that the slope is now.
  [[nodiscard]] State state() const;

  /// Whether the case asks for the factor of safety at the present time, and it has not been found.
  [[nodiscard]] bool asks_for_safety() const;
  /// Finds the factor of safety by strength reduction, of the slope and its water as they are now, and adds it to the
  /// summary's. Strengths that plastic strain has softened are reduced from what is left of them. Water alone in
  /// scheme: seepage: the stress under its pressures is found first.
  /// @param observer  none: it goes on to the end. @return none if it was not to
  /// @throws SimulationError when the physics breaks
  std::optional<Mechanism> find_safety(const InitialObserver& observer = {});

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
  struct Run;
  std::unique_ptr<Run> run_;
};

}  // namespace slope::couple
