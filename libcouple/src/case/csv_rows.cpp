#include "slope/couple/csv_rows.hpp"

#include <algorithm>

namespace slope::couple {

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view without_hashes(std::string_view comment) {
  const auto first = comment.find_first_not_of("# \t");
  return first == std::string_view::npos ? std::string_view{} : comment.substr(first);
}

}  // namespace

bool CsvRows::next() {
  while (next_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', next_), text_.size());
    const std::string_view whole = std::string_view(text_).substr(next_, end - next_);
    next_ = end + 1;
    ++line_;
    is_comment_ = whole.starts_with('#');
    row_ = trimmed(whole);
    const std::string_view content = is_comment_ ? without_hashes(row_) : row_;
    if (content.empty()) continue;
    split(content);
    return true;
  }
  return false;
}

void CsvRows::split(std::string_view row) {
  std::size_t count = 0;
  for (std::size_t at = 0; at <= row.size(); ++at, ++count) {
    if (cells_.size() == count) cells_.emplace_back();
    std::string& cell = cells_[count];
    cell.clear();
    at = std::min(row.find_first_not_of(blanks, at), row.size());
    if (at < row.size() && row[at] == '"') {
      for (++at; at < row.size() && (row[at] != '"' || row.substr(at, 2) == "\"\""); ++at) {
        if (row[at] == '"') ++at;
        cell += row[at];
      }
      ++at;
    }
    const std::size_t comma = at < row.size() ? std::min(row.find(',', at), row.size()) : row.size();
    if (at < comma) cell += trimmed(row.substr(at, comma - at));
    at = comma;
  }
  cells_.resize(count);
}

}  // namespace slope::couple
