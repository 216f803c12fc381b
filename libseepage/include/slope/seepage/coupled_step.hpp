#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "slope/seepage/boundary_terms.hpp"
#include "slope/seepage/conjugate_gradients.hpp"
#include "slope/seepage/pore_flow.hpp"
#include "slope/seepage/volume_response.hpp"

namespace slope::seepage {

/// An implicit step of pore water in a skeleton that moves: solve() for the pressure change, with the volume change
/// that the skeleton makes on its own and the one that it makes in response; then, when the skeleton has moved,
/// finish(), which takes stock of the water and carries what is left to the next step. Time step and boundary are given
/// once and kept in between; from one step to the next it remembers nothing.
class CoupledStep {
 public:
  /// Finds the pressure change dP of a step from the mass balance of every particle:
  ///
  ///     [V (n S_r/K_w + C_s) + t L/gamma_w + S_r R S_r] dP = -S_r V e - t L h + boundary terms + defect
  ///
  /// by conjugate gradients with diagonal preconditioner. Where a particle gets so much wetter or drier that the slope
  /// of its retention curve does not hold, Newton's method follows the curve. What both leave is the next step's
  /// defect. Takes up the skeleton's positions; the water is otherwise as before.
  /// @param time_step  t (s), > 0; @param strain  volumetric strain e of the skeleton at unchanged pressure (-),
  /// expansion positive; @param response  R; @param tolerance  reduction of the residual, in (0, 1)
  SolveReport solve(PoreFlow& flow, double time_step, const Skeleton& skeleton, std::span<const double> strain,
                    const Boundary& boundary, const VolumeResponse& response, double tolerance);

  /// The pressure change found by solve() (Pa).
  [[nodiscard]] std::span<const double> pressure_change() const { return change_; }
  /// S_r dP of it (Pa).
  [[nodiscard]] std::span<const double> pore_stress_change() const { return stress_change_; }

  /// Adds the pressure change and has the water of the step booked. Once after each solve(), with the same flow.
  /// @param skeleton  volumes and porosities after the step
  /// @throws SeepageError as PoreFlow::book() does
  void finish(PoreFlow& flow, const Skeleton& skeleton);

 private:
  // Of what a particle stores in a step, over the pressure at its end.
  struct Tangent {
    std::size_t particle = 0;
    double offset = 0.0;   // (m2)
    double slope = 0.0;    // (m2/Pa)
    double touched = 0.0;  // (Pa)
  };

  void resize(std::size_t particles);
  void set_up(PoreFlow& flow, const Skeleton& skeleton, std::span<const double> strain, const Boundary& boundary,
              const VolumeResponse& response);
  void apply_full(const PoreFlow& flow, const VolumeResponse& response, std::span<const double> in,
                  std::span<double> out);
  void take_out_held(const PoreFlow& flow, const VolumeResponse& response);
  bool switch_terms(const PoreFlow& flow);
  [[nodiscard]] Tangent tangent_at(const PoreFlow& flow, std::size_t p, double pressure,
                                   const Skeleton& skeleton) const;
  bool follow_retention(const PoreFlow& flow, const Skeleton& skeleton, double tolerable);
  [[nodiscard]] double offset_share() const;

  double time_step_ = 0.0;   // of the step that is solved
  double flow_scale_ = 0.0;  // it over gamma_w
  bool solved_ = false;      // and not finished
  BoundaryTerms boundary_;
  std::vector<double> head_;        // at the start of the step, then at its end (m)
  std::vector<double> stiffness_;   // storage and boundary terms over the pressure (m2/Pa)
  std::vector<double> right_side_;  // (m2)
  std::vector<double> diagonal_;    // of the whole system (m2/Pa)
  std::vector<double> change_, stress_change_;
  // What a particle stores in the step is taken as offset + slope dP, the tangent at the pressure touched.
  std::vector<double> storage_offset_, storage_slope_, touched_;
  std::vector<Tangent> tangents_;
  std::vector<double> kinks_;                     // of the soils' retention curves (Pa)
  std::vector<double> stress_, volume_change_;    // what the response is asked, and answers
  std::vector<double> held_change_, held_water_;  // of the particles whose pressure is held, and what it asks of all
  std::vector<double> pressure_;                  // at the end of the step (Pa)
  StepFlow flow_;
  ConjugateGradients solver_;
};

}  // namespace slope::seepage
