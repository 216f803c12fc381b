#include "case_folder.hpp"

#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace slope::couple::test {

std::filesystem::path shipped_cases() {
  return SLOPE_CASES;
}

std::vector<std::filesystem::path> shipped_case_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shipped_cases())) {
    if (entry.path().extension() != ".yaml" || entry.path().filename() == "soils.yaml") continue;
    if (entry.path().parent_path().filename() != "studies") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return content.str();
}

CaseFolder::CaseFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "slope-case-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder can be made at " + name);
  path_ = name;
}

CaseFolder::~CaseFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path CaseFolder::write(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
  return path_ / name;
}

ChangedCase slope_with(const std::string& text, const std::string& replacement) {
  std::string content = content_of(shipped_cases() / "paper" / "slope-w2.yaml");
  const std::size_t at = content.find(text);
  if (at == std::string::npos) throw std::runtime_error("slope-w2.yaml no longer has: " + text);
  const auto line = 1 + std::count(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  content.replace(at, text.size(), replacement);
  return {content, static_cast<int>(line)};
}

}  // namespace slope::couple::test
