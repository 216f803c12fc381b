#include "distribution_chart.hpp"

#include <algorithm>
#include <cmath>

#include "canvas.hpp"
#include "colour_maps.hpp"

namespace slope::tools {
namespace {

constexpr double aspect = 0.95;

void draw_bins(Canvas& canvas, const PlotFrame& frame, const Histogram& histogram) {
  const double seam = 0.05 * canvas.em();
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const double left = histogram.first + histogram.step * static_cast<double>(i);
    const Pixel lower = frame.at(left, 0.0), upper = frame.at(left + histogram.step, histogram.counts[i]);
    canvas.fill({lower.x + seam, lower.y, upper.x - seam, upper.y}, curve_colour(0));
  }
}

/// The share of values up to each, in steps.
void draw_steps(Canvas& canvas, const PlotFrame& frame, std::vector<double> values) {
  std::ranges::sort(values);
  const auto n = static_cast<double>(values.size());
  std::vector<Pixel> line{frame.at(frame.x.low, 0.0)};
  for (std::size_t i = 0; i < values.size(); ++i) {
    line.push_back(frame.at(values[i], static_cast<double>(i) / n));
    line.push_back(frame.at(values[i], static_cast<double>(i + 1) / n));
  }
  line.push_back(frame.at(frame.x.high, 1.0));
  canvas.stroke(line, {0.13 * canvas.em(), curve_colour(0), {}});
}

void draw_mark(Canvas& canvas, const PlotFrame& frame, const QuantileMark& mark) {
  const double em = canvas.em();
  const double y = frame.at(0.0, mark.probability).y;
  const auto place = [&](double value) {
    return frame.at(std::clamp(value, frame.x.low, frame.x.high), mark.probability).x;
  };
  const LineStyle line{0.1 * em, ink, {}};
  const bool has_lower = !std::isnan(mark.lower), has_upper = !std::isnan(mark.upper);
  const double left = has_lower ? place(mark.lower) : place(mark.value);
  const double right = has_upper ? place(mark.upper) : place(mark.value);
  canvas.stroke({{left, y}, {right, y}}, line);
  if (has_lower) canvas.stroke({{left, y - 0.25 * em}, {left, y + 0.25 * em}}, line);
  if (has_upper) canvas.stroke({{right, y - 0.25 * em}, {right, y + 0.25 * em}}, line);
  canvas.disc({place(mark.value), y}, 0.25 * em, ink);
}

/// A line through both frames, and what it is.
void draw_limit(Canvas& canvas, const PlotFrame& upper, const PlotFrame& lower, const DistributionChart& chart) {
  if (!chart.limit || *chart.limit < upper.x.low || *chart.limit > upper.x.high) return;
  const double em = canvas.em();
  const LineStyle line{0.1 * em, ink, {0.4 * em, 0.3 * em}};
  const double x = upper.at(*chart.limit, 0.0).x;
  for (const PlotFrame* frame : {&upper, &lower}) canvas.stroke({{x, frame->box.bottom}, {x, frame->box.top}}, line);
  const double half = 0.5 * canvas.text_width(chart.limit_name);
  const double centre = std::clamp(x, upper.box.left + half, std::max(upper.box.right - half, upper.box.left + half));
  canvas.text({centre, upper.box.top + 0.85 * em}, chart.limit_name, {.anchor = Anchor::centre});
}

}  // namespace

Histogram histogram_of(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax(values);
  const Range range{low, high > low ? high : low + std::max(std::abs(low), 1.0) * 0.1};
  Histogram histogram;
  histogram.step = round_step(range, std::sqrt(static_cast<double>(values.size())));
  histogram.first = std::floor(low / histogram.step) * histogram.step;
  const auto bin_of = [&](double value) {
    return static_cast<std::size_t>(std::max((value - histogram.first) / histogram.step, 0.0));
  };
  histogram.counts.assign(bin_of(high) + 1, 0);
  for (const double value : values) ++histogram.counts[bin_of(value)];
  return histogram;
}

void write_distribution_chart(const std::filesystem::path& file, int width, const DistributionChart& chart) {
  const double em = font_share * width;
  Canvas canvas(width, static_cast<int>(std::lround(aspect * width)), em);
  const Histogram histogram = histogram_of(chart.values);
  const double bottom = room_below(canvas) + 0.4 * em, top = canvas.height() - 3.6 * em;
  const double middle = 0.5 * (bottom + top);

  PlotFrame upper, lower;
  const double last = histogram.first + histogram.step * static_cast<double>(histogram.counts.size());
  upper.x = lower.x = {histogram.first - 0.5 * histogram.step, last + 0.5 * histogram.step};
  if (chart.limit && *chart.limit > upper.x.low - upper.x.length() && *chart.limit < upper.x.high + upper.x.length()) {
    upper.x.low = lower.x.low = std::min(upper.x.low, *chart.limit - 0.5 * histogram.step);
    upper.x.high = lower.x.high = std::max(upper.x.high, *chart.limit + 0.5 * histogram.step);
  }
  const Range counts{0.0, static_cast<double>(std::ranges::max(histogram.counts))};
  const double step = std::max(1.0, round_step(counts, (top - middle) / (2.8 * em)));
  const Axis runs{"Number of runs", step}, share{"Share of runs up to it", 0.25};
  upper.y = {0.0, widened({0.0, 1.02 * counts.high}, step).high};  // so that no bar lies on the frame
  lower.y = {0.0, 1.0};
  const double left = std::max(room_on_the_left(canvas, upper.y, runs), room_on_the_left(canvas, lower.y, share));
  upper.box = {left, middle + 1.0 * em, width - 1.5 * em, top};
  lower.box = {left, bottom, width - 1.5 * em, middle - 1.4 * em};
  const Axis x = axis_for("", upper.x, upper.box.width(), 4.5 * em);
  draw_axes(canvas, upper, x, runs, true);
  draw_axes(canvas, lower, {chart.x_title, x.step}, share, true);

  draw_bins(canvas, upper, histogram);
  draw_steps(canvas, lower, chart.values);
  for (const QuantileMark& mark : chart.marks) draw_mark(canvas, lower, mark);
  draw_limit(canvas, upper, lower, chart);
  canvas.fitted_text({left, canvas.height() - 1.05 * em}, chart.title, width - left - em);
  canvas.write_png(file);
}

}  // namespace slope::tools
