#include "slope/seepage/conjugate_gradients.hpp"

#include <algorithm>
#include <array>

#include "for_each_index.hpp"

namespace slope::seepage {

namespace {

constexpr std::size_t block = 1024;

// term(0) + ... + term(n - 1), in blocks of fixed size.
template <class Term>
double blocked_sum(std::size_t n, int threads, const Term& term) {
  const auto sum_of = [&](std::size_t k) {
    const std::size_t first = k * block, last = std::min(first + block, n);
    // four running sums, in a fixed order
    std::array<double, 4> sum{};
    std::size_t i = first;
    for (; i + 4 <= last; i += 4) {
      for (std::size_t j = 0; j < 4; ++j) sum[j] += term(i + j);
    }
    for (; i < last; ++i) sum[0] += term(i);
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
  };
  const std::size_t blocks = (n + block - 1) / block;
  double total = 0.0;
  if (threads <= 1 || n <= few_products) {
    for (std::size_t k = 0; k < blocks; ++k) total += sum_of(k);
    return total;
  }
  std::vector<double> partial(blocks);
  for_each_index(
      blocks, threads, [&](std::size_t k) { partial[k] = sum_of(k); }, 1);
  for (const double value : partial) total += value;
  return total;
}

}  // namespace

double blocked_dot(std::span<const double> a, std::span<const double> b, int threads) {
  return blocked_sum(a.size(), threads, [&](std::size_t i) { return a[i] * b[i]; });
}

double ConjugateGradients::norm(std::span<const double> diagonal, std::span<const double> b, int threads) {
  return blocked_sum(b.size(), threads, [&](std::size_t i) { return b[i] * (b[i] / diagonal[i]); });
}

double ConjugateGradients::begin(std::span<const double> diagonal, std::span<const double> b, int threads) {
  return blocked_sum(b.size(), threads, [&](std::size_t i) {
    residual_[i] = b[i] - image_[i];
    scaled_[i] = residual_[i] / diagonal[i];
    direction_[i] = scaled_[i];
    return residual_[i] * scaled_[i];
  });
}

double ConjugateGradients::go(double alpha, std::span<const double> diagonal, std::span<double> x, int threads) {
  return blocked_sum(x.size(), threads, [&](std::size_t i) {
    x[i] += alpha * direction_[i];
    residual_[i] -= alpha * image_[i];
    scaled_[i] = residual_[i] / diagonal[i];
    return residual_[i] * scaled_[i];
  });
}

void ConjugateGradients::turn(double beta, int threads) {
  const auto add = [&](std::size_t i) { direction_[i] = scaled_[i] + beta * direction_[i]; };
  for_each_index(scaled_.size(), threads, add, few_products);
}

}  // namespace slope::seepage
