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
    for (auto* v : {&residual_, &scaled_, &direction_, &image_}) v->resize(b.size());
    if (std::ranges::all_of(x, [](double value) { return value == 0.0; })) {
      std::ranges::fill(image_, 0.0);
    } else {
      apply(x, image_);
    }
    double rho = begin(diagonal, b, threads);
    const double target = tolerance * tolerance * norm(diagonal, b, threads);
    Result result;
    while (!(rho <= target)) {
      if (result.iterations == maximum_iterations || !std::isfinite(rho)) {
        result.converged = false;
        break;
      }
      apply(direction_, image_);
      const double next = go(rho / blocked_dot(direction_, image_, threads), diagonal, x, threads);
      turn(next / rho, threads);
      rho = next;
      ++result.iterations;
    }
    return result;
  }

 private:
  // b.D^-1.b
  [[nodiscard]] static double norm(std::span<const double> diagonal, std::span<const double> b, int threads);
  // The first residual and direction. @return r.D^-1.r
  double begin(std::span<const double> diagonal, std::span<const double> b, int threads);
  // x and the residual one step along the direction. @return r.D^-1.r
  double go(double alpha, std::span<const double> diagonal, std::span<double> x, int threads);
  // The next direction.
  void turn(double beta, int threads);

  std::vector<double> residual_, scaled_, direction_, image_;
};

}  // namespace slope::seepage
