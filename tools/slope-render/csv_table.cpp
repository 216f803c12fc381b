#include "csv_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string_view>

#include "slope/couple/read_case.hpp"
#include "slope/couple/text_file.hpp"

namespace slope::tools {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30U;  // a run writes a million rows at most

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r#\"");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  std::size_t begin = 0;
  for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',', begin)) {
    cells.push_back(trimmed(line.substr(begin, comma - begin)));
    begin = comma + 1;
  }
  cells.push_back(trimmed(line.substr(begin)));
  return cells;
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) {
    return std::nullopt;
  }
  // Out of range for from_chars are denormals and what is too large, which strtod takes for infinite.
  return error == std::errc{} ? value : std::strtod(std::string(text).c_str(), nullptr);
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& file) {
  std::istringstream in(couple::read_text_file(file, most_bytes));
  CsvTable table;
  bool header_read = false;
  std::string line;
  for (int line_number = 1; std::getline(in, line); ++line_number) {
    if (trimmed(line).empty()) {
      continue;
    }
    const auto cells = split(line);
    if (line.front() == '#' && header_read) {
      continue;
    }
    if (!header_read && !number(cells.front())) {
      table.names.assign(cells.begin(), cells.end());
      header_read = line.front() != '#';
      continue;
    }
    header_read = true;
    table.columns.resize(table.names.size());
    if (cells.size() != table.names.size()) {
      if (in.peek() == std::istringstream::traits_type::eof()) {
        break;
      }
      throw couple::FileError(fmt::format("{}:{}: has {} columns where the header has {}", file.string(), line_number,
                                          cells.size(), table.names.size()));
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto value = number(cells[c]);
      if (!value) {
        throw couple::FileError(
            fmt::format("{}:{}: \"{}\" is not a number", file.string(), line_number, couple::shortened(cells[c])));
      }
      table.columns[c].push_back(*value);
    }
  }
  table.columns.resize(table.names.size());
  return table;
}

}  // namespace slope::tools
