#include "hyetograph_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>

#include "slope/couple/csv_rows.hpp"
#include "slope/couple/text_file.hpp"
#include "units.hpp"

namespace slope::couple {

namespace {

constexpr double millimetre_per_hour = 1.0e-3 / 3600.0, millimetre_per_day = 1.0e-3 / 86400.0;
constexpr double heaviest_rain = 500.0 * millimetre_per_hour;  // no hour ever had 350 mm
constexpr double driest_air = -20.0 * millimetre_per_day;      // no day ever took that from open water
constexpr double gap = 1.5;                                    // usual steps
constexpr double even_share = 0.75;                            // of the steps of a table whose gaps are odd

constexpr std::size_t most_bytes = 100'000'000;
constexpr std::string_view expected_header =
    "expected a header such as \"time_h,intensity_mm_per_h\" (time in s, min, h or d; intensity in mm or m per s, h or "
    "d)";

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

/// Whether a cell stands for a value that is not there.
bool is_missing(std::string_view cell) {
  std::string word(cell);
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::array words{"", "-", "--", "na", "n/a", "nan", "null", "none", "m", "missing", "nodata"};
  if (std::ranges::find(words, word) != words.end()) return true;
  // -99, -999.9, 9999 and their like
  const bool negative = word.starts_with('-');
  const std::string_view number = std::string_view(word).substr(negative ? 1 : 0);
  const auto point = number.find('.');
  const std::string_view whole = number.substr(0, point);
  const std::string_view rest = point == std::string_view::npos ? "" : number.substr(point + 1);
  const auto all = [](std::string_view text, char digit) {
    return std::ranges::all_of(text, [digit](char c) { return c == digit; });
  };
  return whole.size() >= (negative ? 2u : 3u) && all(whole, '9') && (all(rest, '9') || all(rest, '0'));
}

void find_gaps(RainTable& table, const std::vector<int>& lines) {
  const std::vector<RainStep>& steps = table.steps;
  const double usual = usual_step(steps);
  const auto step = [&](std::size_t i) { return steps[i + 1].time - steps[i].time; };
  std::size_t even = 0;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) even += std::abs(step(i) - usual) < 0.01 * usual ? 1 : 0;
  if (steps.size() < 5 || static_cast<double>(even) < even_share * static_cast<double>(steps.size() - 1)) return;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    if (step(i) <= gap * usual || steps[i].intensity == 0.0) continue;
    table.warnings.push_back(
        {lines[i + 1],
         fmt::format("comes {:g} h after the row before, where {:g} h are usual, and what fell then, {:.3g} "
                     "mm/h, is held all the time; fill the gap with rows",
                     step(i) / 3600.0, usual / 3600.0, steps[i].intensity / millimetre_per_hour)});
  }
}

}  // namespace

double usual_step(const std::vector<RainStep>& steps) {
  if (steps.size() < 2) return never;
  std::vector<double> lengths;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) lengths.push_back(steps[i + 1].time - steps[i].time);
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::ranges::nth_element(lengths, middle);
  return *middle;
}

std::optional<std::string> doubt_about(double intensity) {
  if (intensity > heaviest_rain) {
    return fmt::format("{:.4g} mm/h is more than any rain; is the unit right?", intensity / millimetre_per_hour);
  }
  if (intensity < driest_air) {
    return fmt::format(
        "evaporates {:.4g} mm/d, more than any air does; is it a code for a missing value, or the unit "
        "wrong?",
        -intensity / millimetre_per_day);
  }
  return std::nullopt;
}

std::variant<RainTable, std::string> read_hyetograph(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    return fmt::format("the file {} cannot be read; the path counts from the case's folder", file.string());
  RainTable table;
  std::vector<int> lines;  // of the steps
  std::optional<std::string> time_unit, intensity_unit;
  for (CsvRows rows(read_text_file(file, most_bytes)); rows.next();) {
    if (rows.is_comment()) continue;
    const auto wrong = [&](std::string_view what) {
      return fmt::format("{}:{}: {}", file.string(), rows.line(), what);
    };
    const std::vector<std::string>& cells = rows.cells();
    const bool is_pair = cells.size() == 2;
    const auto unlike = [&](std::string_view expected) {
      return wrong(fmt::format("{}, columns parted by a comma, decimals by a point; got \"{}\"", expected,
                               shortened(rows.text())));
    };
    if (!time_unit) {
      if (!is_pair) return unlike(expected_header);
      time_unit = unit_of(cells[0], "time_", Dimension::time);
      intensity_unit = unit_of(cells[1], "intensity_", Dimension::velocity);
      if (!time_unit || !intensity_unit) return unlike(expected_header);
      continue;
    }
    if (is_pair && is_missing(cells[1])) {
      return wrong(fmt::format("\"{}\" stands for a missing value; write what fell then, 0 if nothing did", cells[1]));
    }
    const auto time = is_pair ? value_of(cells[0], *time_unit, Dimension::time) : std::nullopt;
    const auto intensity = is_pair ? value_of(cells[1], *intensity_unit, Dimension::velocity) : std::nullopt;
    if (!time || !intensity) return unlike("expected two numbers, a time and the intensity from then on");
    table.steps.push_back({*time, *intensity});
    lines.push_back(rows.line());
    if (lines.size() > 1 && table.steps.back().time <= table.steps[lines.size() - 2].time) {
      return wrong("times must grow from row to row");
    }
    if (const auto doubt = doubt_about(*intensity)) table.warnings.push_back({rows.line(), *doubt});
  }
  if (table.steps.empty()) return fmt::format("{}: holds no row; {}", file.string(), expected_header);
  find_gaps(table, lines);
  return table;
}

}  // namespace slope::couple
