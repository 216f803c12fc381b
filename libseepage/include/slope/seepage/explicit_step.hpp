#pragma once

#include <span>
#include <vector>

#include "slope/seepage/boundary_terms.hpp"
#include "slope/seepage/pore_flow.hpp"

namespace slope::seepage {

/// An explicit step with the paper's two-pass operator (Eqs. 18, 19), for reference: it is stable only for steps below
/// stable_step(), and on disordered particles not even then; it books the water that it loses as unexplained. From one
/// step to the next it remembers nothing.
class ExplicitStep {
 public:
  /// spacing^2 n gamma_w / (k K_w), the shortest over the particles: the time (s) in which a pressure crosses a spacing
  /// of saturated soil.
  [[nodiscard]] static double stable_step(const PoreFlow& flow, const Skeleton& skeleton);

  /// A whole step.
  /// @param vx, vy  velocity of the skeleton in the water's time (m/s)
  /// @throws SeepageError as PoreFlow::book() does
  void advance(PoreFlow& flow, double time_step, const Skeleton& skeleton, std::span<const double> vx,
               std::span<const double> vy, const Boundary& boundary);

 private:
  BoundaryTerms boundary_;
  std::vector<double> head_;                 // at the start of the step (m)
  std::vector<double> conductivity_;         // then (m/s)
  std::vector<double> wx_, wy_;              // Darcy's velocity (m/s)
  std::vector<double> skeleton_divergence_;  // (1/s)
  std::vector<double> change_, pressure_;    // of the pressure, and at the end of the step (Pa)
  StepFlow flow_;
};

}  // namespace slope::seepage
