#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace slope::seepage {

/// Dot product summed in blocks of fixed size, so that the result does not depend on the number of threads.
[[nodiscard]] double blocked_dot(std::span<const double> a, std::span<const double> b, int threads);

/// Conjugate gradients with diagonal preconditioner for a symmetric positive definite operator that is given as a
/// function. Keeps its work vectors between calls.
class ConjugateGradients {
 public:
  struct Result {
    int iterations = 0;
    bool converged = true;
  };

  /// Solves A x = b from the x given (zeros save an application), until the residual in the norm of the inverse
  /// diagonal has come down to `tolerance` times that of x = 0.
  /// @param apply  callable (span<const double> in, span<double> out): out = A in
  /// @param diagonal  of A, > 0
  template <class Apply>
  Result solve(const Apply& apply, std::span<const double> diagonal, std::span<const double> b, std::span<double> x,
               double tolerance, int maximum_iterations, int threads) {
    const std::size_t n = b.size();
    for (auto* v : {&residual_, &scaled_, &direction_, &image_}) v->resize(n);
    double b_norm = 0.0;
    if (std::ranges::all_of(x, [](double value) { return value == 0.0; })) {
      std::ranges::fill(image_, 0.0);
    } else {
      apply(x, image_);
    }
    for (std::size_t i = 0; i < n; ++i) {
      residual_[i] = b[i] - image_[i];
      scaled_[i] = b[i] / diagonal[i];
    }
    b_norm = blocked_dot(b, scaled_, threads);
    for (std::size_t i = 0; i < n; ++i) {
      scaled_[i] = residual_[i] / diagonal[i];
      direction_[i] = scaled_[i];
    }
    double rho = blocked_dot(residual_, scaled_, threads);
    const double target = tolerance * tolerance * b_norm;
    Result result;
    while (!(rho <= target)) {
      if (result.iterations == maximum_iterations || !std::isfinite(rho)) {
        result.converged = false;
        break;
      }
      apply(direction_, image_);
      const double alpha = rho / blocked_dot(direction_, image_, threads);
      for (std::size_t i = 0; i < n; ++i) {
        x[i] += alpha * direction_[i];
        residual_[i] -= alpha * image_[i];
        scaled_[i] = residual_[i] / diagonal[i];
      }
      const double next = blocked_dot(residual_, scaled_, threads);
      const double beta = next / rho;
      for (std::size_t i = 0; i < n; ++i) direction_[i] = scaled_[i] + beta * direction_[i];
      rho = next;
      ++result.iterations;
    }
    return result;
  }

 private:
  std::vector<double> residual_, scaled_, direction_, image_;
};

}  // namespace slope::seepage
