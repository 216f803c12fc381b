#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slope::seepage {

/// Neighbours of every particle within a radius, in compressed rows: those of p are
/// index[start[p]] ... index[start[p + 1] - 1], in ascending order, p itself left out. Symmetric.
struct Neighbours {
  std::vector<std::size_t> start;
  std::vector<std::uint32_t> index;

  [[nodiscard]] std::size_t size() const { return start.empty() ? 0 : start.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t p) const {
    return {index.data() + start[p], start[p + 1] - start[p]};
  }
  bool operator==(const Neighbours&) const = default;
};

/// Finds the pairs closer than `radius` (m, > 0); cost linear in the particles.
[[nodiscard]] Neighbours find_neighbours(std::span<const double> x, std::span<const double> y, double radius,
                                         int threads = 1);

}  // namespace slope::seepage
