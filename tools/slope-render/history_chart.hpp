#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "canvas.hpp"
#include "plot_frame.hpp"

namespace slope::tools {

/// A value over time at one point.
struct Curve {
  std::string name;  ///< "A1": curves of one letter share a colour, the number chooses the dashes
  std::vector<double> values;
};

/// A time that a chart marks.
struct TimeMark {
  double time = 0.0;  ///< (s)
  std::string name;   ///< before the time
};

/// Curves over time.
struct HistoryChart {
  std::string title;          ///< of the run
  std::string y_title;        ///< with unit
  std::vector<double> times;  ///< (s)
  std::vector<Curve> curves;
  std::optional<double> onset;                         ///< of failure (s)
  std::optional<TimeMark> other_onset = std::nullopt;  ///< by the criterion that the case did not choose; not drawn in
                                                       ///< stacked charts
};

/// @throws couple::FileError if it cannot be written.
void write_history_chart(const std::filesystem::path& file, int width, const HistoryChart& chart);

/// Charts one above the other, with one legend and one scale of the values for all of them; their times have one scale
/// too, unless the longest are more than `longest_ratio` times the shortest: then each has its own. A chart's title is
/// its caption, before which "(a)" is put.
/// @param charts  at least one, at most 26; the y title is that of the first.
/// @throws couple::FileError if it cannot be written.
void write_stacked_histories(const std::filesystem::path& file, int width, const std::vector<HistoryChart>& charts);

inline constexpr double longest_ratio = 5.0;

/// The time scale of each of the charts.
[[nodiscard]] std::vector<Range> time_ranges(const std::vector<HistoryChart>& charts);
/// The least range around zero that holds all values of the charts.
[[nodiscard]] Range common_values(const std::vector<HistoryChart>& charts);

}  // namespace slope::tools
