#pragma once

#include <string>
#include <vector>

#include "random_numbers.hpp"
#include "slope/couple/case.hpp"

namespace slope::random_cases {

/// The line of the ground and the grid around it, from the lower left corner of the domain.
struct RandomGround {
  double cell = 0.0, width = 0.0, height = 0.0;  ///< (m)
  int particles_per_cell = 4;
  std::vector<couple::Point> line;  ///< from left to right
  std::string word;                 ///< "level", "slope", "benches", "embankment"
  double low = 0.0, high = 0.0;     ///< lowest and highest y of the line (m)
  bool mirrored = false;            ///< the lower side is on the right

  [[nodiscard]] double height_at(double x) const;
  /// Lowest y of the line between two x.
  [[nodiscard]] double lowest(double from, double to) const;
  [[nodiscard]] double spacing() const;
};

[[nodiscard]] RandomGround random_ground(RandomNumbers& random);

/// A polygon that a soil fills inside the ground: a layer below the line, or a lens.
struct RandomRegion {
  std::vector<couple::Point> polygon;
  std::string word;
};
[[nodiscard]] RandomRegion random_layer(RandomNumbers& random, const RandomGround& ground);
[[nodiscard]] RandomRegion random_lens(RandomNumbers& random, const RandomGround& ground);

}  // namespace slope::random_cases
