#include "units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "slope/couple/text_file.hpp"
#include "suggestion.hpp"

namespace slope::couple {

namespace {

/// One unit: a value in SI units is the number times `numerator` over `denominator`; both are exact, so that "36 mm/h"
/// is rounded once.
struct Unit {
  std::string_view name;
  Dimension dimension;
  double numerator = 1.0;
  double denominator = 1.0;
};

constexpr std::array units{
    Unit{"%", Dimension::number, 1.0, 100.0},
    Unit{"m", Dimension::length},
    Unit{"cm", Dimension::length, 1.0, 100.0},
    Unit{"mm", Dimension::length, 1.0, 1000.0},
    Unit{"km", Dimension::length, 1000.0},
    Unit{"m2", Dimension::area},
    Unit{"s", Dimension::time},
    Unit{"min", Dimension::time, 60.0},
    Unit{"h", Dimension::time, 3600.0},
    Unit{"d", Dimension::time, 86400.0},
    Unit{"m/s", Dimension::velocity},
    Unit{"cm/s", Dimension::velocity, 1.0, 100.0},
    Unit{"mm/s", Dimension::velocity, 1.0, 1000.0},
    Unit{"m/h", Dimension::velocity, 1.0, 3600.0},
    Unit{"cm/h", Dimension::velocity, 1.0, 360000.0},
    Unit{"mm/h", Dimension::velocity, 1.0, 3600000.0},
    Unit{"m/d", Dimension::velocity, 1.0, 86400.0},
    Unit{"cm/d", Dimension::velocity, 1.0, 8640000.0},
    Unit{"mm/d", Dimension::velocity, 1.0, 86400000.0},
    Unit{"m/s2", Dimension::acceleration},
    Unit{"1/m", Dimension::inverse_length},
    Unit{"1/cm", Dimension::inverse_length, 100.0},
    Unit{"rad", Dimension::angle},
    Unit{"deg", Dimension::angle, std::numbers::pi, 180.0},
    Unit{"kg", Dimension::mass},
    Unit{"t", Dimension::mass, 1000.0},
    Unit{"N", Dimension::force},
    Unit{"kN", Dimension::force, 1000.0},
    Unit{"kg/m3", Dimension::density},
    Unit{"g/cm3", Dimension::density, 1000.0},
    Unit{"t/m3", Dimension::density, 1000.0},
    Unit{"N/m3", Dimension::unit_weight},
    Unit{"kN/m3", Dimension::unit_weight, 1000.0},
    Unit{"Pa", Dimension::pressure},
    Unit{"kPa", Dimension::pressure, 1.0e3},
    Unit{"MPa", Dimension::pressure, 1.0e6},
    Unit{"GPa", Dimension::pressure, 1.0e9},
    Unit{"N/m2", Dimension::pressure},
    Unit{"kN/m2", Dimension::pressure, 1.0e3},
    Unit{"MN/m2", Dimension::pressure, 1.0e6},
};

std::string_view example_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::number:
      return "0.35";
    case Dimension::length:
      return "0.5 m";
    case Dimension::area:
      return "2 m2";
    case Dimension::time:
      return "20 min";
    case Dimension::velocity:
      return "1e-5 m/s";
    case Dimension::acceleration:
      return "9.81 m/s2";
    case Dimension::inverse_length:
      return "0.05 1/m";
    case Dimension::angle:
      return "25 deg";
    case Dimension::mass:
      return "3 kg";
    case Dimension::force:
      return "2 kN";
    case Dimension::density:
      return "2700 kg/m3";
    case Dimension::unit_weight:
      return "19 kN/m3";
    case Dimension::pressure:
      return "10 kPa";
  }
  return "";
}

const Unit* find_unit(std::string_view name) {
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& unit) { return unit.name == name; });
  return found == units.end() ? nullptr : &*found;
}

std::string with_article(std::string_view noun) {
  return fmt::format("{} {}", std::string_view("aeio").find(noun.front()) == std::string_view::npos ? "a" : "an", noun);
}

/// 'a pressure with its unit, such as "10 kPa" (Pa, kPa, …)'
std::string wanted(Dimension dimension) {
  if (dimension == Dimension::number) return R"(a number without a unit, such as 0.35 (or in percent, "35 %"))";
  return fmt::format("{} with its unit, such as \"{}\" (units: {})", with_article(name_of(dimension)),
                     example_of(dimension), fmt::join(units_of(dimension), ", "));
}

