// What is found of a slope on the way, and when its run ends.

#include <algorithm>
#include <cmath>

#include "case/polygon.hpp"
#include "checkerboard.hpp"
#include "initial_state.hpp"
#include "safety.hpp"
#include "simulation_run.hpp"

namespace slope::couple {

namespace {

constexpr double zone_mark = 0.10;  // m: displacement at which the failure zone is reported for comparison

}  // namespace

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
  water.balance_error = water.infiltration - water.outflow - water.storage;
  water.relative_balance_error = turnover > 0.0 ? water.balance_error / turnover : 0.0;
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

FailureZone Simulation::Run::zone() const {
  return find_failure_zone(mixture.soil.particles(), mixture.water.suction(), surface, particles.spacing,
                           input.failure_zone_strain);
}

Slide Simulation::Run::slide() const {
  return find_slide(mixture.soil.particles(), ground, input.domain, particles.spacing, input.onset_displacement);
}

bool Simulation::Run::asks_for_safety() const {
  const double close = sliver * scheme.time_step();
  const auto is_now = [&](double time) { return std::abs(time - now.time) <= close; };
  const bool found = !now.result.safety.empty() && is_now(now.result.safety.back().time);
  return !found && std::ranges::any_of(safety_times, is_now);
}

std::optional<Mechanism> Simulation::Run::find_safety(const InitialObserver& go_on) {
  Mixture slope = mixture;
  BoundaryConditions acting = conditions;
  Actions now_acting;
  acting.apply(now.time, slope, now_acting);
  if (!scheme.moves_soil()) {
    const TimeStep step = [&] { return slope.soil.stable_step(input.numerics.courant_number, slope.water_mass()); };
    if (!find_self_weight_stress(slope, now_acting, scale, step, go_on)) return std::nullopt;
  }
  SafetySearch search(slope, now_acting, scale, input.numerics.courant_number, surface);
  if (!input.safety.within.empty()) {
    std::vector<std::uint8_t> where;
    for (std::size_t p = 0; p < particles.x.size(); ++p) {
      where.push_back(contains(input.safety.within, {particles.x[p], particles.y[p]}, 0.0) ? 1 : 0);
    }
    search.reduce_within(std::move(where));
  }
  std::optional<double> earlier;
  if (!now.result.safety.empty()) earlier = now.result.safety.back().factor;
  auto found = search.find(input.safety.tolerance, earlier, go_on);
  if (!found) return std::nullopt;
  found->time = now.time;
  now.result.safety.push_back(*found);
  return search.mechanism();
}

void Simulation::Run::measure_pressure() {
  now.result.pressure_checkerboard =
      std::max(now.result.pressure_checkerboard,
               pressure_checkerboard(mixture.water.head_operator(), mixture.skeleton(), mixture.water.pressure()));
}

bool Simulation::Run::comes_to_rest() {
  if (!input.stop.at_rest || !now.result.onset_time) return false;
  const solid::Particles& soil = mixture.soil.particles();
  const double at_onset = input.onset == Onset::runaway ? runaway.displacement() : input.onset_displacement;
  return rest.observe(now.time - *now.result.onset_time, now.latest_step / now.clock_factor,
                      now.largest_displacement - at_onset, soil.ux, soil.uy);
}

void Simulation::Run::check_end() {
  EndReason& reason = now.result.end_reason;
  if (due(input.stop.time)) {
    reason = EndReason::time;
  } else if (now.largest_displacement >= input.stop.displacement) {
    reason = EndReason::displacement;
  } else if (now.result.onset_time && due(*now.result.onset_time + input.stop.after_onset)) {
    reason = EndReason::after_onset;
  } else if (comes_to_rest()) {
    reason = EndReason::at_rest;
  }
}

Verdict Simulation::Run::verdict() const {
  if (!scheme.moves_soil()) return Verdict::water_alone;
  if (!now.result.stands_before) return Verdict::does_not_stand;
  if (now.result.onset_time) {
    const bool slides = now.result.runaway_onset || zone().area > 0.0;
    return slides ? Verdict::fails : Verdict::moves;
  }
  return now.result.end_reason == EndReason::time ? Verdict::stands : Verdict::undecided;
}

}  // namespace slope::couple
