#include "slope/couple/simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "boundary_conditions.hpp"
#include "checkerboard.hpp"
#include "clock_control.hpp"
#include "failure.hpp"
#include "initial_state.hpp"
#include "mixture.hpp"
#include "scheme.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/solid/tensor.hpp"

namespace slope::couple {

namespace {

constexpr std::array displacement_marks{0.01, 0.02, 0.05, 0.10, 0.30, 1.00};  // m
constexpr double zone_mark = 0.10;   // m: displacement at which the failure zone is reported for comparison
constexpr int steps_per_call = 200;  // after which advance() returns even if nothing is due
constexpr double sliver = 1.0e-6;    // share of a step by which two times may differ and be the same

InitialParticles fill(const Case& input) {
  InitialParticles particles = fill_regions(input.domain, input.regions);
  if (particles.x.empty()) {
    throw InputError(
        {{input.path, 0, "geometry", "no particle lies inside the polygons; make them larger than a cell"}});
  }
  return particles;
}

SlopeScale scale_of(const Case& input, const InitialParticles& particles, const Mixture& mixture) {
  SlopeScale scale;
  const auto [low, high] = std::ranges::minmax(particles.y);
  scale.height = high - low + particles.spacing;
  scale.wave_speed = input.domain.cell_size / mixture.soil.stable_step(1.0, mixture.water_mass());
  scale.gravity = input.gravity;
  double mass = 0.0, volume = 0.0;
  for (std::size_t p = 0; p < particles.x.size(); ++p) {
    mass += mixture.soil.particles().solid_mass[p] + mixture.water_mass()[p];
    volume += particles.volume[p];
  }
  scale.overburden = mass / volume * input.gravity * scale.height;
  return scale;
}

std::size_t nearest_particle(const InitialParticles& particles, const Point& point) {
  std::size_t nearest = 0;
  double least = never;
  for (std::size_t p = 0; p < particles.x.size(); ++p) {
    const double distance = std::hypot(particles.x[p] - point[0], particles.y[p] - point[1]);
    if (distance < least) {
      least = distance;
      nearest = p;
    }
  }
  return nearest;
}

}  // namespace

struct Simulation::State {
  State(Case c, int threads)
      : input(std::move(c)),
        particles(fill(input)),
        mixture(input, particles, initial_pressure(input, particles), threads),
        scale(scale_of(input, particles, mixture)),
        conditions(input, particles),
        scheme(make_scheme(input)),
        clock(clock_limits(scheme, input, mixture), scale, conditions.change_times()),
        surface(particles, particles_at({}, particles)),
        time_step(stable_step(scheme, mixture, input.numerics.courant_number)),
        snapshot_times(input.output.snapshots) {
    for (const VerificationPoint& point : input.points) followed.push_back(nearest_particle(particles, point.position));
    for (const double mark : displacement_marks) result.displacement_times.push_back({mark, {}});
    for (double t = input.output.snapshot_interval; t < input.stop.time; t += input.output.snapshot_interval) {
      snapshot_times.push_back(t);
    }
    std::erase_if(snapshot_times, [](double t) { return t <= 0.0; });  // the start is always there
    std::ranges::sort(snapshot_times);
    result.end_reason = "running";
    result.onset_criterion = input.onset_displacement;
    result.particles = particles.x.size();
  }

  bool find_initial_state(const InitialObserver& go_on);
  void step();
  seepage::SolveReport step_mixture(double next);
  seepage::SolveReport step_water(SeepageScheme& seepage, double next);
  [[nodiscard]] WaterBudget water_budget() const;
  void observe_water();
  void observe_displacement();
  void check_end();
  void measure_pressure() {
    result.pressure_checkerboard =
        std::max(result.pressure_checkerboard,
                 pressure_checkerboard(mixture.water.head_operator(), mixture.skeleton(), mixture.water.pressure()));
  }
  [[nodiscard]] double history_time(std::size_t row) const {
    return static_cast<double>(row) * input.output.history_interval;
  }
  [[nodiscard]] bool due(double t) const { return t <= time + sliver * time_step; }
  [[nodiscard]] double next_stop() const;
  [[nodiscard]] FailureZone zone() const {
    return find_failure_zone(mixture.soil.particles(), mixture.water.suction(), surface, particles.spacing,
                             input.failure_zone_strain, input.onset_displacement);
  }

  Case input;
  InitialParticles particles;
  Mixture mixture;
  SlopeScale scale;
  BoundaryConditions conditions;
  AnyScheme scheme;
  ClockControl clock;
  GroundSurface surface;
  double time_step;          // of the soil, at most (s)
  double latest_step = 0.0;  // of the water's time (s)
  Actions actions;
  std::vector<std::size_t> followed;  // particle of each verification point

