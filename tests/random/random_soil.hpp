#pragma once

#include <string>

#include "random_numbers.hpp"

namespace slope::random_cases {

struct RandomSoil {
  std::string name;
  std::string yaml;   ///< an entry of the map `soils`
  std::string words;  ///< what it is: strength, retention and permeability, for the table
};

/// @param elastic  all soils of a slope that cannot fail are
[[nodiscard]] RandomSoil random_soil(RandomNumbers& random, const std::string& name, bool elastic);

}  // namespace slope::random_cases
