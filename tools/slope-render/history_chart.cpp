#include "history_chart.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "colour_maps.hpp"
#include "plot_frame.hpp"

namespace slope::tools {
namespace {

constexpr double font_share = 0.0225;
constexpr double aspect = 9.0 / 16.0;

/// Colour by the letters of the curves' names, dashes by the order within a letter; pale for the largest of all.
std::vector<LineStyle> line_styles(const std::vector<Curve>& curves, double em) {
  const std::vector<std::vector<double>> dashes{
      {}, {0.7 * em, 0.3 * em}, {0.16 * em, 0.24 * em}, {0.7 * em, 0.25 * em, 0.16 * em, 0.25 * em}};
  std::map<std::string, std::pair<std::size_t, std::size_t>> families;  // colour, members so far
  std::vector<LineStyle> styles;
  for (const Curve& curve : curves) {
    std::string family = curve.name;
    while (family.size() > 1 && std::isdigit(static_cast<unsigned char>(family.back())) != 0) {
      family.pop_back();
    }
    if (family == "largest") {
      styles.push_back({0.3 * em, {175, 175, 175}, {}});  // broad and pale: often another curve lies on it
      continue;
    }
    auto& [colour, members] = families.try_emplace(family, families.size(), 0U).first->second;
    styles.push_back({0.12 * em, curve_colour(colour), dashes[members++ % dashes.size()]});
  }
  return styles;
}

std::vector<Pixel> to_pixels(const PlotFrame& frame, const std::vector<double>& times,
                             const std::vector<double>& values) {
  std::vector<Pixel> points;
  for (std::size_t i = 0; i < std::min(times.size(), values.size()); ++i) {
    if (std::isfinite(values[i])) {
      points.push_back(frame.at(times[i], values[i]));
    }
  }
  return thinned(points, 1.0);
}

Range values_range(const std::vector<Curve>& curves) {
  Range range{0.0, 0.0};
  for (const Curve& curve : curves) {
    for (const double value : curve.values) {
      if (std::isfinite(value)) {
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
      }
    }
  }
  if (range.length() == 0.0) {
    range.high = 1.0;
  }
  return range;
}

}  // namespace

void write_history_chart(const std::filesystem::path& file, int width, const HistoryChart& chart) {
  const double em = font_share * width;
  Canvas canvas(width, static_cast<int>(std::lround(aspect * width)), em);

  double names = 0.0;
  for (const Curve& curve : chart.curves) {
    names = std::max(names, canvas.text_width(curve.name));
  }
  const double sample = 2.4 * em;
  const double bottom = room_below(canvas) + 0.4 * em;
  const double top = canvas.height() - (chart.onset ? 3.7 : 2.2) * em;
  const double right = width - names - sample - 2.8 * em;

  PlotFrame frame;
  frame.x = {0.0, chart.times.empty() || chart.times.back() <= 0.0 ? 1.0 : chart.times.back()};
  const Range values = values_range(chart.curves);
  const Axis y{chart.y_title, round_step(values, (top - bottom) / (2.8 * em))};
  frame.y = widened(values, 0.5 * y.step);
  frame.box = {room_on_the_left(canvas, frame.y, y), bottom, right, top};
  draw_axes(canvas, frame, axis_for("Time t (s)", frame.x, frame.box.width(), 5.0 * em), y, true);

  const auto styles = line_styles(chart.curves, em);
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    canvas.stroke(to_pixels(frame, chart.times, chart.curves[i].values), styles[i]);
    const double row = top - (0.7 + 1.5 * static_cast<double>(i)) * em;
    canvas.stroke({{right + 1.2 * em, row}, {right + 1.2 * em + sample, row}}, styles[i]);
    canvas.text({right + 1.7 * em + sample, row}, chart.curves[i].name);
  }
  if (chart.onset) {
    const double x = frame.at(*chart.onset, 0.0).x;
    canvas.stroke({{x, bottom}, {x, top}}, {0.08 * em, ink, {0.4 * em, 0.3 * em}});
    const std::string note = "onset of failure, t = " + time_text(*chart.onset);
    const double half = 0.5 * canvas.text_width(note);
    const double centre = std::clamp(x, frame.box.left + half, std::max(right - half, frame.box.left + half));
    canvas.text({centre, top + 0.85 * em}, note, {.anchor = Anchor::centre});
  }
  canvas.fitted_text({frame.box.left, canvas.height() - 1.05 * em}, chart.title, width - frame.box.left - em);
  canvas.write_png(file);
}

}  // namespace slope::tools
