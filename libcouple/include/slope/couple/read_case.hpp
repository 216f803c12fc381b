#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::couple {

/// One thing wrong with the input: where, what, and what would be right.
struct Problem {
  std::string file;
  int line = 0;     ///< 1-based; 0: not tied to a line
  std::string key;  ///< dotted path, e.g. "soils.sandy_clay.porosity"; may be empty
  std::string message;

  [[nodiscard]] std::string text() const;  ///< "file:line: key: message"
};

/// Everything that is wrong with the input, all at once.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems);
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// A file that cannot be read or written.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads and checks a YAML case file.
/// @param overrides  "dotted.key=value" texts that replace or add values before the check.
/// @param warnings  if given, takes what may be meant but is seldom right, such as rain that a gap in a table holds.
/// @throws InputError naming every problem; FileError if the file cannot be read.
[[nodiscard]] Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {},
                             std::vector<Problem>* warnings = nullptr);

/// The case as complete YAML with every default written out, in case-file units; read_case() gives the same case back.
[[nodiscard]] std::string resolved_yaml(const Case& input);

/// JSON Schema (draft 2020-12) of the case format.
[[nodiscard]] std::string case_schema();

}  // namespace slope::couple
