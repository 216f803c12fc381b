#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::couple {

/// The particles whose deviatoric strain exceeds the case's threshold.
struct FailureZone {
  double length = 0.0;           ///< horizontal extent (m)
  double height = 0.0;           ///< vertical extent (m)
  double depth = 0.0;            ///< largest depth, normal to the ground surface at the start (m)
  double area = 0.0;             ///< (m2)
  double lowest = 0.0;           ///< y of its lowest point (m)
  double highest = 0.0;          ///< y of its highest point (m)
  double largest_suction = 0.0;  ///< left anywhere in the slope (Pa)

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("length", s.length);
    visit("height", s.height);
    visit("depth", s.depth);
    visit("area", s.area);
    visit("lowest", s.lowest);
    visit("highest", s.highest);
    visit("largest_suction", s.largest_suction);
  }
  bool operator==(const FailureZone&) const = default;
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
  /// the soil reaches that stood behind the first toe and above it, to its foremost particle that hangs together with
  /// nine more, each within two spacings of the next; or further, as far as it has pushed up the ground ahead, by more
  /// than half a spacing and the onset displacement. Zero if nothing slid or what slid stays behind the toe; none: no
  /// toe.
  std::optional<double> run_out = 0.0;
  bool reaches_wall = false;  ///< the front has come to the last cell before the side of the domain

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("area", s.area);
    visit("direction", s.direction);
    visit("largest_horizontal_displacement", s.largest_horizontal_displacement);
    visit("toe", s.toe);
    visit("run_out", s.run_out);
    visit("reaches_wall", s.reaches_wall);
  }
  bool operator==(const Slide&) const = default;
};

/// Why a run ended; the texts are in results.hpp.
enum class EndReason {
  running,       ///< it has not
  time,          ///< stop.time
  displacement,  ///< stop.displacement
  after_onset,   ///< stop.after_onset
  at_rest,       ///< stop.at_rest
  interrupted,   ///< by the program that runs it
  error,         ///< the physics broke, or the program could not write
};

/// What a run says of the slope.
enum class Verdict {
  undecided,       ///< it stands so far, but the run has not come to its end
  stands,          ///< no onset of failure until the end
  moves,           ///< the largest displacement passed that of the onset, but nothing ran away, and nothing sheared by
                   ///< more than the failure zone's strain: it swells, settles or creeps
  fails,           ///< it stood before the start, and failed then
  does_not_stand,  ///< no balance was found before the start
  water_alone,     ///< the soil was not asked
};

/// Water that has crossed the boundary and been stored since the start, per metre of thickness (m3/m); names, units and
/// signs are in water_amounts.hpp.
struct WaterBudget {
  double infiltration = 0.0;                  ///< in through all boundaries
  double outflow = 0.0;                       ///< out through all boundaries
  double storage = 0.0;                       ///< change of what the pores hold
  double balance_error = 0.0;                 ///< infiltration - outflow - storage
  double relative_balance_error = 0.0;        ///< of max(infiltration, outflow) (-)
  std::map<std::string, double> by_boundary;  ///< net inflow of each named boundary (m3/m)
  // of the free surface, where the case has rain; rain = rain_infiltration + run_off
  double rain = 0.0;               ///< what fell
  double rain_infiltration = 0.0;  ///< of it into the soil
  double run_off = 0.0;            ///< of it along the ground and away
  double seepage = 0.0;            ///< out of the soil, as water
  double evaporation = 0.0;        ///< out of the soil, into the air

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("infiltration", s.infiltration);
    visit("outflow", s.outflow);
    visit("storage", s.storage);
    visit("balance_error", s.balance_error);
    visit("relative_balance_error", s.relative_balance_error);
    visit("by_boundary", s.by_boundary);
    visit("rain", s.rain);
    visit("rain_infiltration", s.rain_infiltration);
    visit("run_off", s.run_off);
    visit("seepage", s.seepage);
    visit("evaporation", s.evaporation);
  }
  bool operator==(const WaterBudget&) const = default;
};

