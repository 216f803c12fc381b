#include "bar_chart.hpp"

#include <algorithm>
#include <cmath>

#include "canvas.hpp"
#include "colour_maps.hpp"

namespace slope::tools {
namespace {

constexpr double bar_height = 0.9, row_gap = 0.7;  // em
constexpr double longest_name = 0.35;              // of the picture's width

double row_height(const BarChart& chart) {
  return bar_height * static_cast<double>(chart.kinds.size()) + row_gap;
}

/// The interval of a bar: a line with a tick at either end that is known and within the frame.
void draw_interval(Canvas& canvas, const PlotFrame& frame, const Bar& bar, double y) {
  const double em = canvas.em();
  const LineStyle line{0.08 * em, ink, {}};
  std::vector<Pixel> ends;
  for (const double end : {bar.lower, bar.upper}) {
    const double shown = std::clamp(std::isnan(end) ? bar.value : end, frame.x.low, frame.x.high);
    ends.push_back({frame.at(shown, frame.y.low).x, y});
    const double x = ends.back().x;
    if (shown == end) canvas.stroke({{x, y - 0.2 * em}, {x, y + 0.2 * em}}, line);
  }
  if (ends[1].x - ends[0].x >= 1.0) canvas.stroke(ends, line);
}

void draw_row(Canvas& canvas, const PlotFrame& frame, const BarRow& row, double top) {
  const double em = canvas.em();
  const double zero = frame.at(0.0, 0.0).x;
  double y = top - 0.5 * (row_gap + bar_height) * em;
  const double middle = y - 0.5 * bar_height * em * static_cast<double>(row.bars.size() - 1);
  canvas.fitted_text({frame.box.left - 0.6 * em, middle}, row.name, longest_name * canvas.width(),
                     {.anchor = Anchor::right});
  for (std::size_t k = 0; k < row.bars.size(); ++k, y -= bar_height * em) {
    const Bar& bar = row.bars[k];
    if (std::isnan(bar.value)) {
      canvas.text({zero + 0.4 * em, y}, "not known", {.scale = 0.8});
      continue;
    }
    const double end = frame.at(std::clamp(bar.value, frame.x.low, frame.x.high), 0.0).x;
    const double half = 0.38 * bar_height * em;
    canvas.fill({std::min(zero, end), y - half, std::max(zero, end), y + half}, curve_colour(k));
    draw_interval(canvas, frame, bar, y);
  }
}

}  // namespace

void write_bar_chart(const std::filesystem::path& file, int width, const BarChart& chart) {
  const double em = font_share * width;
  double names = 0.0;
  for (const BarRow& row : chart.rows) names = std::max(names, Canvas::text_width(row.name, em));
  const double legend = 1.6 * em * static_cast<double>(chart.kinds.size());
  const double rows = row_height(chart) * em * static_cast<double>(chart.rows.size());
  const double below = 3.5 * em, above = 2.2 * em + legend;
  Canvas canvas(width, static_cast<int>(std::lround(below + rows + above)), em);

  PlotFrame frame;
  frame.box = {std::min(names, longest_name * width) + 1.2 * em, below, width - 1.5 * em, below + rows};
  frame.x = chart.range;
  frame.y = {0.25, 0.75};  // without a tick: rows have names
  const Axis x = axis_for(chart.x_title, frame.x, frame.box.width(), 4.5 * em);
  draw_axes(canvas, frame, x, {"", 1.0}, true);

  double top = frame.box.top;
  for (const BarRow& row : chart.rows) {
    draw_row(canvas, frame, row, top);
    top -= row_height(chart) * em;
  }
  const double zero = frame.at(0.0, 0.0).x;
  canvas.stroke({{zero, frame.box.bottom}, {zero, frame.box.top}}, {0.08 * em, ink, {}});
  double row = canvas.height() - 1.05 * em;
  canvas.fitted_text({frame.box.left, row}, chart.title, frame.box.width());
  for (std::size_t k = 0; k < chart.kinds.size(); ++k) {
    row -= 1.6 * em;
    canvas.fill({frame.box.left, row - 0.35 * em, frame.box.left + 2.0 * em, row + 0.35 * em}, curve_colour(k));
    canvas.fitted_text({frame.box.left + 2.5 * em, row}, chart.kinds[k], frame.box.width() - 2.5 * em);
  }
  canvas.write_png(file);
}

}  // namespace slope::tools
