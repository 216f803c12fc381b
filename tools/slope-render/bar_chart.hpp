#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "plot_frame.hpp"

namespace slope::tools {

/// A value and the ends of its interval; NaN: none.
struct Bar {
  double value = std::numeric_limits<double>::quiet_NaN();
  double lower = std::numeric_limits<double>::quiet_NaN();
  double upper = std::numeric_limits<double>::quiet_NaN();
};

/// A name and a bar of each kind.
struct BarRow {
  std::string name;
  std::vector<Bar> bars;
};

/// Horizontal bars from zero, row by row from above.
struct BarChart {
  std::string title;
  std::string x_title;
  Range range;                     ///< of the values
  std::vector<std::string> kinds;  ///< of bars, for the legend: at least one
  std::vector<BarRow> rows;        ///< at least one, with as many bars each
};

/// @throws couple::FileError if it cannot be written.
void write_bar_chart(const std::filesystem::path& file, int width, const BarChart& chart);

}  // namespace slope::tools
