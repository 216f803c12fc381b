#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "slope/couple/summary.hpp"
#include "slope/seepage/free_surface.hpp"
#include "slope/seepage/head_operator.hpp"
#include "slope/seepage/pore_flow.hpp"
#include "slope/solid/material_point_method.hpp"

// What a slope is at a time: plain, public and listed. Each `for_each_field` calls visit(name, field) for all fields of
// its struct, so that whatever copies, writes or compares states has one list to go by.

namespace slope::couple {

/// What a rigid skeleton keeps; empty with a deformable one.
struct MixtureState {
  std::vector<double> first_volume;    ///< (m2)
  std::vector<double> first_porosity;  ///< (-)

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("first_volume", s.first_volume);
    visit("first_porosity", s.first_porosity);
  }
  bool operator==(const MixtureState&) const = default;
};

struct BoundaryState {
  std::vector<double> first_pressure;  ///< of each particle, from which ramps start (Pa)
  seepage::FreeSurface::State free_surface;

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("first_pressure", s.first_pressure);
    visit("free_surface", s.free_surface);
  }
  bool operator==(const BoundaryState&) const = default;
};

struct ClockState {
  double factor = 1.0;
  double last_factor = 1.0;               ///< of the latest step, before it was fitted to what is due
  double block_time = 0.0;                ///< since the latest judgement, of the soil's own time (s)
  double block_unbalanced = 0.0;          ///< unbalanced ratio times time (s)
  std::vector<double> pressure;           ///< at the start of the block (Pa)
  double water_change = 0.0;              ///< mean change of pore pressures, over the overburden: largest so far (-)
  double largest_unbalanced_ratio = 0.0;  ///< that a judgement found while the water ran ahead of the soil (-)

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("factor", s.factor), visit("last_factor", s.last_factor);
    visit("block_time", s.block_time), visit("block_unbalanced", s.block_unbalanced);
    visit("pressure", s.pressure);
    visit("water_change", s.water_change);
    visit("largest_unbalanced_ratio", s.largest_unbalanced_ratio);
  }
  bool operator==(const ClockState&) const = default;
};

/// How the steps go on of a scheme that moves the soil.
struct ClockPace {
  double time_step = 0.0;  ///< of the soil, at most (s)
  ClockState clock;

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("time_step", s.time_step);
    visit("clock", s.clock);
  }
  bool operator==(const ClockPace&) const = default;
};

/// How the steps of the water alone go on.
struct WaterPace {
  double next_step = 1.0;    ///< at most; at first, where the search for it begins (s)
  double latest_step = 1.0;  ///< (s)

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("next_step", s.next_step), visit("latest_step", s.latest_step);
  }
  bool operator==(const WaterPace&) const = default;
};

using PaceState = std::variant<ClockPace, WaterPace>;

/// Of the search for the onset by runaway.
struct RunawayState {
  struct Sample {
    double time = 0.0, displacement = 0.0;  ///< (s, m)

    template <class Self, class Visit>
    static void for_each_field(Self& s, const Visit& visit) {
      visit("time", s.time), visit("displacement", s.displacement);
    }
    bool operator==(const Sample&) const = default;
  };
  std::vector<Sample> samples{{}};  ///< of the largest displacement so far
  Sample latest;
  std::optional<double> time;  ///< of the kink (s); none: it has not run away so far
  double displacement = 0.0;   ///< then (m)

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("samples", s.samples), visit("latest", s.latest);
    visit("time", s.time), visit("displacement", s.displacement);
  }
  bool operator==(const RunawayState&) const = default;
};

/// Of the search for rest after the onset.
struct RestState {
  double began = 0.0;          ///< since the onset (s)
  double own_time = 0.0;       ///< since then, of the soil (s)
  std::vector<double> ux, uy;  ///< displacements at that time (m); empty: before the onset

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("began", s.began), visit("own_time", s.own_time);
    visit("ux", s.ux), visit("uy", s.uy);
  }
  bool operator==(const RestState&) const = default;
};

/// Where a run is.
struct ProgressState {
  double time = 0.0;                  ///< simulated (s)
  double clock_factor = 1.0;          ///< of the latest step (-)
  double latest_step = 0.0;           ///< of the water's time (s)
  double largest_displacement = 0.0;  ///< (m)
  std::size_t farthest_particle = 0;
  std::size_t steps = 0;
  std::size_t pressure_iterations = 0;
  double first_storage = 0.0;  ///< water in the pores before the start (m3/m)
  Summary result;              ///< what has been found so far; what summary() works out anew is not in it

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("time", s.time);
    visit("clock_factor", s.clock_factor);
    visit("latest_step", s.latest_step);
    visit("largest_displacement", s.largest_displacement), visit("farthest_particle", s.farthest_particle);
    visit("steps", s.steps), visit("pressure_iterations", s.pressure_iterations);
    visit("first_storage", s.first_storage);
    visit("result", s.result);
  }
  bool operator==(const ProgressState&) const = default;
};

/// All that a slope is at a time. Positions and directions are those in which the case is computed (see `frame` in the
/// library's README): the origin is the lower left corner of the domain, and x may be mirrored.
struct SimulationState {
  bool mirrored = false;
  solid::MaterialPointMethod::State soil;
  seepage::PoreFlow::State water;
  seepage::HeadOperator::State head_operator;
  MixtureState mixture;
  BoundaryState boundary;
  PaceState pace;
  RunawayState runaway;
  RestState rest;
  ProgressState progress;

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("mirrored", s.mirrored);
    visit("soil", s.soil);
    visit("water", s.water);
    visit("head_operator", s.head_operator);
    visit("mixture", s.mixture);
    visit("boundary", s.boundary);
    visit("pace", s.pace);
    visit("runaway", s.runaway);
    visit("rest", s.rest);
    visit("progress", s.progress);
  }
  bool operator==(const SimulationState&) const = default;
};

}  // namespace slope::couple