/// When the largest displacement passed a value.
struct DisplacementTime {
  double displacement = 0.0;   ///< (m)
  std::optional<double> time;  ///< (s); none: it did not

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("displacement", s.displacement);
    visit("time", s.time);
  }
  bool operator==(const DisplacementTime&) const = default;
};

/// How safe the slope is at a time.
struct FactorOfSafety {
  double time = 0.0;            ///< since the start (s)
  double factor = 0.0;          ///< the middle of the bracket (-); the lower end if there is no upper one
  double lower = 0.0;           ///< with the strength divided by this it stands (-); 0: with none that was tried
  std::optional<double> upper;  ///< and by this it flows (-); none: it stood with all that were tried
  std::size_t trials = 0;
  double area = 0.0;   ///< of the mechanism: what moves at more than a tenth of the largest speed (m2); 0: none
  double depth = 0.0;  ///< its largest depth, normal to the ground surface at the start (m)

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("time", s.time);
    visit("factor", s.factor), visit("lower", s.lower), visit("upper", s.upper);
    visit("trials", s.trials);
    visit("area", s.area), visit("depth", s.depth);
  }
  bool operator==(const FactorOfSafety&) const = default;
};

struct Summary {
  EndReason end_reason = EndReason::running;
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
  std::vector<FactorOfSafety> safety;     ///< at the times that the case asks for
  double largest_displacement = 0.0;      ///< (m)
  double pressure_checkerboard = 0.0;     ///< largest over the run, of the measure defined in README (-)
  double initial_head_flux = 0.0;         ///< largest Darcy flux of the head operator before the rain, over k (-)
  double initial_unbalanced_ratio = 0.0;  ///< unbalanced over gravity forces left by the initial state (-)
  double largest_unbalanced_ratio = 0.0;  ///< unbalanced forces over the weight while the water's time ran ahead (-)
  double unbalanced_limit = 0.0;          ///< what of it the clock allows by now (-)
  std::size_t particles = 0;
  std::size_t steps = 0;
  double mean_pressure_iterations = 0.0;
  std::size_t unsettled_steps = 0;  ///< whose pressures were taken as they were after the last iteration allowed

  template <class Self, class Visit>
  static void for_each_field(Self& s, const Visit& visit) {
    visit("end_reason", s.end_reason);
    visit("verdict", s.verdict);
    visit("stands_before", s.stands_before);
    visit("time", s.time);
    visit("onset_criterion", s.onset_criterion);
    visit("onset_time", s.onset_time);
    visit("displacement_onset", s.displacement_onset);
    visit("runaway_onset", s.runaway_onset);
    visit("onset_position", s.onset_position);
    visit("displacement_times", s.displacement_times);
    visit("zone_at_onset", s.zone_at_onset);
    visit("zone_at_10_cm", s.zone_at_10_cm);
    visit("zone_at_end", s.zone_at_end);
    visit("slide_at_10_cm", s.slide_at_10_cm);
    visit("slide_at_end", s.slide_at_end);
    visit("water", s.water);
    visit("safety", s.safety);
    visit("largest_displacement", s.largest_displacement);
    visit("pressure_checkerboard", s.pressure_checkerboard);
    visit("initial_head_flux", s.initial_head_flux);
    visit("initial_unbalanced_ratio", s.initial_unbalanced_ratio);
    visit("largest_unbalanced_ratio", s.largest_unbalanced_ratio);
    visit("unbalanced_limit", s.unbalanced_limit);
    visit("particles", s.particles);
    visit("steps", s.steps);
    visit("mean_pressure_iterations", s.mean_pressure_iterations);
    visit("unsettled_steps", s.unsettled_steps);
  }
  bool operator==(const Summary&) const = default;
};

}  // namespace slope::couple
