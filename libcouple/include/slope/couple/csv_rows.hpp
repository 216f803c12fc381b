#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slope::couple {

/// The rows of a table of comma-separated values, one by one, as the tables of rain, of surfaces and of histories are
/// read. Cells lose the blanks around them, and quotes with what these protect: a comma, or a quote that stands twice.
/// A cell ends with its line. Lines and comments that are empty are passed over.
class CsvRows {
 public:
  /// @param text  of the table, lines ended by line feeds: see read_text_file()
  explicit CsvRows(std::string text) : text_(std::move(text)) {}
  CsvRows(const CsvRows&) = delete;  // the row is a view into the text
  CsvRows& operator=(const CsvRows&) = delete;

  /// Goes on to the next row. @return whether there was one
  bool next();
  /// Whether no line follows the present one.
  [[nodiscard]] bool is_last() const { return next_ >= text_.size(); }
  [[nodiscard]] int line() const { return line_; }  ///< of the row, from 1
  /// Whether the line begins with '#', which is not in its cells.
  [[nodiscard]] bool is_comment() const { return is_comment_; }
  [[nodiscard]] std::string_view text() const { return row_; }  ///< of the row, without the blanks around it
  [[nodiscard]] const std::vector<std::string>& cells() const { return cells_; }  ///< at least one

 private:
  void split(std::string_view row);

  std::string text_;
  std::size_t next_ = 0;  // where the next line begins
  int line_ = 0;
  bool is_comment_ = false;
  std::string_view row_;
  std::vector<std::string> cells_;
};

}  // namespace slope::couple
