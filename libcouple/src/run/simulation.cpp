#include "slope/couple/simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulation_run.hpp"
#include "slope/couple/water_amounts.hpp"
#include "slope/solid/tensor.hpp"
#include "turn_back.hpp"

namespace slope::couple {

namespace {

constexpr std::array history_amounts{water_amounts::infiltration, water_amounts::outflow, water_amounts::storage};

}  // namespace

Simulation::Simulation(Case input, int threads)
    : run_(std::make_unique<Run>(std::move(input), std::nullopt, threads)) {}
Simulation::Simulation(Case input, State state, int threads)
    : run_(std::make_unique<Run>(std::move(input), state.mirrored, threads)) {
  run_->set_state(std::move(state));
}
Simulation::~Simulation() = default;
Simulation::Simulation(const Simulation& other) : run_(std::make_unique<Run>(*other.run_)) {}
Simulation& Simulation::operator=(const Simulation& other) {
  if (this != &other) run_ = std::make_unique<Run>(*other.run_);
  return *this;
}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

bool Simulation::initialise(const InitialObserver& observer) {
  const InitialObserver to_the_end = [](const InitialProgress&) { return true; };
  try {
    return run_->find_initial_state(observer ? observer : to_the_end);
  } catch (const solid::SolidError& error) {
    throw SimulationError("before the start: soil " + run_->text_of(error) +
                          "; the weight may be too much for the stiffness, youngs_modulus (of modified_cam_clay "
                          "kappa and minimum_mean_stress)");
  } catch (const seepage::SeepageError& error) {
    throw SimulationError(std::string("before the start: pore water, ") + error.what());
  }
}

Event Simulation::advance() {
  Run& s = *run_;
  Event event;
  for (int k = 0; k < Run::steps_per_call && !s.finished(); ++k) {
    const bool stood = !s.now.result.onset_time;
    s.step_or_try_again();
    const Run::Due due = s.take_due();
    event.history = due.history || s.finished();
    event.snapshot = due.snapshot;
    if (stood && s.now.result.onset_time) {
      event.snapshot = true;
      event.label = "onset";
    }
    if (event.history || event.snapshot) break;
  }
  if (s.finished()) {
    event.finished = true;
    event.snapshot = true;
    if (event.label.empty()) event.label = "end";
  }
  if (event.snapshot) s.measure_pressure();
  return event;
}

bool Simulation::asks_for_safety() const {
  return run_->asks_for_safety();
}

std::optional<Mechanism> Simulation::find_safety(const InitialObserver& observer) {
  const InitialObserver to_the_end = [](const InitialProgress&) { return true; };
  try {
    return run_->find_safety(observer ? observer : to_the_end);
  } catch (const solid::SolidError& error) {
    throw SimulationError("factor of safety: soil " + run_->text_of(error));
  }
}

SimulationState Simulation::state() const {
  return run_->state();
}

const Case& Simulation::input() const {
  return run_->given;
}

Progress Simulation::progress() const {
  const Run& s = *run_;
  double share = s.now.time / s.input.stop.time;
  if (s.input.stop.displacement < never)
    share = std::max(share, s.now.largest_displacement / s.input.stop.displacement);
  if (s.now.result.onset_time && s.input.stop.after_onset < never) {
    share = std::max(share, s.now.time / (*s.now.result.onset_time + s.input.stop.after_onset));
  }
  return {s.now.time,  std::min(share, 1.0), s.now.clock_factor, s.now.largest_displacement,
          s.now.steps, s.water_budget()};
}

ParticleTable Simulation::particles() const {
  const Run& s = *run_;
  const solid::Particles& soil = s.mixture.soil.particles();
  const std::size_t n = soil.size();
  ParticleTable table;
  table.time = s.now.time;
  std::vector<double> wx(n), wy(n);
  s.mixture.water.darcy_velocity(s.mixture.skeleton(), wx, wy);
  for (std::size_t p = 0; p < n; ++p) {
    table.position.push_back({soil.x[p], soil.y[p]});
    table.displacement.push_back({soil.ux[p], soil.uy[p]});
    table.velocity.push_back({soil.vx[p] / s.now.clock_factor, soil.vy[p] / s.now.clock_factor});
    table.darcy_velocity.push_back({wx[p], wy[p]});
    table.stress_effective.push_back({soil.sxx[p], soil.syy[p], soil.szz[p], soil.sxy[p]});
    table.strain.push_back({soil.exx[p], soil.eyy[p], 0.0, soil.exy[p]});
    table.deviatoric_strain.push_back(deviatoric_strain_of(soil, p));
  }
  table.plastic_strain = soil.plastic_strain;
  const auto copy = [](std::span<const double> from) { return std::vector<double>(from.begin(), from.end()); };
  table.pore_pressure = copy(s.mixture.water.pressure());
  table.suction = copy(s.mixture.water.suction());
  table.saturation = copy(s.mixture.water.saturation());
  table.porosity = soil.porosity;
  table.volume = soil.volume;
  table.soil = s.particles.soil;
  table.internal = s.mixture.soil.internal_fields();
  turn_back(s.frame, table);
  return table;
}

std::vector<HistoryColumn> Simulation::history_columns() const {
  std::vector<HistoryColumn> columns{{"time", "s"},
                                     {"clock factor", "-"},
                                     {"largest displacement", "m"},
                                     {"kinetic ratio", "-"},
                                     {"unbalanced ratio", "-"}};
  for (const WaterAmount& amount : history_amounts) {
    columns.push_back({"water " + std::string(amount.phrase), std::string(amount.unit)});
  }
  for (const VerificationPoint& point : run_->input.points) {
    columns.push_back({point.name + " displacement", "m"});
    columns.push_back({point.name + " suction", "Pa"});
  }
  return columns;
}

std::vector<double> Simulation::history_row() const {
  const Run& s = *run_;
  const solid::Particles& soil = s.mixture.soil.particles();
  const solid::Balance& balance = s.mixture.soil.balance();
  double elastic_energy = 0.0;
  for (std::size_t p = 0; p < soil.size(); ++p) {
    const solid::Elastic elastic = s.mixture.soil.stiffness(p);
    const solid::SymmetricTensor stress{soil.sxx[p], soil.syy[p], soil.szz[p], soil.sxy[p]};
    const double mean = solid::trace(stress) / 3.0;
    elastic_energy += soil.volume[p] * (0.5 * mean * mean / elastic.bulk_modulus() +
                                        0.5 * solid::second_invariant(stress) / elastic.shear_modulus());
  }
  const auto ratio = [](double a, double b) { return b > 0.0 ? a / b : 0.0; };
  std::vector<double> row{s.now.time, s.now.clock_factor, s.now.largest_displacement,
                          ratio(balance.kinetic_energy, elastic_energy),
                          ratio(balance.unbalanced_force, balance.weight)};
  const WaterBudget water = s.water_budget();
  for (const WaterAmount& amount : history_amounts) row.push_back(water.*amount.value);
  for (const std::size_t p : s.followed) {
    row.push_back(std::hypot(soil.ux[p], soil.uy[p]));
    row.push_back(s.mixture.water.suction()[p]);
  }
  return row;
}

std::vector<HistoryColumn> Simulation::budget_columns() {
  std::vector<HistoryColumn> columns{{"time", "s"}};
  const auto add = [&columns](const WaterAmount& amount) {
    columns.push_back({std::string(amount.name), std::string(amount.unit)});
  };
  for (const WaterAmount& amount : water_amounts::all) add(amount);
  add(water_amounts::balance_error);
  return columns;
}

std::vector<double> Simulation::budget_row() const {
  const WaterBudget water = run_->water_budget();
  std::vector<double> row{run_->now.time};
  for (const WaterAmount& amount : water_amounts::all) row.push_back(water.*amount.value);
  row.push_back(water.*water_amounts::balance_error.value);
  return row;
}

Summary Simulation::summary() const {
  const Run& s = *run_;
  Summary summary = s.now.result;
  summary.time = s.now.time;
  summary.verdict = s.verdict();
  summary.zone_at_end = s.zone();
  summary.slide_at_end = s.slide();
  turn_back(s.frame, summary);
  summary.largest_displacement = s.now.largest_displacement;
  summary.steps = s.now.steps;
  summary.mean_pressure_iterations =
      s.now.steps == 0 ? 0.0 : static_cast<double>(s.now.pressure_iterations) / static_cast<double>(s.now.steps);
  summary.water = s.water_budget();
  summary.unbalanced_limit = s.input.clock.unbalanced_limit;
  s.scheme.tell(summary);
  return summary;
}

}  // namespace slope::couple
