#include "slope/seepage/neighbours.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace slope::seepage {
namespace {

std::vector<std::vector<std::uint32_t>> brute_force(const std::vector<double>& x, const std::vector<double>& y,
                                                    double radius) {
  std::vector<std::vector<std::uint32_t>> result(x.size());
  for (std::uint32_t p = 0; p < x.size(); ++p) {
    for (std::uint32_t q = 0; q < x.size(); ++q) {
      if (p != q && std::pow(x[p] - x[q], 2) + std::pow(y[p] - y[q], 2) < radius * radius) result[p].push_back(q);
    }
  }
  return result;
}

TEST(Neighbours, AreThoseOfAllPairs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2.0, 3.0);
  std::vector<double> x(400), y(400);
  for (double& v : x) v = place(random);
  for (double& v : y) v = 0.3 * place(random);
  for (const double radius : {0.05, 0.4, 10.0}) {
    const auto expected = brute_force(x, y, radius);
    for (const int threads : {1, 2}) {
      const Neighbours found = find_neighbours(x, y, radius, threads);
      ASSERT_EQ(found.size(), x.size());
      for (std::size_t p = 0; p < x.size(); ++p) {
        const auto of_p = found.of(p);
        EXPECT_EQ(std::vector<std::uint32_t>(of_p.begin(), of_p.end()), expected[p]) << "particle " << p;
      }
    }
  }
}

TEST(Neighbours, OfNobodyAndOfOne) {
  EXPECT_EQ(find_neighbours({}, {}, 1.0).size(), 0u);
  const std::vector<double> one{0.5};
  const Neighbours alone = find_neighbours(one, one, 1.0);
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_TRUE(alone.of(0).empty());
}

}  // namespace
}  // namespace slope::seepage