  double time = 0.0;
  double clock_factor = 1.0;
  double largest_displacement = 0.0;
  std::size_t farthest_particle = 0;
  std::size_t steps = 0;
  std::size_t pressure_iterations = 0;
  std::size_t history_rows = 1;  // due so far; the first is that of the start
  std::vector<double> snapshot_times;
  std::size_t next_snapshot = 0;
  bool onset_snapshot_due = false;
  bool finished = false;
  double first_storage = 0.0;
  Summary result;
};

// The earliest time after the present one at which something is due.
double Simulation::State::next_stop() const {
  double next = std::min(input.stop.time, clock.next_change(time + sliver * time_step));
  next = std::min(next, history_time(history_rows));
  next = std::min(next, conditions.next_change(time + sliver * time_step));
  if (next_snapshot < snapshot_times.size()) next = std::min(next, snapshot_times[next_snapshot]);
  if (result.onset_time) next = std::min(next, *result.onset_time + input.stop.after_onset);
  return next;
}

void Simulation::State::step() {
  const double next = next_stop();
  auto* seepage = std::get_if<SeepageScheme>(&scheme);
  const auto report = seepage != nullptr ? step_water(*seepage, next) : step_mixture(next);
  ++steps;
  pressure_iterations += static_cast<std::size_t>(report.iterations);
  if (!report.converged) ++result.unsettled_steps;
  observe_water();
  observe_displacement();
  check_end();
}

seepage::SolveReport Simulation::State::step_mixture(double next) {
  const ClockControl::Pace pace = clock.pace(time, next, time_step, conditions.prescribed_rate(time));
  clock_factor = pace.factor;
  if (pace.velocity_scale < 1.0) mixture.slow_down(pace.velocity_scale);
  const double water_step = pace.factor * pace.time_step;
  // the last step up to what is due ends there to the last digit
  const double after = time + (1.0 + sliver) * water_step > next ? next : time + water_step;
  conditions.apply(after, mixture, actions);
  const auto report =
      std::visit([&](auto& s) { return s.step(mixture, actions, pace.time_step, pace.factor); }, scheme);
  time = after;
  latest_step = water_step;
  const solid::Particles& soil = mixture.soil.particles();
  clock.observe(pace.time_step, soil.ux, soil.uy, mixture.water.pressure());
  return report;
}

seepage::SolveReport Simulation::State::step_water(SeepageScheme& seepage, double next) {
  for (;;) {
    time_step = seepage.pace(time, next);
    const double after = time + (1.0 + sliver) * time_step > next ? next : time + time_step;
    conditions.apply(after, mixture, actions);
    const auto report = seepage.step(mixture, actions, time_step, clock_factor);
    if (!report.converged) continue;
    time = after;
    latest_step = time_step;
    return report;
  }
}

void Simulation::State::observe_water() {
  const double water_step = latest_step;
  const std::span<const double> rate = mixture.water.inflow_rate();
  WaterBudget& water = result.water;
  for (std::size_t b = 0; b < rate.size(); ++b) {
    water.by_boundary[conditions.names()[b]] += rate[b] * water_step;
    if (!conditions.is_open(b)) {
      (rate[b] > 0.0 ? water.infiltration : water.outflow) += std::abs(rate[b]) * water_step;
    }
  }
  const seepage::AirFlow& air = mixture.water.air_flow();
  water.rain += air.rain * water_step;
  water.rain_infiltration += air.infiltration * water_step;
  water.run_off += air.run_off * water_step;
  water.seepage += air.seepage * water_step;
  water.evaporation += air.evaporation * water_step;
  water.infiltration += air.infiltration * water_step;
  water.outflow += (air.seepage + air.evaporation) * water_step;
}

WaterBudget Simulation::State::water_budget() const {
  WaterBudget water = result.water;
  water.storage = mixture.water.stored_water() - first_storage;
  const double turnover = std::max(water.infiltration, water.outflow);
  water.error = turnover > 0.0 ? (water.infiltration - water.outflow - water.storage) / turnover : 0.0;
  return water;
}

void Simulation::State::observe_displacement() {
  const solid::Particles& soil = mixture.soil.particles();
  double farthest = 0.0;
  for (std::size_t p = 0; p < soil.size(); ++p) {
    const double squared = soil.ux[p] * soil.ux[p] + soil.uy[p] * soil.uy[p];
    if (squared > farthest) {
      farthest = squared;
      farthest_particle = p;
    }
  }
  largest_displacement = std::sqrt(farthest);
  for (DisplacementTime& mark : result.displacement_times) {
    if (!mark.time && largest_displacement > mark.displacement) mark.time = time;
  }
  if (!result.onset_time && largest_displacement > input.onset_displacement) {
    result.onset_time = time;
    result.onset_position = {soil.x[farthest_particle], soil.y[farthest_particle]};
    result.zone_at_onset = zone();
    onset_snapshot_due = true;
  }
  if (!result.zone_at_10_cm && largest_displacement > zone_mark) result.zone_at_10_cm = zone();
}

void Simulation::State::check_end() {
  const auto end = [this](const char* reason) {
    finished = true;
    result.end_reason = reason;
  };
  if (due(input.stop.time)) {
    end("time");
  } else if (largest_displacement >= input.stop.displacement) {
    end("displacement");
  } else if (result.onset_time && due(*result.onset_time + input.stop.after_onset)) {
    end("after_onset");
  }
}

Simulation::Simulation(Case input, int threads) : state_(std::make_unique<State>(std::move(input), threads)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

// @return whether it came to the end
bool Simulation::State::find_initial_state(const InitialObserver& go_on) {
  State& s = *this;
  const bool is_steady = std::holds_alternative<SteadyWater>(s.input.initial_water);
  if (is_steady && !find_steady_flow(s.mixture, s.conditions, go_on)) return false;
  s.mixture.weigh_water();
  s.conditions.remember_pressures(s.mixture.water.pressure());
  Actions before;
  s.conditions.apply_initial(s.mixture, before);
  const double step = s.mixture.soil.stable_step(s.input.numerics.courant_number, s.mixture.water_mass());
  const bool needs_stress = s.input.scheme != Scheme::seepage;
  std::optional<double> unbalanced = 0.0;
  if (needs_stress && s.input.initial_stress == InitialStress::self_weight) {
    unbalanced = find_self_weight_stress(s.mixture, before, s.scale, step, go_on);
  } else if (needs_stress && s.input.initial_stress == InitialStress::k0) {
    unbalanced = find_k0_stress(s.mixture, before, s.scale, step, s.particles.spacing, k0_of_soils(s.input), go_on);
  }
  if (!unbalanced) return false;
  s.result.initial_unbalanced_ratio = *unbalanced;
  s.mixture.soil.release_walls(s.mixture.water_mass());
  s.first_storage = s.mixture.water.stored_water();
  const std::size_t n = s.particles.x.size();
  std::vector<double> wx(n), wy(n);
  s.mixture.water.darcy_velocity(s.mixture.skeleton(), wx, wy);
  for (std::size_t p = 0; p < n; ++p) {
    const double saturated =
        s.input.soils[static_cast<std::size_t>(s.particles.soil[p])].seepage.hydraulic_conductivity;
    s.result.initial_head_flux = std::max(s.result.initial_head_flux, std::hypot(wx[p], wy[p]) / saturated);
  }
  s.measure_pressure();
  return true;
}

bool Simulation::initialise(const InitialObserver& observer) {
  const InitialObserver to_the_end = [](const InitialProgress&) { return true; };
  try {
    return state_->find_initial_state(observer ? observer : to_the_end);
  } catch (const solid::SolidError& error) {
    throw SimulationError(std::string("before the start: soil ") + error.what() +
                          "; the weight may be too much for the stiffness, youngs_modulus");
  } catch (const seepage::SeepageError& error) {
    throw SimulationError(std::string("before the start: pore water, ") + error.what());
  }
}

Event Simulation::advance() {
  State& s = *state_;
  Event event;
  try {
    for (int k = 0; k < steps_per_call && !s.finished; ++k) {
      s.step();
      for (; s.due(s.history_time(s.history_rows)); ++s.history_rows) event.history = true;
      while (s.next_snapshot < s.snapshot_times.size() && s.due(s.snapshot_times[s.next_snapshot])) {
        ++s.next_snapshot;
        event.snapshot = true;
      }
      if (s.onset_snapshot_due) {
        event.snapshot = true;
        event.label = "onset";
        s.onset_snapshot_due = false;
      }
      event.history = event.history || s.finished;
      if (event.history || event.snapshot) break;
    }
  } catch (const solid::SolidError& error) {
    throw SimulationError("at t = " + std::to_string(s.time) + " s: soil " + error.what());
  } catch (const seepage::SeepageError& error) {
    throw SimulationError("at t = " + std::to_string(s.time) + " s: pore water, " + error.what());
  }
  if (s.finished) {
    event.finished = true;
    event.snapshot = true;
    if (event.label.empty()) event.label = "end";
  }
  if (event.snapshot) s.measure_pressure();
  return event;
}

const Case& Simulation::input() const {
  return state_->input;
}

Progress Simulation::progress() const {
  const State& s = *state_;
  double share = s.time / s.input.stop.time;
  if (s.input.stop.displacement < never) share = std::max(share, s.largest_displacement / s.input.stop.displacement);
  if (s.result.onset_time && s.input.stop.after_onset < never) {
    share = std::max(share, s.time / (*s.result.onset_time + s.input.stop.after_onset));
  }
  return {s.time, std::min(share, 1.0), s.clock_factor, s.largest_displacement, s.steps, s.water_budget()};
}

ParticleTable Simulation::particles() const {
  const State& s = *state_;
  const solid::Particles& soil = s.mixture.soil.particles();
  const std::size_t n = soil.size();
  ParticleTable table;
  table.time = s.time;
  std::vector<double> wx(n), wy(n);
  s.mixture.water.darcy_velocity(s.mixture.skeleton(), wx, wy);
  for (std::size_t p = 0; p < n; ++p) {
    table.position.push_back({soil.x[p], soil.y[p]});
    table.displacement.push_back({soil.ux[p], soil.uy[p]});
    table.velocity.push_back({soil.vx[p] / s.clock_factor, soil.vy[p] / s.clock_factor});
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
  return table;
}

std::vector<HistoryColumn> Simulation::history_columns() const {
  std::vector<HistoryColumn> columns{{"time", "s"},          {"clock factor", "-"},     {"largest displacement", "m"},
                                     {"kinetic ratio", "-"}, {"unbalanced ratio", "-"}, {"water in", "m3/m"},
                                     {"water out", "m3/m"},  {"water stored", "m3/m"}};
  for (const VerificationPoint& point : state_->input.points) {
    columns.push_back({point.name + " displacement", "m"});
    columns.push_back({point.name + " suction", "Pa"});
  }
  return columns;
}

std::vector<double> Simulation::history_row() const {
  const State& s = *state_;
  const solid::Particles& soil = s.mixture.soil.particles();
  const solid::Balance& balance = s.mixture.soil.balance();
  double elastic_energy = 0.0;
  for (std::size_t p = 0; p < soil.size(); ++p) {
    const solid::Elastic& elastic = s.mixture.soil.soils()[soil.soil[p]].elastic;
    const solid::SymmetricTensor stress{soil.sxx[p], soil.syy[p], soil.szz[p], soil.sxy[p]};
    const double mean = solid::trace(stress) / 3.0;
    elastic_energy += soil.volume[p] * (0.5 * mean * mean / elastic.bulk_modulus() +
                                        0.5 * solid::second_invariant(stress) / elastic.shear_modulus());
  }
  const auto ratio = [](double a, double b) { return b > 0.0 ? a / b : 0.0; };
  std::vector<double> row{s.time,
                          s.clock_factor,
                          s.largest_displacement,
                          ratio(balance.kinetic_energy, elastic_energy),
                          ratio(balance.unbalanced_force, balance.weight),
                          s.result.water.infiltration,
                          s.result.water.outflow,
                          s.mixture.water.stored_water() - s.first_storage};
  for (const std::size_t p : s.followed) {
    row.push_back(std::hypot(soil.ux[p], soil.uy[p]));
    row.push_back(s.mixture.water.suction()[p]);
  }
  return row;
}

std::vector<HistoryColumn> Simulation::budget_columns() {
  return {{"time", "s"},       {"rain", "m3/m"},        {"rain infiltration", "m3/m"}, {"run-off", "m3/m"},
          {"seepage", "m3/m"}, {"evaporation", "m3/m"}, {"infiltration", "m3/m"},      {"outflow", "m3/m"},
          {"storage", "m3/m"}, {"error", "m3/m"}};
}

std::vector<double> Simulation::budget_row() const {
  const WaterBudget water = state_->water_budget();
  return {state_->time,
          water.rain,
          water.rain_infiltration,
          water.run_off,
          water.seepage,
          water.evaporation,
          water.infiltration,
          water.outflow,
          water.storage,
          water.infiltration - water.outflow - water.storage};
}

Summary Simulation::summary() const {
  const State& s = *state_;
  Summary summary = s.result;
  summary.time = s.time;
  summary.zone_at_end = s.zone();
  summary.largest_displacement = s.largest_displacement;
  summary.steps = s.steps;
  summary.mean_pressure_iterations =
      s.steps == 0 ? 0.0 : static_cast<double>(s.pressure_iterations) / static_cast<double>(s.steps);
  summary.water = s.water_budget();
  return summary;
}

}  // namespace slope::couple
