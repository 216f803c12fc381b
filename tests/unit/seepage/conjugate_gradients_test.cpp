#include "slope/seepage/conjugate_gradients.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>
#include <random>

namespace slope::seepage {
namespace {

TEST(BlockedDot, DoesNotDependOnTheThreads) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (const std::size_t n : {0u, 1u, 5u, 1023u, 1024u, 1025u, 40000u}) {
    std::vector<double> a(n), b(n);
    for (double& v : a) v = normal(random);
    for (double& v : b) v = normal(random);
    const double one = blocked_dot(a, b, 1);
    EXPECT_NEAR(one, std::inner_product(a.begin(), a.end(), b.begin(), 0.0), 1e-10);
    for (const int threads : {2, 3}) EXPECT_EQ(blocked_dot(a, b, threads), one) << n << " entries";
  }
}

TEST(ConjugateGradients, DoNotDependOnTheThreads) {
  constexpr std::size_t n = 40000;
  const auto apply = [](std::span<const double> in, std::span<double> out) {
    for (std::size_t i = 0; i < n; ++i) {
      out[i] = 3.0 * in[i] - (i > 0 ? in[i - 1] : 0.0) - (i + 1 < n ? in[i + 1] : 0.0);
    }
  };
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  std::vector<double> b(n);
  for (double& v : b) v = normal(random);
  const auto solution = [&](int threads) {
    std::vector<double> x(n, 0.0);
    ConjugateGradients solver;
    EXPECT_TRUE(solver.solve(apply, std::vector<double>(n, 3.0), b, x, 1.0e-8, 100, threads).converged);
    return x;
  };
  const std::vector<double> one = solution(1);
  EXPECT_EQ(solution(2), one);
  EXPECT_EQ(solution(3), one);
}

class RandomSystem : public ::testing::Test {
 protected:
  RandomSystem() {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd a(n, n);
    for (int i = 0; i < n * n; ++i) a.data()[i] = normal(random);
    matrix = a * a.transpose() + Eigen::MatrixXd::Identity(n, n);
    diagonal.resize(n);
    b.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      diagonal[i] = matrix(static_cast<int>(i), static_cast<int>(i));
      b[i] = normal(random);
    }
  }
  auto solve(std::vector<double>& x, double tolerance, int iterations) {
    const auto apply = [&](std::span<const double> in, std::span<double> out) {
      Eigen::Map<Eigen::VectorXd>(out.data(), n) = matrix * Eigen::Map<const Eigen::VectorXd>(in.data(), n);
    };
    return solver.solve(apply, diagonal, b, x, tolerance, iterations, 1);
  }

  static constexpr int n = 40;
  Eigen::MatrixXd matrix;
  std::vector<double> diagonal, b;
  ConjugateGradients solver;
};

TEST_F(RandomSystem, IsSolved) {
  const Eigen::VectorXd exact = matrix.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(b.data(), n));
  std::vector<double> x(n, 0.0);
  const auto result = solve(x, 1.0e-12, 500);
  EXPECT_TRUE(result.converged);
  for (int i = 0; i < n; ++i) EXPECT_NEAR(x[static_cast<std::size_t>(i)], exact[i], 1e-9);
  // from the solution there is nothing left to do
  EXPECT_EQ(solve(x, 1.0e-6, 500).iterations, 0);
}

TEST_F(RandomSystem, SaysWhenItDidNotGetThere) {
  std::vector<double> x(n, 0.0);
  const auto result = solve(x, 1.0e-12, 3);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 3);
}

TEST_F(RandomSystem, WithoutALoadStaysAtZero) {
  b.assign(n, 0.0);
  std::vector<double> x(n, 0.0);
  const auto result = solve(x, 1.0e-6, 100);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 0);
  for (const double v : x) EXPECT_EQ(v, 0.0);
}

}  // namespace
}  // namespace slope::seepage
