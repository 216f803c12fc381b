#include "retention_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "canvas.hpp"
#include "colour_maps.hpp"

namespace slope::tools {
namespace {

constexpr double aspect = 0.68;
constexpr double shown_beyond = 4.0;  ///< the suction axis' length over the largest suction that occurs
constexpr int points_per_curve = 400;

std::vector<Pixel> curve_pixels(const PlotFrame& frame, const RetentionCurve& curve, const Range& suction,
                                double unit_weight) {
  std::vector<Pixel> points;
  for (int i = 0; i <= points_per_curve; ++i) {
    const double s = suction.low + suction.length() * i / points_per_curve;
    points.push_back(frame.at(1.0e-3 * s, saturation_at(curve.law, s, unit_weight)));
  }
  return points;
}

/// A short bar across the end of what occurs.
void draw_end(Canvas& canvas, Pixel where, Colour colour) {
  const double half = 0.35 * canvas.em();
  canvas.stroke({{where.x, where.y - half}, {where.x, where.y + half}}, {0.16 * canvas.em(), colour, {}});
}

std::string percent(double saturation) {
  return fmt::format("{:.1f}", 100.0 * saturation);
}

}  // namespace

double saturation_at(const seepage::Retention& law, double suction, double unit_weight) {
  return std::visit([&](const auto& curve) { return curve.evaluate(suction / unit_weight).saturation; }, law);
}

void write_retention_chart(const std::filesystem::path& file, int width, const std::vector<RetentionCurve>& curves,
                           double unit_weight) {
  const double em = font_share * width;
  Canvas canvas(width, static_cast<int>(std::lround(aspect * width)), em);
  const double bottom = room_below(canvas) + 0.4 * em;
  const double key_height = (1.6 * static_cast<double>(curves.size() + 1) + 0.8) * em;
  double largest = 1.0;
  for (const auto& curve : curves) {
    largest = std::max(largest, 1.0e-3 * curve.suction.high);
  }

  PlotFrame frame;
  frame.box = {0.0, bottom, width - 2.0 * em, canvas.height() - key_height};
  frame.y = {0.0, 1.05};  // so that a saturated soil does not lie on the frame
  const Axis y{"Degree of saturation S_{r} (-)", 0.2};
  frame.box.left = room_on_the_left(canvas, frame.y, y);
  const Range suctions{0.0, shown_beyond * largest};
  const Axis x = axis_for("Suction s (kPa)", suctions, frame.box.width(), 4.5 * em);
  frame.x = widened(suctions, x.step);
  draw_axes(canvas, frame, x, y, true);

  const double sample = 2.4 * em;
  double row = canvas.height() - 1.05 * em;
  const auto legend_row = [&](const std::string& text, const LineStyle& style) {
    canvas.stroke({{frame.box.left, row}, {frame.box.left + sample, row}}, style);
    canvas.text({frame.box.left + sample + 0.6 * em, row}, text);
    row -= 1.6 * em;
  };
  const std::vector<double> dashes{0.45 * em, 0.35 * em};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const RetentionCurve& curve = curves[i];
    const Colour colour = curve_colour(i);
    const double beyond = 1.0e3 * frame.x.high;
    canvas.stroke(curve_pixels(frame, curve, {curve.suction.high, beyond}, unit_weight), {0.1 * em, colour, dashes});
    canvas.stroke(curve_pixels(frame, curve, curve.suction, unit_weight), {0.26 * em, colour, {}});
    const double lowest = saturation_at(curve.law, curve.suction.high, unit_weight);
    draw_end(canvas, frame.at(1.0e-3 * curve.suction.high, lowest), colour);
    legend_row(fmt::format("{}: s = {:.0f} to {:.0f} kPa, S_{{r}} = {} to {} % in the slope", curve.name,
                           1.0e-3 * curve.suction.low, 1.0e-3 * curve.suction.high, percent(lowest),
                           percent(saturation_at(curve.law, curve.suction.low, unit_weight))),
               {0.26 * em, colour, {}});
  }
  legend_row("beyond the suction at the start", {0.1 * em, ink, dashes});
  canvas.write_png(file);
}

}  // namespace slope::tools
