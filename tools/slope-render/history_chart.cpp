#include "history_chart.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "colour_maps.hpp"
#include "plot_frame.hpp"
#include "time_unit.hpp"

namespace slope::tools {
namespace {

constexpr double aspect = 9.0 / 16.0;
constexpr double stacked_aspect = 0.25;  // of each chart's frame, over the picture's width

/// The styles of curves by their names.
using Styles = std::map<std::string, LineStyle>;

/// "B" of "B1".
std::string family_of(std::string name) {
  while (name.size() > 1 && std::isdigit(static_cast<unsigned char>(name.back())) != 0) {
    name.pop_back();
  }
  return name;
}

/// Colour by the letters of the curves' names, dashes by the order within a letter; if there is but one letter, each
/// curve has a colour. Pale for the largest of all.
Styles line_styles(const std::vector<std::string>& names, double em) {
  const std::vector<std::vector<double>> dashes{
      {}, {0.7 * em, 0.3 * em}, {0.16 * em, 0.24 * em}, {0.7 * em, 0.25 * em, 0.16 * em, 0.25 * em}};
  const bool one_family =
      std::ranges::all_of(names, [&names](const auto& name) { return family_of(name) == family_of(names.front()); });
  std::map<std::string, std::pair<std::size_t, std::size_t>> families;  // colour, members so far
  Styles styles;
  for (const auto& name : names) {
    const std::string family = family_of(name);
    if (family == "largest") {
      styles[name] = {0.3 * em, {175, 175, 175}, {}};  // broad and pale: often another curve lies on it
      continue;
    }
    auto& [colour, members] = families.try_emplace(family, families.size(), 0U).first->second;
    styles[name] = {0.12 * em, curve_colour(one_family ? members : colour), dashes[members % dashes.size()]};
    ++members;
  }
  return styles;
}

/// `times` in s, the frame's axis in a unit of so many.
std::vector<Pixel> to_pixels(const PlotFrame& frame, const std::vector<double>& times,
                             const std::vector<double>& values, const TimeUnit& unit) {
  std::vector<Pixel> points;
  for (std::size_t i = 0; i < std::min(times.size(), values.size()); ++i) {
    if (std::isfinite(values[i])) {
      points.push_back(frame.at(times[i] / unit.seconds, values[i]));
    }
  }
  return thinned(points, 1.0);
}

/// Every name once, in the order of the charts.
std::vector<std::string> curve_names(const std::vector<HistoryChart>& charts) {
  std::vector<std::string> names;
  for (const auto& chart : charts) {
    for (const auto& curve : chart.curves) {
      if (std::ranges::find(names, curve.name) == names.end()) {
        names.push_back(curve.name);
      }
    }
  }
  return names;
}

void draw_curves(Canvas& canvas, const PlotFrame& frame, const HistoryChart& chart, const TimeUnit& unit,
                 const Styles& styles) {
  if (frame.y.low < 0.0 && frame.y.high > 0.0) {
    canvas.stroke({frame.at(frame.x.low, 0.0), frame.at(frame.x.high, 0.0)}, {0.05 * canvas.em(), ink, {}});
  }
  for (const Curve& curve : chart.curves) {
    canvas.stroke(to_pixels(frame, chart.times, curve.values, unit), styles.at(curve.name));
  }
}

/// A line at a time and, so many em above the frame, its name and the time, not further to the left than `leftmost`;
/// nothing for a time outside of the frame.
void draw_mark(Canvas& canvas, const PlotFrame& frame, const TimeMark& mark, const std::vector<double>& dashes,
               double above, const TimeUnit& unit, double leftmost) {
  if (mark.time / unit.seconds < frame.x.low || mark.time / unit.seconds > frame.x.high) {
    return;
  }
  const double em = canvas.em();
  const Box& box = frame.box;
  const double x = frame.at(mark.time / unit.seconds, 0.0).x;
  canvas.stroke({{x, box.bottom}, {x, box.top}}, {0.08 * em, ink, dashes});
  const std::string note = mark.name + ", t = " + time_text(mark.time, unit);
  const double half = 0.5 * canvas.text_width(note);
  const double centre = std::max(std::min(x, box.right - half), leftmost + half);
  canvas.text({centre, box.top + above * em}, note, {.anchor = Anchor::centre});
}

void draw_onset(Canvas& canvas, const PlotFrame& frame, double onset, const TimeUnit& unit, double leftmost) {
  const double em = canvas.em();
  draw_mark(canvas, frame, {onset, "onset of failure"}, {0.4 * em, 0.3 * em}, 0.85, unit, leftmost);
}

void draw_other_onset(Canvas& canvas, const PlotFrame& frame, const TimeMark& mark, const TimeUnit& unit) {
  const double em = canvas.em();
  draw_mark(canvas, frame, mark, {0.1 * em, 0.3 * em}, 2.15, unit, frame.box.left);
}

constexpr double sample_length = 2.4;  // em

/// Room (pixels) to the right of the frame that the legend needs.
double legend_room(const Canvas& canvas, const std::vector<std::string>& names) {
  double widest = 0.0;
  for (const auto& name : names) {
    widest = std::max(widest, canvas.text_width(name));
  }
  return widest + (sample_length + 2.8) * canvas.em();
}

void draw_legend(Canvas& canvas, Pixel upper_left, const std::vector<std::string>& names, const Styles& styles) {
  const double em = canvas.em();
  double row = upper_left.y - 0.7 * em;
  for (const auto& name : names) {
    const double left = upper_left.x + 1.2 * em;
    canvas.stroke({{left, row}, {left + sample_length * em, row}}, styles.at(name));
    canvas.text({left + (sample_length + 0.5) * em, row}, name);
    row -= 1.5 * em;
  }
}

Range times_of(const HistoryChart& chart) {
  constexpr double shortest = 1.0e-9;  // s
  return {0.0, chart.times.empty() || chart.times.back() < shortest ? 1.0 : chart.times.back()};
}

Range in_unit(const Range& times, const TimeUnit& unit) {
  return {times.low / unit.seconds, times.high / unit.seconds};
}

std::string time_title(const TimeUnit& unit) {
  return "Time t (" + unit.name + ")";
}

}  // namespace

std::vector<Range> time_ranges(const std::vector<HistoryChart>& charts) {
  std::vector<Range> ranges;
  for (const auto& chart : charts) {
    ranges.push_back(times_of(chart));
  }
  const auto [shortest, longest] = std::ranges::minmax_element(ranges, {}, &Range::high);
  if (longest->high <= longest_ratio * shortest->high) {
    ranges.assign(ranges.size(), Range(*longest));
  }
  return ranges;
}

Range common_values(const std::vector<HistoryChart>& charts) {
  Range range{0.0, 0.0};
  for (const auto& chart : charts) {
    for (const Curve& curve : chart.curves) {
      for (const double value : curve.values) {
        if (std::isfinite(value)) {
          range.low = std::min(range.low, value);
          range.high = std::max(range.high, value);
        }
      }
    }
  }
  constexpr double smallest = 1.0e-30;
  if (range.length() < smallest) {
    range.high = 1.0;
  }
  return range;
}

void write_history_chart(const std::filesystem::path& file, int width, const HistoryChart& chart) {
  const double em = font_share * width;
  Canvas canvas(width, static_cast<int>(std::lround(aspect * width)), em);
  const auto names = curve_names({chart});
  const double bottom = room_below(canvas) + 0.4 * em;
  const double top = canvas.height() - (chart.other_onset ? 5.0 : chart.onset ? 3.7 : 2.2) * em;
  const double right = width - legend_room(canvas, names);

  PlotFrame frame;
  const TimeUnit unit = time_unit(times_of(chart).high);
  frame.x = in_unit(times_of(chart), unit);
  const Range values = common_values({chart});
  const Axis y{chart.y_title, round_step(values, (top - bottom) / (2.8 * em))};
  frame.y = widened(values, 0.5 * y.step);
  frame.box = {room_on_the_left(canvas, frame.y, y), bottom, right, top};
  draw_axes(canvas, frame, axis_for(time_title(unit), frame.x, frame.box.width(), 5.0 * em), y, true);

  const Styles styles = line_styles(names, em);
  draw_curves(canvas, frame, chart, unit, styles);
  draw_legend(canvas, {right, top}, names, styles);
  if (chart.onset) {
    draw_onset(canvas, frame, *chart.onset, unit, frame.box.left);
  }
  if (chart.other_onset) {
    draw_other_onset(canvas, frame, *chart.other_onset, unit);
  }
  canvas.fitted_text({frame.box.left, canvas.height() - 1.05 * em}, chart.title, width - frame.box.left - em);
  canvas.write_png(file);
}

void write_stacked_histories(const std::filesystem::path& file, int width, const std::vector<HistoryChart>& charts) {
  const double em = font_share * width;
  const double panel_height = std::round(stacked_aspect * width);
  const double bottom = room_below(Canvas(width, 1, em)) + 0.4 * em;
  const double between = 3.4 * em;  // numbers of the upper chart's time axis, caption of the lower chart
  const double above = 1.9 * em;
  const auto count = static_cast<double>(charts.size());
  Canvas canvas(width, static_cast<int>(bottom + count * panel_height + (count - 1.0) * between + above), em);

  const auto names = curve_names(charts);
  const Styles styles = line_styles(names, em);
  const Range values = common_values(charts);
  Axis y{charts.front().y_title, round_step(values, panel_height / (2.2 * em))};
  PlotFrame frame;
  frame.y = widened(values, 0.5 * y.step);
  const auto times = time_ranges(charts);
  const TimeUnit unit = time_unit(std::ranges::max_element(times, {}, &Range::high)->high);
  double top = canvas.height() - above;
  const double right = width - legend_room(canvas, names);
  draw_legend(canvas, {right, top}, names, styles);
  for (std::size_t i = 0; i < charts.size(); ++i) {
    frame.x = in_unit(times[i], unit);
    frame.box = {room_on_the_left(canvas, frame.y, y), top - panel_height, right, top};
    const bool lowest = i + 1 == charts.size();
    draw_axes(canvas, frame, axis_for(lowest ? time_title(unit) : "", frame.x, frame.box.width(), 5.0 * em), y, true);
    draw_curves(canvas, frame, charts[i], unit, styles);
    const std::string caption = lettered(i, charts[i].title);
    canvas.text({frame.box.left, top + 0.85 * em}, caption);
    if (charts[i].onset) {
      draw_onset(canvas, frame, *charts[i].onset, unit, frame.box.left + canvas.text_width(caption) + 1.2 * em);
    }
    top -= panel_height + between;
  }
  canvas.write_png(file);
}

}  // namespace slope::tools
