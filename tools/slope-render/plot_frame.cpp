#include "plot_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slope::tools {
namespace {

constexpr Colour grid_colour{225, 225, 225};
constexpr double tick_length = 0.25;  // em
constexpr double number_gap = 0.5;    // em, from the frame to the numbers

double line_width(const Canvas& canvas) {
  return std::max(1.0, 0.06 * canvas.em());
}

}  // namespace

double widest_number(const Canvas& canvas, const Range& range, double step) {
  double width = 0.0;
  for (const double value : multiples(range, step)) {
    width = std::max(width, canvas.text_width(number_text(value, step)));
  }
  return width;
}

double round_step(const Range& range, double count) {
  const double wanted = range.length() / std::max(count, 1.0);
  if (!(wanted > 0.0)) {
    return 1.0;
  }
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= wanted * (1.0 - 1.0e-9)) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

std::vector<double> multiples(const Range& range, double step) {
  const double slack = 1.0e-6;
  constexpr double most = 1000.0;
  const double first = std::ceil(range.low / step - slack);
  const double count = std::min(std::floor(range.high / step + slack) - first, most);
  std::vector<double> values;
  for (double n = 0.0; n <= count; n += 1.0) {
    values.push_back((first + n) * step);
  }
  return values;
}

Range widened(const Range& range, double step) {
  const double slack = 1.0e-6;
  return {std::floor(range.low / step + slack) * step, std::ceil(range.high / step - slack) * step};
}

std::string number_text(double value, double step) {
  int decimals = 0;
  double scaled = step;
  while (decimals < 9 && std::abs(scaled - std::round(scaled)) > 1.0e-6 * std::abs(scaled)) {
    scaled *= 10.0;
    ++decimals;
  }
  const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return value < 0.0 && !zero ? "\u2212" + digits : digits;
}

std::string lettered(std::size_t index, const std::string& caption) {
  return fmt::format("({}) {}", static_cast<char>('a' + index), caption);
}

Axis axis_for(const std::string& title, const Range& range, double length, double room_per_tick) {
  const double step = round_step(range, length / room_per_tick);
  return {title, multiples(range, step).size() < 2 ? range.length() : step};
}

double room_on_the_left(const Canvas& canvas, const Range& y, const Axis& axis) {
  return widest_number(canvas, y, axis.step) + (number_gap + 1.9) * canvas.em();
}

double room_below(const Canvas& canvas) {
  return 3.1 * canvas.em();
}

void draw_axes(Canvas& canvas, const PlotFrame& frame, const Axis& x, const Axis& y, bool grid) {
  const double em = canvas.em();
  const LineStyle line{line_width(canvas), ink, {}};
  const LineStyle faint{line_width(canvas), grid_colour, {}};
  const Box& box = frame.box;
  const auto x_ticks = multiples(frame.x, x.step);
  // Two numbers below a narrow frame stand outside of it.
  const bool crowded = x_ticks.size() == 2 && box.width() < widest_number(canvas, frame.x, x.step) + 0.4 * em;
  for (const double value : x_ticks) {
    const double place = frame.at(value, frame.y.low).x;
    if (grid) {
      canvas.stroke({{place, box.bottom}, {place, box.top}}, faint);
    }
    canvas.stroke({{place, box.bottom}, {place, box.bottom - tick_length * em}}, line);
    const Anchor anchor = !crowded ? Anchor::centre : value == x_ticks.front() ? Anchor::right : Anchor::left;
    const double outwards = !crowded ? 0.0 : anchor == Anchor::right ? 0.3 * em : -0.3 * em;
    canvas.text({place + outwards, box.bottom - (number_gap + 0.45) * em}, number_text(value, x.step),
                {.anchor = anchor});
  }
  for (const double value : multiples(frame.y, y.step)) {
    const double place = frame.at(frame.x.low, value).y;
    if (grid) {
      canvas.stroke({{box.left, place}, {box.right, place}}, faint);
    }
    canvas.stroke({{box.left, place}, {box.left - tick_length * em, place}}, line);
    canvas.text({box.left - number_gap * em, place}, number_text(value, y.step), {.anchor = Anchor::right});
  }
  canvas.stroke(box, line);
  canvas.text({box.centre().x, box.bottom - 2.35 * em}, x.title, {.anchor = Anchor::centre});
  const double numbers = widest_number(canvas, frame.y, y.step);
  canvas.text({box.left - (number_gap + 0.9) * em - numbers, box.centre().y}, y.title,
              {.anchor = Anchor::centre, .upwards = true});
}

}  // namespace slope::tools
