#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slope::couple::test {

/// The folder of the cases that the project ships.
[[nodiscard]] std::filesystem::path shipped_cases();
/// The shipped case files, without the soil library and the studies.
[[nodiscard]] std::vector<std::filesystem::path> shipped_case_files();
[[nodiscard]] std::string content_of(const std::filesystem::path& file);

/// A folder of its own for case files that a test writes; removed at the end.
class CaseFolder {
 public:
  CaseFolder();
  ~CaseFolder();
  CaseFolder(const CaseFolder&) = delete;
  CaseFolder& operator=(const CaseFolder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& content) const;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The shipped case slope-w2.yaml with one text replaced by another, and the line where that is.
struct ChangedCase {
  std::string content;
  int line = 0;
};
[[nodiscard]] ChangedCase slope_with(const std::string& text, const std::string& replacement);

}  // namespace slope::couple::test
