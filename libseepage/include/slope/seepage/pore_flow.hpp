#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "slope/seepage/boundary.hpp"
#include "slope/seepage/face_flow.hpp"
#include "slope/seepage/head_operator.hpp"
#include "slope/seepage/skeleton.hpp"
#include "slope/seepage/soil.hpp"

namespace slope::seepage {

/// Broken physics of the pore water: a pressure that is not a number, a step that cannot be solved.
class SeepageError : public std::runtime_error {
 public:
  SeepageError(std::size_t particle, const std::string& field, double value);
  std::size_t particle;  ///< index
  std::string field;
  double value;
};

struct FlowSettings {
  double spacing = 0.0;          ///< particle spacing (m), > 0
  double smoothing_ratio = 1.2;  ///< smoothing length over spacing (-)
  MirrorWalls walls;
  int threads = 1;  ///< >= 1; results do not depend on it
};

/// What one solution of a step came to.
struct SolveReport {
  int iterations = 0;           ///< of conjugate gradients, or of Newton's method
  double largest_change = 0.0;  ///< of the pressure (Pa)
  bool converged = true;
};

/// What flowed in a step, for the books.
struct StepFlow {
  std::vector<double> outflow;      ///< of each particle, net of what comes in by boundaries (m2/s)
  std::vector<double> wetting;      ///< what faces let into each particle (m2/s), >= 0
  std::vector<std::uint8_t> full;   ///< whether one of them let in all that the soil takes
  std::vector<double> inflow_rate;  ///< by each boundary (m2/s)
  AirFlow air_flow;                 ///< of the open faces, in sum
};

/// Pore water on particles, in soil whose retention and permeability are its own (paper, Eqs. 8-10): the state of the
/// water, what the soil is at it, and the books, exact in mass. Steps are taken by
///
///     CoupledStep   implicit, with a skeleton that moves
///     RigidStep     implicit and of any length, with one that does not
///     ExplicitStep  the paper's two-pass operator, for reference
///
/// each of which finds pressures and what flows under them, and has it booked.
///
/// What it is between two steps is its State and that of its head operator; all else is given once or worked out anew.
/// A copy goes on as the original does.
class PoreFlow {
 public:
  struct State {
    std::vector<double> pressure;     ///< P_w (Pa)
    std::vector<double> content;      ///< water of each particle at its last booking (m2)
    std::vector<double> defect;       ///< water that the last booking left unexplained (m2)
    std::vector<double> front_start;  ///< P_w before the water came that wets a particle from its face (Pa)
    std::vector<double> inflow;       ///< by each boundary since the start (m2)
    std::vector<double> inflow_rate;  ///< by each boundary in the latest step (m2/s)
    AirFlow air_flow;                 ///< of the open faces in the latest step, in sum

    template <class Self, class Visit>
    static void for_each_field(Self& s, const Visit& visit) {
      visit("pressure", s.pressure);
      visit("content", s.content);
      visit("defect", s.defect);
      visit("front_start", s.front_start);
      visit("inflow", s.inflow), visit("inflow_rate", s.inflow_rate);
      visit("air_flow", s.air_flow);
    }
    bool operator==(const State&) const = default;
  };

  /// @param soil  index into `soils` of each particle; @param pressure  initial P_w (Pa)
  /// @throws std::invalid_argument naming the field that the laws cannot take: not a number, out of its range, or not
  /// one for each particle
  PoreFlow(std::vector<Soil> soils, const Water& water, std::span<const std::uint16_t> soil,
           std::span<const double> pressure, const Skeleton& skeleton, const FlowSettings& settings);

  [[nodiscard]] const State& state() const { return state_; }
  /// Goes on from a state that one with the same soils had.
  /// @throws std::invalid_argument if there is not an entry for each particle
  void set_state(State state, HeadOperator::State head_operator);

