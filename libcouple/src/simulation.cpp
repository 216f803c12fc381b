#include "slope/couple/simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "boundary_conditions.hpp"
#include "checkerboard.hpp"
#include "clock_control.hpp"
#include "failure.hpp"
#include "frame.hpp"
#include "initial_state.hpp"
#include "mixture.hpp"
#include "onset.hpp"
#include "rest.hpp"
#include "scheme.hpp"
#include "slide.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/solid/tensor.hpp"

namespace slope::couple {

namespace {

constexpr std::array displacement_marks{0.01, 0.02, 0.05, 0.10, 0.30, 1.00};  // m
constexpr double zone_mark = 0.10;   // m: displacement at which the failure zone is reported for comparison
constexpr int steps_per_call = 200;  // after which advance() returns even if nothing is due
constexpr std::array shorter_steps{0.5, 0.25, 0.125};  // shares of a step that broke
constexpr double sliver = 1.0e-6;                      // share of a step by which two times may differ and be the same
constexpr const char* running = "running";
constexpr double at_once = 10.0;  // first periods after the start in which a slope fails at once

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
  const std::vector<double> water_mass = mixture.water_mass();
  double mass = 0.0, volume = 0.0;
  for (std::size_t p = 0; p < particles.x.size(); ++p) {
    mass += mixture.soil.particles().solid_mass[p] + water_mass[p];
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

struct Simulation::Run {
  Run(Case c, std::optional<bool> mirrored, int threads)
      : given(std::move(c)),
        frame(given, mirrored),
        input(frame.place(given)),
        particles(fill(input)),
        mixture(input, particles, initial_pressure(input, particles), threads),
        scale(scale_of(input, particles, mixture)),
        conditions(input, particles),
        scheme(make_scheme(input)),
        clock(clock_limits(scheme, input, mixture), scale, conditions.change_times()),
        surface(particles, faces_at({}, input, particles)),
        ground(input.domain, input.regions),
        runaway(input.onset_displacement, at_once * scale.period()),
        rest(std::sqrt(scale.height / scale.gravity)),
        snapshot_times(input.output.snapshots) {
    now.time_step = longest_step(scheme, mixture, input.numerics.courant_number);
    now.first_storage = mixture.water.stored_water();
    now.result.end_reason = running;
    now.result.onset_criterion = input.onset_displacement;
    now.result.particles = particles.x.size();
    for (const double mark : displacement_marks) now.result.displacement_times.push_back({mark, {}});
    for (const VerificationPoint& point : input.points) followed.push_back(nearest_particle(particles, point.position));
    for (double t = input.output.snapshot_interval; t < input.stop.time; t += input.output.snapshot_interval) {
      snapshot_times.push_back(t);
    }
    std::erase_if(snapshot_times, [](double t) { return t <= 0.0; });  // the start is always there
    std::ranges::sort(snapshot_times);
    take_due();
  }

  // Outputs that are due.
  struct Due {
    bool history = false, snapshot = false;
  };

  [[nodiscard]] SimulationState state() const;
  void set_state(SimulationState state);
  void check(const SimulationState& state) const;
  bool find_initial_state(const InitialObserver& go_on);
  Due take_due();
  void step(double share);
  [[nodiscard]] std::optional<std::string> try_step(double share);
  void go_back();
  void step_or_try_again();
  [[nodiscard]] bool finished() const { return now.result.end_reason != running; }
  template <class Coupled>
  seepage::SolveReport step_mixture(Coupled& coupled, double next, double longest);
  seepage::SolveReport step_water(SeepageScheme& seepage, double next, double share);
  [[nodiscard]] WaterBudget water_budget() const;
  void observe_water();
  void observe_displacement();
  void observe_onset();
  void check_end();
  [[nodiscard]] bool comes_to_rest();
  [[nodiscard]] Verdict verdict() const;
  void measure_pressure() {
    now.result.pressure_checkerboard =
        std::max(now.result.pressure_checkerboard,
                 pressure_checkerboard(mixture.water.head_operator(), mixture.skeleton(), mixture.water.pressure()));
  }
  [[nodiscard]] double history_time(std::size_t row) const {
    return static_cast<double>(row) * input.output.history_interval;
  }
  [[nodiscard]] bool due(double t) const { return t <= now.time + sliver * now.time_step; }
  [[nodiscard]] double next_stop() const;
  [[nodiscard]] std::string text_of(const solid::SolidError& error) const;
  [[nodiscard]] FailureZone zone() const {
    return find_failure_zone(mixture.soil.particles(), mixture.water.suction(), surface, particles.spacing,
                             input.failure_zone_strain);
  }
  [[nodiscard]] Slide slide() const {
    return find_slide(mixture.soil.particles(), ground, input.domain, particles.spacing, input.onset_displacement);
  }

  // given once
  Case given;
  Frame frame;
  Case input;  // in the frame, as is all that follows; what leaves is turned back
  InitialParticles particles;
  // each with a state of its own
  Mixture mixture;
  SlopeScale scale;
  BoundaryConditions conditions;
  AnyScheme scheme;
  ClockControl clock;
  GroundSurface surface;
  GroundLine ground;
  RunawayWatch runaway;
  RestWatch rest;
  ProgressState now;
  // worked out from the case and the state
  Actions actions;
  std::vector<std::size_t> followed;  // particle of each verification point
  std::vector<double> snapshot_times;
  std::size_t history_rows = 0;  // due so far; the first is that of the start
  std::size_t next_snapshot = 0;
  // a state to go back to, and the steps since then
  struct Anchor {
    SimulationState state;
    int steps = 0;
  };
  std::optional<Anchor> anchor;
};

// What has become due, which from then on is done.
Simulation::Run::Due Simulation::Run::take_due() {
  Due result;
  for (; due(history_time(history_rows)); ++history_rows) result.history = true;
  for (; next_snapshot < snapshot_times.size() && due(snapshot_times[next_snapshot]); ++next_snapshot) {
    result.snapshot = true;
  }
  return result;
}

SimulationState Simulation::Run::state() const {
  return {.mirrored = frame.is_mirrored(),
          .soil = mixture.soil.state(),
          .water = mixture.water.state(),
          .head_operator = mixture.water.head_operator().state(),
          .mixture = mixture.state(),
          .boundary = conditions.state(),
          .clock = clock.state(),
          .water_step = water_step(scheme),
          .runaway = runaway.state(),
          .rest = rest.state(),
          .progress = now};
}

// Whether the state is one of this ground.
void Simulation::Run::check(const SimulationState& state) const {
  const auto refuse = [this](const std::string& why) {
    throw InputError({{input.path, 0, "", "the state is of another case: " + why}});
  };
  const std::size_t n = particles.x.size(), other = state.soil.particles.size();
  if (other != n) refuse("it has " + std::to_string(other) + " particles instead of " + std::to_string(n));
  if (state.soil.particles.soil != mixture.soil.particles().soil) refuse("its soils lie elsewhere");
  if (state.mixture.first_volume.empty() == mixture.rigid()) refuse("one skeleton is rigid, the other is not");
  if ((state.water_step > 0.0) != (water_step(scheme) > 0.0)) refuse("its scheme is another");
  for (const auto* field : {&state.mixture.first_volume, &state.mixture.first_porosity, &state.boundary.first_pressure,
                            &state.boundary.free_surface.x, &state.clock.pressure, &state.rest.ux, &state.rest.uy}) {
    if (!field->empty() && field->size() != n) refuse("a field has not one entry for each particle");
  }
  if (state.progress.farthest_particle >= n || state.runaway.samples.empty() || state.boundary.first_pressure.empty()) {
    refuse("it is not whole");
  }
}

void Simulation::Run::set_state(SimulationState state) {
  check(state);
  try {
    mixture.soil.set_state(std::move(state.soil));
    mixture.water.set_state(std::move(state.water), std::move(state.head_operator));
    mixture.set_state(std::move(state.mixture));
    conditions.set_state(std::move(state.boundary));
  } catch (const std::invalid_argument& error) {
    throw InputError({{input.path, 0, "", std::string("the state is of another case: ") + error.what()}});
  }
  clock.set_state(std::move(state.clock));
  set_water_step(scheme, state.water_step);
  runaway.set_state(std::move(state.runaway));
  rest.set_state(std::move(state.rest));
  now = std::move(state.progress);
  history_rows = next_snapshot = 0;
  take_due();
}

// The earliest time after the present one at which something is due.
double Simulation::Run::next_stop() const {
  double next = std::min(input.stop.time, clock.next_change(now.time + sliver * now.time_step));
  next = std::min(next, history_time(history_rows));
  next = std::min(next, conditions.next_change(now.time + sliver * now.time_step));
  if (next_snapshot < snapshot_times.size()) next = std::min(next, snapshot_times[next_snapshot]);
  if (now.result.onset_time) next = std::min(next, *now.result.onset_time + input.stop.after_onset);
  return next;
}

// What went wrong, or nothing.
std::optional<std::string> Simulation::Run::try_step(double share) {
  const auto when = [this] { return "at t = " + std::to_string(now.time) + " s: "; };
  try {
    step(share);
    return std::nullopt;
  } catch (const solid::SolidError& error) {
    return when() + "soil " + text_of(error);
  } catch (const seepage::SeepageError& error) {
    return when() + "pore water, " + error.what();
  }
}

// To the start of a step that broke: to keep a copy of each step's would cost more than to take the steps again.
void Simulation::Run::go_back() {
  set_state(anchor->state);
  for (; anchor->steps > 0; --anchor->steps) {
    step(1.0);
    take_due();
  }
  anchor->state = state();
}

void Simulation::Run::step_or_try_again() {
  if (!anchor || anchor->steps >= steps_per_call) anchor = Anchor{state(), 0};
  const auto what = try_step(1.0);
  if (!what) {
    ++anchor->steps;
    return;
  }
  go_back();
  for (const double share : shorter_steps) {
    if (!try_step(share)) {
      anchor.reset();
      return;
    }
    set_state(anchor->state);
  }
  throw SimulationError(*what + "; shorter steps broke too");
}

// A step of a share of its length.
void Simulation::Run::step(double share) {
  const double next = next_stop();
  const auto report =
      std::visit(BySchemes{[&](SeepageScheme& water_alone) { return step_water(water_alone, next, share); },
                           [&](auto& coupled) { return step_mixture(coupled, next, share * now.time_step); }},
                 scheme);
  ++now.steps;
  now.pressure_iterations += static_cast<std::size_t>(report.iterations);
  if (!report.converged) ++now.result.unsettled_steps;
  observe_water();
  observe_displacement();
  check_end();
}

template <class Coupled>
seepage::SolveReport Simulation::Run::step_mixture(Coupled& coupled, double next, double longest) {
  const ClockControl::Pace pace = clock.pace(now.time, next, longest, conditions.prescribed_rate(now.time));
  now.clock_factor = pace.factor;
  if (pace.velocity_scale < 1.0) mixture.slow_down(pace.velocity_scale);
  const double water_step = pace.factor * pace.time_step;
  // the last step up to what is due ends there to the last digit
  const double after = now.time + (1.0 + sliver) * water_step > next ? next : now.time + water_step;
  conditions.apply(after, mixture, actions);
  const auto report = coupled.step(mixture, actions, pace.time_step, pace.factor);
  now.time = after;
  now.latest_step = water_step;
  const solid::Balance& balance = mixture.soil.balance();
  clock.observe(pace.time_step, balance.unbalanced_force / balance.weight, mixture.water.pressure());
  return report;
}

seepage::SolveReport Simulation::Run::step_water(SeepageScheme& seepage, double next, double share) {
  for (;;) {
    now.time_step = share * seepage.pace(now.time, next);
    const double after = now.time + (1.0 + sliver) * now.time_step > next ? next : now.time + now.time_step;
    conditions.apply(after, mixture, actions);
    const auto report = seepage.step(mixture, actions, now.time_step, now.clock_factor);
    if (!report.converged) continue;
    now.time = after;
    now.latest_step = now.time_step;
    return report;
  }
}

void Simulation::Run::observe_water() {
  const double water_step = now.latest_step;
  const std::span<const double> rate = mixture.water.inflow_rate();
  WaterBudget& water = now.result.water;
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

WaterBudget Simulation::Run::water_budget() const {
  WaterBudget water = now.result.water;
  water.storage = mixture.water.stored_water() - now.first_storage;
  const double turnover = std::max(water.infiltration, water.outflow);
  water.error = turnover > 0.0 ? (water.infiltration - water.outflow - water.storage) / turnover : 0.0;
  return water;
}

void Simulation::Run::observe_displacement() {
  const solid::Particles& soil = mixture.soil.particles();
  double farthest = 0.0;
  for (std::size_t p = 0; p < soil.size(); ++p) {
    const double squared = soil.ux[p] * soil.ux[p] + soil.uy[p] * soil.uy[p];
    if (squared > farthest) {
      farthest = squared;
      now.farthest_particle = p;
    }
  }
  now.largest_displacement = std::sqrt(farthest);
  for (DisplacementTime& mark : now.result.displacement_times) {
    if (!mark.time && now.largest_displacement > mark.displacement) mark.time = now.time;
  }
  observe_onset();
  if (!now.result.zone_at_10_cm && now.largest_displacement > zone_mark) {
    now.result.zone_at_10_cm = zone();
    now.result.slide_at_10_cm = slide();
  }
}

void Simulation::Run::observe_onset() {
  if (!now.result.displacement_onset && now.largest_displacement > input.onset_displacement)
    now.result.displacement_onset = now.time;
  if (runaway.observe(now.time, now.largest_displacement)) now.result.runaway_onset = runaway.time();
  if (now.result.onset_time) return;
  now.result.onset_time = input.onset == Onset::runaway ? now.result.runaway_onset : now.result.displacement_onset;
  if (!now.result.onset_time) return;
  const solid::Particles& soil = mixture.soil.particles();
  now.result.onset_position = {soil.x[now.farthest_particle], soil.y[now.farthest_particle]};
  now.result.zone_at_onset = zone();
}

bool Simulation::Run::comes_to_rest() {
  if (!input.stop.at_rest || !now.result.onset_time) return false;
  const solid::Particles& soil = mixture.soil.particles();
  const double at_onset = input.onset == Onset::runaway ? runaway.displacement() : input.onset_displacement;
  return rest.observe(now.time - *now.result.onset_time, now.latest_step / now.clock_factor,
                      now.largest_displacement - at_onset, soil.ux, soil.uy);
}

void Simulation::Run::check_end() {
  const auto end = [this](const char* reason) { now.result.end_reason = reason; };
  if (due(input.stop.time)) {
    end("time");
  } else if (now.largest_displacement >= input.stop.displacement) {
    end("displacement");
  } else if (now.result.onset_time && due(*now.result.onset_time + input.stop.after_onset)) {
    end("after_onset");
  } else if (comes_to_rest()) {
    end("at_rest");
  }
}

// Positions in the case's own coordinates.
std::string Simulation::Run::text_of(const solid::SolidError& error) const {
  const bool is_x = error.field.starts_with("x position");
  if (!is_x && !error.field.starts_with("y position")) return error.what();
  const Point place = frame.position({mixture.soil.particles().x[error.particle], error.value});
  return solid::SolidError(error.particle, error.field, place[is_x ? 0 : 1]).what();
}

Verdict Simulation::Run::verdict() const {
  if (input.scheme == Scheme::seepage) return Verdict::water_alone;
  if (!now.result.stands_before) return Verdict::does_not_stand;
  if (now.result.onset_time) {
    const bool slides = now.result.runaway_onset || zone().area > 0.0;
    return slides ? Verdict::fails : Verdict::moves;
  }
  return now.result.end_reason == "time" ? Verdict::stands : Verdict::undecided;
}

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

// @return whether it came to the end
bool Simulation::Run::find_initial_state(const InitialObserver& go_on) {
  Run& s = *this;
  const bool is_steady = std::holds_alternative<SteadyWater>(s.input.initial_water);
  if (is_steady && !find_steady_flow(s.mixture, s.conditions, go_on)) return false;
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
  s.now.result.initial_unbalanced_ratio = *unbalanced;
  s.now.result.stands_before = *unbalanced <= unbalanced_limit;
  if (needs_stress && s.input.initial_stress != InitialStress::none &&
      !add_standing_acceleration(s.mixture, before, s.conditions.standing_acceleration(), s.scale, step, go_on)) {
    return false;
  }
  s.mixture.soil.release_walls(s.mixture.water_mass());
  s.now.first_storage = s.mixture.water.stored_water();
  const std::size_t n = s.particles.x.size();
  std::vector<double> wx(n), wy(n);
  s.mixture.water.darcy_velocity(s.mixture.skeleton(), wx, wy);
  for (std::size_t p = 0; p < n; ++p) {
    const double saturated =
        s.input.soils[static_cast<std::size_t>(s.particles.soil[p])].seepage.hydraulic_conductivity;
    s.now.result.initial_head_flux = std::max(s.now.result.initial_head_flux, std::hypot(wx[p], wy[p]) / saturated);
  }
  s.measure_pressure();
  return true;
}

bool Simulation::initialise(const InitialObserver& observer) {
  const InitialObserver to_the_end = [](const InitialProgress&) { return true; };
  try {
    return run_->find_initial_state(observer ? observer : to_the_end);
  } catch (const solid::SolidError& error) {
    throw SimulationError("before the start: soil " + run_->text_of(error) +
                          "; the weight may be too much for the stiffness, youngs_modulus");
  } catch (const seepage::SeepageError& error) {
    throw SimulationError(std::string("before the start: pore water, ") + error.what());
  }
}

Event Simulation::advance() {
  Run& s = *run_;
  Event event;
  for (int k = 0; k < steps_per_call && !s.finished(); ++k) {
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
  s.frame.turn_back(table);
  return table;
}

std::vector<HistoryColumn> Simulation::history_columns() const {
  std::vector<HistoryColumn> columns{{"time", "s"},          {"clock factor", "-"},     {"largest displacement", "m"},
                                     {"kinetic ratio", "-"}, {"unbalanced ratio", "-"}, {"water in", "m3/m"},
                                     {"water out", "m3/m"},  {"water stored", "m3/m"}};
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
    const solid::Elastic& elastic = s.mixture.soil.soils()[soil.soil[p]].elastic;
    const solid::SymmetricTensor stress{soil.sxx[p], soil.syy[p], soil.szz[p], soil.sxy[p]};
    const double mean = solid::trace(stress) / 3.0;
    elastic_energy += soil.volume[p] * (0.5 * mean * mean / elastic.bulk_modulus() +
                                        0.5 * solid::second_invariant(stress) / elastic.shear_modulus());
  }
  const auto ratio = [](double a, double b) { return b > 0.0 ? a / b : 0.0; };
  std::vector<double> row{s.now.time,
                          s.now.clock_factor,
                          s.now.largest_displacement,
                          ratio(balance.kinetic_energy, elastic_energy),
                          ratio(balance.unbalanced_force, balance.weight),
                          s.now.result.water.infiltration,
                          s.now.result.water.outflow,
                          s.mixture.water.stored_water() - s.now.first_storage};
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
  const WaterBudget water = run_->water_budget();
  return {run_->now.time,          water.rain,
          water.rain_infiltration, water.run_off,
          water.seepage,           water.evaporation,
          water.infiltration,      water.outflow,
          water.storage,           water.infiltration - water.outflow - water.storage};
}

Summary Simulation::summary() const {
  const Run& s = *run_;
  Summary summary = s.now.result;
  summary.time = s.now.time;
  summary.verdict = s.verdict();
  summary.zone_at_end = s.zone();
  summary.slide_at_end = s.slide();
  s.frame.turn_back(summary);
  summary.largest_displacement = s.now.largest_displacement;
  summary.steps = s.now.steps;
  summary.mean_pressure_iterations =
      s.now.steps == 0 ? 0.0 : static_cast<double>(s.now.pressure_iterations) / static_cast<double>(s.now.steps);
  summary.water = s.water_budget();
  summary.largest_unbalanced_ratio = s.clock.largest_unbalanced_ratio();
  return summary;
}

}  // namespace slope::couple
