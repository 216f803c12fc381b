#pragma once

#include <map>
#include <string>

#include "random_ground.hpp"
#include "random_numbers.hpp"

namespace slope::random_cases {

/// Where a case lies and how long it runs, which its conditions have to know.
struct Frame {
  RandomGround ground;
  double left = 0.0, bottom = 0.0;  ///< lower left corner of the domain (m)
  double duration = 0.0;            ///< (s)
  bool water_alone = false;
};

/// The initial water and the water boundaries, which must fit each other.
struct RandomWater {
  std::string initial;                        ///< value of `initial.water`
  std::string boundaries;                     ///< items of `water_boundaries`
  std::map<std::string, std::string> tables;  ///< of rain
  std::string initial_word, boundary_words;
};

[[nodiscard]] RandomWater random_water(RandomNumbers& random, const Frame& frame);

}  // namespace slope::random_cases
