#include "hyetograph_file.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <string_view>

#include "units.hpp"

namespace slope::couple {

namespace {

constexpr std::string_view expected_header =
    "expected a header such as \"time_h,intensity_mm_per_h\" (time in s, min, h or d; intensity in mm or m per s, h or "
    "d)";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The two cells of a line; none if it has another number of them.
std::optional<std::array<std::string_view, 2>> cells_of(std::string_view line) {
  const auto comma = line.find(',');
  if (comma == std::string_view::npos || line.find(',', comma + 1) != std::string_view::npos) return std::nullopt;
  return std::array{trimmed(line.substr(0, comma)), trimmed(line.substr(comma + 1))};
}

/// What one of the unit is in SI units; "mm_per_h" is mm/h.
std::optional<double> unit_value(std::string_view cell, std::string_view prefix, Dimension dimension) {
  if (!cell.starts_with(prefix)) return std::nullopt;
  std::string unit(cell.substr(prefix.size()));
  if (const auto per = unit.find("_per_"); per != std::string::npos) unit.replace(per, 5, "/");
  const auto value = parse_quantity("1 " + unit, dimension);
  return std::holds_alternative<double>(value) ? std::optional(std::get<double>(value)) : std::nullopt;
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace

std::variant<std::vector<RainStep>, std::string> read_hyetograph(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) return fmt::format("the file {} cannot be read; the path counts from the case's folder", file.string());
  std::vector<RainStep> steps;
  std::optional<double> time_unit, intensity_unit;
  std::string line;
  for (int row = 1; std::getline(stream, line); ++row) {
    if (trimmed(line).empty() || line.front() == '#') continue;
    const auto wrong = [&](std::string_view what) { return fmt::format("{}:{}: {}", file.string(), row, what); };
    const auto cells = cells_of(line);
    if (!time_unit) {
      if (!cells) return wrong(expected_header);
      time_unit = unit_value((*cells)[0], "time_", Dimension::time);
      intensity_unit = unit_value((*cells)[1], "intensity_", Dimension::velocity);
      if (!time_unit || !intensity_unit) return wrong(expected_header);
      continue;
    }
    const auto time = cells ? number((*cells)[0]) : std::nullopt;
    const auto intensity = cells ? number((*cells)[1]) : std::nullopt;
    if (!time || !intensity) return wrong("expected two numbers, a time and the intensity from then on");
    steps.push_back({*time * *time_unit, *intensity * *intensity_unit});
    if (steps.size() > 1 && steps.back().time <= steps[steps.size() - 2].time) {
      return wrong("times must grow from row to row");
    }
  }
  if (steps.empty()) return fmt::format("{}: holds no row; {}", file.string(), expected_header);
  return steps;
}

}  // namespace slope::couple
