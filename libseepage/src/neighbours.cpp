#include "slope/seepage/neighbours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "for_each_index.hpp"

namespace slope::seepage {

namespace {

// Particles in square bins as wide as the search radius, by counting sort.
class Bins {
 public:
  Bins(std::span<const double> x, std::span<const double> y, double width) {
    const auto [x_min, x_max] = std::ranges::minmax(x);
    const auto [y_min, y_max] = std::ranges::minmax(y);
    columns_ = static_cast<std::size_t>((x_max - x_min) / width) + 1;
    rows_ = static_cast<std::size_t>((y_max - y_min) / width) + 1;
    std::vector<std::size_t> bin(x.size());
    start_.assign(columns_ * rows_ + 1, 0);
    for (std::size_t p = 0; p < x.size(); ++p) {
      const auto column = static_cast<std::size_t>((x[p] - x_min) / width);
      const auto row = static_cast<std::size_t>((y[p] - y_min) / width);
      bin[p] = row * columns_ + column;
      ++start_[bin[p] + 1];
    }
    for (std::size_t b = 0; b + 1 < start_.size(); ++b) start_[b + 1] += start_[b];
    member_.resize(x.size());
    place_.resize(x.size());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t p = 0; p < x.size(); ++p) {
      member_[next[bin[p]]++] = static_cast<std::uint32_t>(p);
      place_[p] = bin[p];
    }
  }

  template <class Visit>
  void visit_around(std::size_t p, Visit&& visit) const {
    const std::size_t column = place_[p] % columns_;
    const std::size_t row = place_[p] / columns_;
    const std::size_t first = column == 0 ? 0 : column - 1;
    const std::size_t last = std::min(column + 1, columns_ - 1);
    for (std::size_t r = row == 0 ? 0 : row - 1; r <= std::min(row + 1, rows_ - 1); ++r) {
      for (std::size_t s = start_[r * columns_ + first]; s < start_[r * columns_ + last + 1]; ++s) visit(member_[s]);
    }
  }

 private:
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::size_t> start_, place_;
  std::vector<std::uint32_t> member_;
};

}  // namespace

Neighbours find_neighbours(std::span<const double> x, std::span<const double> y, double radius, int threads) {
  Neighbours result;
  const std::size_t n = x.size();
  result.start.assign(n + 1, 0);
  if (n == 0) return result;
  const Bins bins(x, y, radius);
  const double squared = radius * radius;
  const auto near = [&](std::size_t p, std::uint32_t q) {
    const double dx = x[p] - x[q], dy = y[p] - y[q];
    return q != p && dx * dx + dy * dy < squared;
  };
  for_each_index(n, threads, [&](std::size_t p) {
    std::size_t count = 0;
    bins.visit_around(p, [&](std::uint32_t q) { count += near(p, q) ? 1 : 0; });
    result.start[p + 1] = count;
  });
  for (std::size_t p = 0; p < n; ++p) result.start[p + 1] += result.start[p];
  result.index.resize(result.start[n]);
  for_each_index(n, threads, [&](std::size_t p) {
    std::size_t s = result.start[p];
    bins.visit_around(p, [&](std::uint32_t q) {
      if (near(p, q)) result.index[s++] = q;
    });
    std::sort(result.index.begin() + static_cast<std::ptrdiff_t>(result.start[p]),
              result.index.begin() + static_cast<std::ptrdiff_t>(s));
  });
  return result;
}

}  // namespace slope::seepage
