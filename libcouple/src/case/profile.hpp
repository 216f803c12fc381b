#pragma once

#include <string>
#include <vector>

#include "input.hpp"
#include "slope/couple/case.hpp"

namespace slope::couple {

/// A line drawn in a CSV file, as a case names it.
struct ProfileText {
  std::string file;       ///< path from the folder of the case file
  std::string x = "x_m";  ///< names of the columns, with their unit at the end: "x_m", "x [cm]"
  std::string y = "y_m";
  double depth = 0.0;  ///< how far below the line the region begins (m)
};

/// The points of the line (m), from left to right; equal x make a vertical step. Lines that begin with # are comments.
/// @param place  where the case names the file; takes what is wrong, with the line of the table that it stands in
/// @return no points if something is wrong
[[nodiscard]] std::vector<Point> read_profile(const Input& place, const ProfileText& profile);

/// What lies between a line, lowered by a depth, and a level base, over the width of the domain (corners in order, m).
/// Where the line is below the base there is nothing.
/// @param line  as read_profile() gives it; it covers the domain
[[nodiscard]] std::vector<Point> region_below(const std::vector<Point>& line, double depth, double base,
                                              const Domain& domain);

}  // namespace slope::couple
