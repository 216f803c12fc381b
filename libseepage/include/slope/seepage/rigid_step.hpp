#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "slope/seepage/boundary_terms.hpp"
#include "slope/seepage/neighbours.hpp"
#include "slope/seepage/pore_flow.hpp"

namespace slope::seepage {

/// An implicit step of pore water in a skeleton that does not move, of any length: backward Euler by Newton's method on
/// an assembled matrix, at first with lagged permeability. From one step to the next it remembers nothing but how the
/// matrix is filled and ordered, which it works out anew when the neighbours are others; a copy does so at once.
class RigidStep {
 public:
  /// A whole step. If it does not converge, nothing has changed.
  /// @param tolerance_pressure  largest change of a pressure in the last iteration (Pa), > 0
  /// @throws SeepageError as PoreFlow::book() does
  SolveReport advance(PoreFlow& flow, double time_step, const Skeleton& skeleton, const Boundary& boundary,
                      double tolerance_pressure, int maximum_iterations = 20);

  /// Of the pressures in the latest step that converged (Pa); empty before that.
  [[nodiscard]] std::span<const double> pressure_change() const { return change_; }

 private:
  struct Assembled {
    Assembled() = default;
    Assembled(const Assembled& /*other*/) {}
    Assembled& operator=(const Assembled& /*other*/) {
      neighbours = {};
      ordering_known = false;
      return *this;
    }
    ~Assembled() = default;

    Neighbours neighbours;  // those that matrix and lagged_factorisation fit
    Eigen::SparseMatrix<double> matrix;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> lagged_factorisation;
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factorisation;
    bool ordering_known = false;  // whether factorisation fits the matrix
  };

  // What is lacking, as a norm (m2), and what of that may be rounding.
  struct Imbalance {
    double norm = 0.0, rounding = 0.0;
  };

  void find_pattern(const Neighbours& neighbours);
  void assemble(const PoreFlow& flow, bool lagged);
  Imbalance find_imbalance(PoreFlow& flow, const Skeleton& skeleton, const Boundary& boundary);
  Imbalance go_to(PoreFlow& flow, const std::vector<double>& pressure, double share, const Skeleton& skeleton,
                  const Boundary& boundary);
  bool find_pressure_step(const PoreFlow& flow, bool lagged);
  void find_drying_onsets(const PoreFlow& flow);

  double time_step_ = 0.0;   // of the present step (s)
  double flow_scale_ = 0.0;  // it over gamma_w
  BoundaryTerms boundary_;
  std::vector<std::uint8_t> is_held_;
  std::vector<double> drying_onset_;  // of each particle: P_w at which its conductivity has begun to fall (Pa)
  std::vector<double> head_;          // at the present pressure (m)
  std::vector<double> stiffness_;     // storage and boundary terms over the pressure (m2/Pa)
  std::vector<double> lacking_;       // water of each particle at the present pressure (m2)
  std::vector<double> step_;          // of Newton's method (Pa)
  std::vector<double> pressure_;      // that it leads to (Pa)
  std::vector<double> change_;
  StepFlow flow_;
  Assembled assembled_;
};

}  // namespace slope::seepage
