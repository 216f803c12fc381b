#include "slope/seepage/conjugate_gradients.hpp"

#include <algorithm>
#include <array>

namespace slope::seepage {

double blocked_dot(std::span<const double> a, std::span<const double> b, int threads) {
  constexpr std::size_t block = 1024;
  const auto sum_of = [&](std::size_t first) {
    const std::size_t last = std::min(first + block, a.size());
    // four running sums, in a fixed order
    std::array<double, 4> sum{};
    std::size_t i = first;
    for (; i + 4 <= last; i += 4) {
      for (std::size_t k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
    }
    for (; i < last; ++i) sum[0] += a[i] * b[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
  };
  const std::size_t blocks = (a.size() + block - 1) / block;
  if (threads <= 1) {
    double total = 0.0;
    for (std::size_t k = 0; k < blocks; ++k) total += sum_of(k * block);
    return total;
  }
  std::vector<double> partial(blocks);
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t k = 0; k < blocks; ++k) partial[k] = sum_of(k * block);
  double total = 0.0;
  for (const double value : partial) total += value;
  return total;
}

}  // namespace slope::seepage