  [[nodiscard]] std::size_t size() const { return soil_.size(); }                         ///< particles
  [[nodiscard]] std::span<const double> pressure() const { return state_.pressure; }      ///< P_w (Pa)
  [[nodiscard]] std::span<const double> suction() const { return suction_; }              ///< s = -P_w (Pa)
  [[nodiscard]] std::span<const double> saturation() const { return saturation_; }        ///< S_r (-)
  [[nodiscard]] std::span<const double> capacity() const { return capacity_; }            ///< dS_r/dP_w (1/Pa)
  [[nodiscard]] std::span<const double> pore_stress() const { return pore_stress_; }      ///< S_r P_w (Pa)
  [[nodiscard]] std::span<const double> pressure_head() const { return pressure_head_; }  ///< P_w / gamma_w (m)
  [[nodiscard]] const HeadOperator& head_operator() const { return operator_; }
  [[nodiscard]] const Water& water() const { return water_; }
  [[nodiscard]] const FlowSettings& settings() const { return settings_; }
  [[nodiscard]] const std::vector<Soil>& soils() const { return soils_; }
  [[nodiscard]] std::uint16_t soil_index(std::size_t p) const { return soil_[p]; }  ///< of a particle, in soils()
  [[nodiscard]] const Soil& soil(std::size_t p) const { return soils_[soil_[p]]; }  ///< of a particle

  /// k k_rw of a particle at its pressure (m/s).
  [[nodiscard]] double conductivity(std::size_t p) const;
  /// What a particle's soil conducts at its pressure, or at another one (Pa).
  [[nodiscard]] PotentialAt conductivity_at(std::size_t p) const;
  [[nodiscard]] PotentialAt conductivity_at(std::size_t p, double pressure) const;
  /// d(k k_rw)/dpsi of a particle at its pressure (1/s), >= 0.
  [[nodiscard]] double conductivity_slope(std::size_t p) const;
  /// Of the water that a face under a pressure (Pa) has let into its particle since it began to.
  [[nodiscard]] WettingFront wetting_front(std::size_t p, double face_pressure) const;
  /// Water in a particle at its pressure, at the water's reference density (m2).
  [[nodiscard]] double water_of(std::size_t p, const Skeleton& skeleton) const;

  /// Darcy's velocity w = -k k_rw grad h (m/s) (paper, Eq. 4 without the acceleration).
  void darcy_velocity(const Skeleton& skeleton, std::span<double> wx, std::span<double> wy) const;

  /// Water in the pores at the last booking, at its reference density (m2), and what has come in by each boundary since
  /// the start.
  [[nodiscard]] double stored_water() const;
  [[nodiscard]] std::span<const double> cumulative_inflow() const { return state_.inflow; }
  /// Net flow that each boundary brought in the latest step (m2/s).
  [[nodiscard]] std::span<const double> inflow_rate() const { return state_.inflow_rate; }
  /// What the open faces exchanged with the air in the latest step, in sum.
  [[nodiscard]] const AirFlow& air_flow() const { return state_.air_flow; }
  /// Water that the last solution left unexplained, summed over the particles (m2).
  [[nodiscard]] double unexplained_water() const;

  // What a step is made of.

  /// Takes up the skeleton's present positions.
  void follow(const Skeleton& skeleton) { operator_.update(skeleton); }
  /// Works the conductances of the head operator out at the present pressure. A particle counts as it was when it was
  /// last looked at until its pressure head has changed by a tolerance times the spacing, or its conductivity by about
  /// a tolerance of itself. @param tolerance  (-), >= 0; 0: it counts as it is
  void find_conductances(double tolerance);
  /// Goes to other pressures (Pa) and evaluates the soil at them; nothing is booked.
  void set_pressure(std::span<const double> pressure);
  /// Books the water of a step that ends at the present pressure: what is in the pores now, what came by the
  /// boundaries, and as defect what the flow does not explain of it. Held particles have none: theirs is what their
  /// boundary brought.
  /// @param skeleton  volumes and porosities after the step
  /// @throws SeepageError if a pressure or a balance is not a number
  void book(double time_step, const Skeleton& skeleton, const StepFlow& flow, std::span<const HeldPressure> held);

 private:
  void evaluate_soil();
  template <class Visit>
  void for_each_particle(const Visit& visit) const;
  [[nodiscard]] double reach_at(std::size_t p, double suction_head) const;
  void follow_front(std::size_t p, double gain, double time_step, const StepFlow& flow);
  void check_numbers() const;

  std::vector<Soil> soils_;
  Water water_;
  FlowSettings settings_;
  HeadOperator operator_;
  std::vector<std::uint16_t> soil_;
  std::vector<std::vector<std::uint32_t>> particles_of_soil_;

  State state_;
  std::vector<double> suction_, saturation_, pore_stress_, pressure_head_;
  std::vector<double> capacity_;  // dS_r/dP_w (1/Pa)
  // Change of a particle's pressure head up to which it counts as it was for its conductances, at a tolerance of 1 (m).
  std::vector<double> reach_;
};

}  // namespace slope::seepage
