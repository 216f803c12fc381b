#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "read_study.hpp"
#include "scratch_folder.hpp"
#include "slope/testing/corpus.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;
using slope::testing::parted;
using slope::testing::with_line_feeds;

/// A line of wrong_studies.txt.
struct WrongStudy {
  std::string name, text, replacement;
  int lines_below = 0;  ///< between the replaced text and the line that is blamed
  std::string message;  ///< with its key
};

std::ostream& operator<<(std::ostream& out, const WrongStudy& wrong) {
  return out << wrong.text << " => " << wrong.replacement;
}

std::vector<WrongStudy> wrong_studies() {
  std::ifstream stream(std::string(SLOPE_STUDY_TESTS) + "/wrong_studies.txt");
  std::vector<WrongStudy> studies;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    const auto cells = parted(line, " :: ");
    const auto texts = cells.size() == 4 ? parted(cells[1], " => ") : std::vector<std::string>{};
    if (texts.size() != 2) throw std::runtime_error("no wrong study: " + line);
    studies.push_back({cells[0], with_line_feeds(texts[0]), with_line_feeds(texts[1]), std::stoi(cells[2]), cells[3]});
  }
  return studies;
}

std::string content_of(const fs::path& file) {
  std::ostringstream content;
  content << std::ifstream(file).rdbuf();
  return content.str();
}

class WrongStudies : public ::testing::TestWithParam<WrongStudy> {};

TEST_P(WrongStudies, GetOneMessageWithPlaceKeyAndRemedy) {
  const WrongStudy& wrong = GetParam();
  const ScratchFolder folder;
  fs::copy(fs::path(SLOPE_CASES) / "quick.yaml", folder.path() / "quick.yaml");
  std::string content = content_of(fs::path(SLOPE_STUDY_TESTS) / "study.yaml");
  const std::size_t at = content.find(wrong.text);
  ASSERT_NE(at, std::string::npos);
  const auto line = 1 + std::count(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  content.replace(at, wrong.text.size(), wrong.replacement);
  const fs::path file = folder.path() / "study.yaml";
  std::ofstream(file) << content;
  std::string told;
  try {
    static_cast<void>(read_study(file));
  } catch (const couple::InputError& error) {
    told = error.what();
  }
  const std::string here = folder.path().string() + "/";
  for (std::size_t found = told.find(here); found != std::string::npos; found = told.find(here)) {
    told.erase(found, here.size());
  }
  EXPECT_EQ(told, "study.yaml:" + std::to_string(line + wrong.lines_below) + ": " + wrong.message);
}

INSTANTIATE_TEST_SUITE_P(All, WrongStudies, ::testing::ValuesIn(wrong_studies()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace slope::tools::test
