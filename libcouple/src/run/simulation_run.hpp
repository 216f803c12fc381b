#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actions.hpp"
#include "boundary_conditions.hpp"
#include "case/frame.hpp"
#include "clock_control.hpp"
#include "failure.hpp"
#include "mixture.hpp"
#include "onset.hpp"
#include "rest.hpp"
#include "scheme.hpp"
#include "slide.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::couple {

/// The parts of a simulation, and what works on them. What leaves is in simulation.cpp.
struct Simulation::Run {
  Run(Case given, std::optional<bool> mirrored, int threads);

  // Outputs that are due.
  struct Due {
    bool history = false, snapshot = false;
  };

  // the run: simulation_run.cpp
  [[nodiscard]] SimulationState state() const;
  void set_state(SimulationState state);
  void check(const SimulationState& state) const;
  bool find_initial_state(const InitialObserver& go_on);
  [[nodiscard]] double history_time(std::size_t row) const {
    return static_cast<double>(row) * input.output.history_interval;
  }
  [[nodiscard]] bool due(double t) const { return t <= now.time + sliver * scheme.time_step(); }
  Due take_due();
  [[nodiscard]] double next_stop() const;
  void step(double share);
  [[nodiscard]] std::optional<std::string> try_step(double share);
  void go_back();
  void step_or_try_again();
  [[nodiscard]] std::string text_of(const solid::SolidError& error) const;

  // what is found on the way: simulation_findings.cpp
  [[nodiscard]] bool asks_for_safety() const;
  std::optional<Mechanism> find_safety(const InitialObserver& go_on);
  void observe_water();
  [[nodiscard]] WaterBudget water_budget() const;
  void observe_displacement();
  void observe_onset();
  [[nodiscard]] FailureZone zone() const;
  [[nodiscard]] Slide slide() const;
  void measure_pressure();
  [[nodiscard]] bool comes_to_rest();
  void check_end();
  [[nodiscard]] bool finished() const { return now.result.end_reason != EndReason::running; }
  [[nodiscard]] Verdict verdict() const;

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
  GroundSurface surface;
  GroundLine ground;
  RunawayWatch runaway;
  RestWatch rest;
  ProgressState now;
  // worked out from the case and the state
  Actions actions;
  std::vector<std::size_t> followed;  // particle of each verification point
  std::vector<double> snapshot_times, safety_times;
  std::size_t history_rows = 0;  // due so far; the first is that of the start
  std::size_t next_snapshot = 0;
  static constexpr int steps_per_call = 200;  // after which advance() returns even if nothing is due
  // a state to go back to, and the steps since then, at most so many
  struct Anchor {
    SimulationState state;
    int steps = 0;
  };
  std::optional<Anchor> anchor;
};

}  // namespace slope::couple
