#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace slope::random_cases {

/// A valid case, in the words of the case format, and what it is about.
struct RandomCase {
  std::string yaml;
  std::map<std::string, std::string> tables;             ///< files that it names, by their names
  std::string ground, soils, water, conditions, scheme;  ///< for the table of outcomes
};

/// Case number k of a seed: the same text on every machine.
[[nodiscard]] RandomCase random_case(std::uint64_t seed, std::uint64_t number);

}  // namespace slope::random_cases
