#include <gtest/gtest.h>

#include <fstream>
#include <ostream>
#include <stdexcept>

#include "case_folder.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/testing/corpus.hpp"

namespace slope::couple::test {
namespace {

using slope::testing::parted;
using slope::testing::with_line_feeds;

/// A line of wrong_cases.txt.
struct WrongCase {
  std::string name, change;
  int lines_below = 0;  ///< between the replaced text and the line that is blamed
  std::string message;  ///< with its key
};

std::ostream& operator<<(std::ostream& out, const WrongCase& wrong) {
  return out << wrong.change;
}

std::vector<WrongCase> wrong_cases() {
  std::ifstream stream(SLOPE_WRONG_CASES);
  std::vector<WrongCase> cases;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    const auto cells = parted(line, " :: ");
    if (cells.size() != 3 && cells.size() != 4) throw std::runtime_error("no wrong case: " + line);
    cases.push_back({cells[0], cells[1], cells.size() == 4 ? std::stoi(cells[2]) : 0, cells.back()});
  }
  return cases;
}

std::vector<Problem> problems_of(const std::filesystem::path& file, const std::vector<std::string>& overrides = {}) {
  try {
    (void)read_case(file, overrides);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

class WrongCases : public ::testing::TestWithParam<WrongCase> {};

TEST_P(WrongCases, GetOneMessageWithPlaceKeyAndRemedy) {
  const WrongCase& wrong = GetParam();
  const std::string set = "--set ";
  const CaseFolder folder;
  std::vector<Problem> problems;
  std::string place;
  if (wrong.change.starts_with(set)) {
    const auto file = folder.write("slope.yaml", content_of(shipped_cases() / "paper" / "slope-w2.yaml"));
    problems = problems_of(file, {wrong.change.substr(set.size())});
    place = "--set: ";
  } else {
    const auto texts = parted(wrong.change, " => ");
    ASSERT_EQ(texts.size(), 2u);
    const ChangedCase changed = slope_with(with_line_feeds(texts[0]), with_line_feeds(texts[1]));
    const auto file = folder.write("slope.yaml", changed.content);
    problems = problems_of(file);
    place = file.string() + ":" + std::to_string(changed.line + wrong.lines_below) + ": ";
  }
  ASSERT_EQ(problems.size(), 1u) << (problems.empty() ? "" : InputError(problems).what());
  std::string told = problems[0].text();
  const std::string here = folder.path().string() + "/";
  if (const auto at = told.rfind(here); at != std::string::npos && at > 0) told.erase(at, here.size());
  EXPECT_EQ(told, place + wrong.message);
}

INSTANTIATE_TEST_SUITE_P(All, WrongCases, ::testing::ValuesIn(wrong_cases()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace slope::couple::test
