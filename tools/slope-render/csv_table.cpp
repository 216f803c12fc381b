#include "csv_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "slope/couple/csv_rows.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/text_file.hpp"

namespace slope::tools {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30U;  // a run writes a million rows at most

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
  CsvTable table;
  bool header_read = false;
  for (couple::CsvRows rows(couple::read_text_file(file, most_bytes)); rows.next();) {
    const auto& cells = rows.cells();
    if (rows.is_comment() && header_read) {
      continue;
    }
    if (!header_read && !number(cells.front())) {
      table.names = cells;
      header_read = !rows.is_comment();
      continue;
    }
    header_read = true;
    table.columns.resize(table.names.size());
    if (cells.size() != table.names.size()) {
      if (rows.is_last()) {
        break;
      }
      throw couple::FileError(fmt::format("{}:{}: has {} columns where the header has {}", file.string(), rows.line(),
                                          cells.size(), table.names.size()));
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto value = number(cells[c]);
      if (!value) {
        throw couple::FileError(
            fmt::format("{}:{}: \"{}\" is not a number", file.string(), rows.line(), couple::shortened(cells[c])));
      }
      table.columns[c].push_back(*value);
    }
  }
  table.columns.resize(table.names.size());
  return table;
}

}  // namespace slope::tools
