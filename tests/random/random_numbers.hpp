#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace slope::random_cases {

/// Random numbers that are the same with every standard library: the engine is fixed by the standard, the distributions
/// are written out here.
class RandomNumbers {
 public:
  /// @param seed, stream  each pair begins a sequence of its own
  RandomNumbers(std::uint64_t seed, std::uint64_t stream);

  /// In [low, high).
  [[nodiscard]] double uniform(double low, double high);
  /// The same, even in the logarithm; low > 0.
  [[nodiscard]] double logarithmic(double low, double high);
  /// From low to high, both included.
  [[nodiscard]] int whole(int low, int high);
  [[nodiscard]] bool chance(double probability);
  /// Which of them, each as often as its weight says.
  [[nodiscard]] std::size_t index(std::initializer_list<double> weights);
  template <class Value>
  [[nodiscard]] Value one_of(std::initializer_list<Value> values) {
    return values.begin()[whole(0, static_cast<int>(values.size()) - 1)];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace slope::random_cases
