#pragma once

#include <string>
#include <vector>

#include "canvas.hpp"

namespace slope::tools {

struct Range {
  double low = 0.0;
  double high = 1.0;

  [[nodiscard]] double length() const { return high - low; }
};

/// 1, 2 or 5 times a power of ten, such that a range holds about `count` steps.
[[nodiscard]] double round_step(const Range& range, double count);
/// The multiples of a step in a range.
[[nodiscard]] std::vector<double> multiples(const Range& range, double step);
/// The range widened to multiples of a step.
[[nodiscard]] Range widened(const Range& range, double step);
/// A multiple of a step, with the decimals that the step asks for and a true minus sign.
[[nodiscard]] std::string number_text(double value, double step);
/// The widest of the numbers at the multiples of a step (pixels).
[[nodiscard]] double widest_number(const Canvas& canvas, const Range& range, double step);
/// A caption with "(a) ", "(b) ", ... before it.
[[nodiscard]] std::string lettered(std::size_t index, const std::string& caption);

/// A rectangle of a picture with axes: maps data to pixels.
struct PlotFrame {
  Box box;
  Range x;
  Range y;

  [[nodiscard]] Pixel at(double data_x, double data_y) const {
    return {box.left + (data_x - x.low) / x.length() * box.width(),
            box.bottom + (data_y - y.low) / y.length() * box.height()};
  }
};

/// One axis: its title and the distance of its ticks.
struct Axis {
  std::string title;
  double step = 1.0;
};

/// An axis with as many ticks as its length (pixels) has room for.
[[nodiscard]] Axis axis_for(const std::string& title, const Range& range, double length, double room_per_tick);

/// Frame, ticks, numbers and titles; with `grid`, faint lines at the ticks.
void draw_axes(Canvas& canvas, const PlotFrame& frame, const Axis& x, const Axis& y, bool grid);

/// Room (pixels) that draw_axes() needs to the left of the frame, and below it.
[[nodiscard]] double room_on_the_left(const Canvas& canvas, const Range& y, const Axis& axis);
[[nodiscard]] double room_below(const Canvas& canvas);

}  // namespace slope::tools
