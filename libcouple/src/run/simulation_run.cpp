#include "simulation_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

#include "case/initial_values.hpp"
#include "initial_state.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple {

namespace {

constexpr std::array displacement_marks{0.01, 0.02, 0.05, 0.10, 0.30, 1.00};  // m
constexpr std::array shorter_steps{0.5, 0.25, 0.125};                         // shares of a step that broke
constexpr double at_once = 10.0;  // first periods after the start in which a slope fails at once

InitialParticles fill(const Case& input) {
  InitialParticles particles = fill_regions(input.domain, input.regions);
  if (particles.x.empty()) {
    throw InputError(
        {{input.path, 0, "geometry", "no particle lies inside the polygons; make them larger than a cell"}});
  }
  return particles;
}

// Of the fastest drained P-wave (m/s); where the stiffness varies, at a mean stress (Pa).
double wave_speed(const Case& input, const Mixture& mixture, double mean_stress) {
  if (!mixture.soil.stiffness_varies()) {
    return input.domain.cell_size / mixture.soil.stable_step(1.0, mixture.water_mass());
  }
  const solid::Particles& soil = mixture.soil.particles();
  const std::vector<double> water_mass = mixture.water_mass();
  double fastest = 0.0;
  for (std::size_t p = 0; p < soil.size(); ++p) {
    const double modulus = mixture.soil.stiffness(p, mean_stress).constrained_modulus();
    fastest = std::max(fastest, modulus * soil.volume[p] / (soil.solid_mass[p] + water_mass[p]));
  }
  return std::sqrt(fastest);
}

SlopeScale scale_of(const Case& input, const InitialParticles& particles, const Mixture& mixture) {
  SlopeScale scale;
  const auto [low, high] = std::ranges::minmax(particles.y);
  scale.height = high - low + particles.spacing;
  scale.gravity = input.gravity;
  const std::vector<double> water_mass = mixture.water_mass();
  double mass = 0.0, volume = 0.0;
  for (std::size_t p = 0; p < particles.x.size(); ++p) {
    mass += mixture.soil.particles().solid_mass[p] + water_mass[p];
    volume += particles.volume[p];
  }
  scale.overburden = mass / volume * input.gravity * scale.height;
  scale.wave_speed = wave_speed(input, mixture, 0.5 * scale.overburden);
  return scale;
}

// Whether all lie in the domain or beside it, by no more than its own width or height.
bool lie_near(const Domain& domain, std::span<const double> positions, std::size_t axis) {
  const double side = domain.upper[axis] - domain.lower[axis];
  return std::ranges::all_of(positions, [&](double position) {
    return position >= domain.lower[axis] - side && position <= domain.upper[axis] + side;
  });
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

Simulation::Run::Run(Case c, std::optional<bool> mirrored, int threads)
    : given(std::move(c)),
      frame(given, mirrored),
      input(frame.place(given)),
      particles(fill(input)),
      mixture(input, particles, initial_pressure(input, particles), threads),
      scale(scale_of(input, particles, mixture)),
      conditions(input, particles),
      scheme(input, mixture, scale, conditions.change_times()),
      surface(particles, faces_at({}, input, particles)),
      ground(input.domain, input.regions),
      runaway(input.onset_displacement, at_once * scale.period()),
      rest(std::sqrt(scale.height / scale.gravity)),
      snapshot_times(input.output.snapshots) {
  now.first_storage = mixture.water.stored_water();
  now.result.onset_criterion = input.onset_displacement;
  now.result.particles = particles.x.size();
  for (const double mark : displacement_marks) now.result.displacement_times.push_back({mark, {}});
  for (const VerificationPoint& point : input.points) followed.push_back(nearest_particle(particles, point.position));
  for (double t = input.output.snapshot_interval; t < input.stop.time; t += input.output.snapshot_interval) {
    snapshot_times.push_back(t);
  }
  safety_times = input.safety.times;
  for (int k = 0; k * input.safety.interval <= input.stop.time; ++k) safety_times.push_back(k * input.safety.interval);
  snapshot_times.insert(snapshot_times.end(), safety_times.begin(), safety_times.end());
  std::erase_if(snapshot_times, [](double t) { return t <= 0.0; });  // the start is always there
  std::ranges::sort(snapshot_times);
  take_due();
}

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
          .pace = scheme.state(),
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
  const bool is_within = state.progress.time >= 0.0 && state.progress.time <= input.stop.time;
  if (!is_within) refuse("it is of a time that this run does not have");
  if (state.mixture.first_volume.empty() == mixture.rigid()) refuse("one skeleton is rigid, the other is not");
  for (const auto* field : {&state.mixture.first_volume, &state.mixture.first_porosity, &state.boundary.first_pressure,
                            &state.boundary.free_surface.x, &state.rest.ux, &state.rest.uy}) {
    if (!field->empty() && field->size() != n) refuse("a field has not one entry for each particle");
  }
  const seepage::FreeSurface::State& surface_then = state.boundary.free_surface;
  for (const auto* x : {&state.soil.particles.x, &state.head_operator.x, &surface_then.x}) {
    if (!lie_near(input.domain, *x, 0)) refuse("a particle is far from it");
  }
  for (const auto* y : {&state.soil.particles.y, &state.head_operator.y, &surface_then.y}) {
    if (!lie_near(input.domain, *y, 1)) refuse("a particle is far from it");
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
    scheme.set_state(std::move(state.pace));
  } catch (const std::invalid_argument& error) {
    throw InputError({{input.path, 0, "", std::string("the state is of another case: ") + error.what()}});
  }
  runaway.set_state(std::move(state.runaway));
  rest.set_state(std::move(state.rest));
  now = std::move(state.progress);
  history_rows = next_snapshot = 0;
  take_due();
}

// @return whether it came to the end
bool Simulation::Run::find_initial_state(const InitialObserver& go_on) {
  const bool is_steady = std::holds_alternative<SteadyWater>(input.initial_water);
  if (is_steady && !find_steady_flow(mixture, conditions, go_on)) return false;
  conditions.remember_pressures(mixture.water.pressure());
  Actions before;
  conditions.apply_initial(mixture, before);
  const auto stable = [this] { return mixture.soil.stable_step(input.numerics.courant_number, mixture.water_mass()); };
  const TimeStep step = [this, stable, first = stable()] { return mixture.soil.stiffness_varies() ? stable() : first; };
  std::optional<double> unbalanced = 0.0;
  if (scheme.moves_soil() && input.initial_stress == InitialStress::self_weight) {
    unbalanced = find_self_weight_stress(mixture, before, scale, step, go_on);
  } else if (scheme.moves_soil() && input.initial_stress == InitialStress::k0) {
    unbalanced = find_k0_stress(mixture, before, scale, step, particles.spacing, k0_of_soils(input), go_on);
  }
  if (!unbalanced) return false;
  now.result.initial_unbalanced_ratio = *unbalanced;
  now.result.stands_before = *unbalanced <= unbalanced_limit;
  if (scheme.moves_soil() && input.initial_stress != InitialStress::none &&
      !add_standing_acceleration(mixture, before, conditions.standing_acceleration(), scale, step, go_on)) {
    return false;
  }
  mixture.soil.release_walls(mixture.water_mass());
  now.first_storage = mixture.water.stored_water();
  const std::size_t n = particles.x.size();
  std::vector<double> wx(n), wy(n);
  mixture.water.darcy_velocity(mixture.skeleton(), wx, wy);
  for (std::size_t p = 0; p < n; ++p) {
    const double saturated = input.soils[static_cast<std::size_t>(particles.soil[p])].seepage.hydraulic_conductivity;
    now.result.initial_head_flux = std::max(now.result.initial_head_flux, std::hypot(wx[p], wy[p]) / saturated);
  }
  measure_pressure();
  return true;
}

// The earliest time after the present one at which something is due.
double Simulation::Run::next_stop() const {
  double next = std::min(input.stop.time, conditions.next_change(now.time + sliver * scheme.time_step()));
  next = std::min(next, history_time(history_rows));
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
  const StepDone done = scheme.step({mixture, conditions, actions, now.time, next_stop(), share});
  now.time = done.time;
  now.latest_step = done.duration;
  now.clock_factor = done.clock_factor;
  ++now.steps;
  now.pressure_iterations += static_cast<std::size_t>(done.report.iterations);
  if (!done.report.converged) ++now.result.unsettled_steps;
  observe_water();
  observe_displacement();
  check_end();
}

// Positions in the case's own coordinates.
std::string Simulation::Run::text_of(const solid::SolidError& error) const {
  const bool is_x = error.field.starts_with("x position");
  if (!is_x && !error.field.starts_with("y position")) return error.what();
  const Point place = frame.position({mixture.soil.particles().x[error.particle], error.value});
  return solid::SolidError(error.particle, error.field, place[is_x ? 0 : 1]).what();
}

}  // namespace slope::couple
