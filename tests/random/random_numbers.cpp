#include "random_numbers.hpp"

#include <cmath>
#include <numeric>

namespace slope::random_cases {

namespace {

/// Scatters the bits, so that neighbouring seeds begin sequences that have nothing in common (splitmix64, Steele, Lea
/// and Flood, Fast splittable pseudorandom number generators, OOPSLA 2014, doi:10.1145/2660193.2660195).
std::uint64_t scattered(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31U);
}

}  // namespace

RandomNumbers::RandomNumbers(std::uint64_t seed, std::uint64_t stream) : engine_(scattered(scattered(seed) + stream)) {}

double RandomNumbers::uniform(double low, double high) {
  constexpr double of_53_bits = 0x1.0p-53;
  return low + (high - low) * (static_cast<double>(engine_() >> 11U) * of_53_bits);
}

double RandomNumbers::logarithmic(double low, double high) {
  return low * std::pow(high / low, uniform(0.0, 1.0));
}

int RandomNumbers::whole(int low, int high) {
  return low + static_cast<int>(uniform(0.0, static_cast<double>(high - low + 1)));
}

bool RandomNumbers::chance(double probability) {
  return uniform(0.0, 1.0) < probability;
}

std::size_t RandomNumbers::index(std::initializer_list<double> weights) {
  double left = uniform(0.0, std::accumulate(weights.begin(), weights.end(), 0.0));
  std::size_t chosen = 0;
  for (const double weight : weights) {
    if (left < weight || chosen + 1 == weights.size()) break;
    left -= weight;
    ++chosen;
  }
  return chosen;
}

}  // namespace slope::random_cases
