#include "hyetograph_file.hpp"

#include <fmt/format.h>

#include <array>
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

std::optional<double> value_of(std::string_view number, const std::string& unit, Dimension dimension) {
  const auto value = parse_quantity(fmt::format("{} {}", number, unit), dimension);
  return std::holds_alternative<double>(value) ? std::optional(std::get<double>(value)) : std::nullopt;
}

/// The unit that a column's name ends with, "mm/h" of "intensity_mm_per_h"; none if it is not one of the dimension.
std::optional<std::string> unit_of(std::string_view name, std::string_view quantity, Dimension dimension) {
  if (!name.starts_with(quantity)) return std::nullopt;
  std::string unit(name.substr(quantity.size()));
  if (const auto per = unit.find("_per_"); per != std::string::npos) unit.replace(per, 5, "/");
  return value_of("1", unit, dimension) ? std::optional(unit) : std::nullopt;
}

}  // namespace

std::variant<std::vector<RainStep>, std::string> read_hyetograph(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) return fmt::format("the file {} cannot be read; the path counts from the case's folder", file.string());
  std::vector<RainStep> steps;
  std::optional<std::string> time_unit, intensity_unit;
  std::string line;
  for (int row = 1; std::getline(stream, line); ++row) {
    if (trimmed(line).empty() || line.front() == '#') continue;
    const auto wrong = [&](std::string_view what) { return fmt::format("{}:{}: {}", file.string(), row, what); };
    const auto cells = cells_of(line);
    if (!time_unit) {
      if (!cells) return wrong(expected_header);
      time_unit = unit_of((*cells)[0], "time_", Dimension::time);
      intensity_unit = unit_of((*cells)[1], "intensity_", Dimension::velocity);
      if (!time_unit || !intensity_unit) return wrong(expected_header);
      continue;
    }
    const auto time = cells ? value_of((*cells)[0], *time_unit, Dimension::time) : std::nullopt;
    const auto intensity = cells ? value_of((*cells)[1], *intensity_unit, Dimension::velocity) : std::nullopt;
    if (!time || !intensity) return wrong("expected two numbers, a time and the intensity from then on");
    steps.push_back({*time, *intensity});
    if (steps.size() > 1 && steps.back().time <= steps[steps.size() - 2].time) {
      return wrong("times must grow from row to row");
    }
  }
  if (steps.empty()) return fmt::format("{}: holds no row; {}", file.string(), expected_header);
  return steps;
}

}  // namespace slope::couple
