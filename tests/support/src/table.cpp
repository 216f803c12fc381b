#include "slope/testing/table.hpp"

#include <charconv>
#include <fstream>
#include <optional>
#include <stdexcept>

namespace slope::testing {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const auto end = std::min(line.find(',', begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

std::optional<std::vector<double>> numbers(const std::vector<std::string_view>& cells) {
  std::vector<double> row;
  for (const auto cell : cells) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    // A denormal is out of range of some parsers; it is zero for every purpose here.
    if (error == std::errc::result_out_of_range) value = 0.0;
    if (error == std::errc::invalid_argument || end != cell.data() + cell.size()) return std::nullopt;
    row.push_back(value);
  }
  return row;
}

}  // namespace

Table::Table(const std::filesystem::path& file) : file_(file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  std::string comment;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const auto text = trimmed(line);
    if (text.empty()) continue;
    if (text.front() == '#') {
      comment = text.substr(1);
      continue;
    }
    const auto cells = split(text);
    const auto row = numbers(cells);
    if (names_.empty()) {
      const auto header = row ? split(comment) : cells;
      names_.assign(header.begin(), header.end());
      columns_.resize(names_.size());
      if (!row) continue;
    }
    if (!row || row->size() != columns_.size()) {
      throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": expected " +
                               std::to_string(columns_.size()) + " numbers");
    }
    for (std::size_t c = 0; c < columns_.size(); ++c) columns_[c].push_back((*row)[c]);
  }
}

const std::vector<double>& Table::column(std::string_view name) const {
  std::string known;
  for (std::size_t c = 0; c < names_.size(); ++c) {
    if (names_[c] == name) return columns_[c];
    known += " " + names_[c];
  }
  throw std::out_of_range(file_.string() + ": no column " + std::string(name) + "; there are:" + known);
}

Table reference(const std::filesystem::path& file) {
  return Table(SLOPE_TEST_REFERENCE_DIR / file);
}

}  // namespace slope::testing
