#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "canvas.hpp"

namespace slope::tools {

/// A value over time at one point.
struct Curve {
  std::string name;  ///< "A1": curves of one letter share a colour, the number chooses the dashes
  std::vector<double> values;
};

/// Curves over time.
struct HistoryChart {
  std::string title;          ///< of the run
  std::string y_title;        ///< with unit
  std::vector<double> times;  ///< (s)
  std::vector<Curve> curves;
  std::optional<double> onset;  ///< of failure (s)
};

/// @throws couple::FileError if it cannot be written.
void write_history_chart(const std::filesystem::path& file, int width, const HistoryChart& chart);

}  // namespace slope::tools