/// Degrees, and the multiples of the pascal, are easier to read than SI units.
bool written_in_texts(const Unit& unit) {
  return unit.name == "deg" || unit.name == "kPa" || unit.name == "MPa" || unit.name == "GPa";
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string unknown_unit(std::string_view unit, Dimension dimension) {
  std::vector<std::string> names;
  for (const Unit& known : units) names.emplace_back(known.name);
  std::string without_caret(unit);
  std::erase(without_caret, '^');
  const auto closest = find_unit(without_caret) ? without_caret : closest_word(unit, names);
  return fmt::format("unknown unit \"{}\"{}; expected {}", shortened(unit),
                     closest ? fmt::format(", did you mean \"{}\"?", *closest) : "", wanted(dimension));
}

}  // namespace

std::string_view name_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::number:
      return "number";
    case Dimension::length:
      return "length";
    case Dimension::area:
      return "area";
    case Dimension::time:
      return "time";
    case Dimension::velocity:
      return "velocity";
    case Dimension::acceleration:
      return "acceleration";
    case Dimension::inverse_length:
      return "inverse length";
    case Dimension::angle:
      return "angle";
    case Dimension::mass:
      return "mass";
    case Dimension::force:
      return "force";
    case Dimension::density:
      return "density";
    case Dimension::unit_weight:
      return "unit weight";
    case Dimension::pressure:
      return "pressure";
  }
  return "";
}

std::vector<std::string_view> units_of(Dimension dimension) {
  std::vector<std::string_view> names;
  for (const Unit& unit : units) {
    if (unit.dimension == dimension) names.push_back(unit.name);
  }
  return names;
}

std::variant<double, std::string> parse_quantity(std::string_view text, Dimension dimension) {
  text = trimmed(text);
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  const std::string_view magnitude = digits.starts_with('-') ? digits.substr(1) : digits;
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool numeric =
      !magnitude.empty() && (magnitude.front() == '.' || std::isdigit(static_cast<unsigned char>(magnitude.front())));
  if (!numeric || error == std::errc::invalid_argument)
    return fmt::format("expected {}, got \"{}\"", wanted(dimension), shortened(text));
  const auto beyond = [text] { return fmt::format("\"{}\" is beyond the range of numbers", shortened(text)); };
  if (error == std::errc::result_out_of_range) return beyond();

  const std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (rest.empty()) {
    if (dimension == Dimension::number) return number;
    return fmt::format("expected {}, got {} without a unit", wanted(dimension), shortened(text));
  }
  const std::string_view name = trimmed(rest);
  const Unit* unit = find_unit(name);
  if (rest.front() == ',')
    return fmt::format("expected {}, got \"{}\": write a decimal point", wanted(dimension), shortened(text));
  if (unit == nullptr) return unknown_unit(name, dimension);
  if (unit->dimension != dimension) {
    return fmt::format("expected {}, got \"{}\", which is {}", wanted(dimension), shortened(text),
                       with_article(name_of(unit->dimension)));
  }
  if (rest.front() != ' ' && rest.front() != '\t') {
    return fmt::format("write a space between number and unit: \"{} {}\"",
                       shortened(text.substr(0, text.size() - rest.size())), name);
  }
  const double value = number * unit->numerator / unit->denominator;
  if (!std::isfinite(value)) return beyond();
  return value;
}

std::string quantity_text(double value, Dimension dimension) {
  if (dimension == Dimension::number) return fmt::format("{}", value);
  std::string shortest = fmt::format("{} {}", value, units_of(dimension).front());
  for (const Unit& unit : units) {
    if (unit.dimension != dimension || !written_in_texts(unit)) continue;
    const std::string text = fmt::format("{:.15g} {}", value / unit.numerator * unit.denominator, unit.name);
    const bool exact = parse_quantity(text, dimension) == std::variant<double, std::string>(value);
    const bool shorter = text.size() < shortest.size() || (unit.name == "deg" && text.size() == shortest.size());
    if (exact && shorter) shortest = text;
  }
  return shortest;
}

std::string length_text(double metres) {
  return fmt::format("{} m", std::round(metres * 1.0e6) / 1.0e6);
}

std::string quantity_pattern(Dimension dimension) {
  return fmt::format(R"(^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\s+({})$)",
                     fmt::join(units_of(dimension), "|"));
}

}  // namespace slope::couple
