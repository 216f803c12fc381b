#include <gtest/gtest.h>

#include <fstream>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "a_summary.hpp"
#include "slope/testing/corpus.hpp"

namespace slope::couple::test {
namespace {

using slope::testing::with_line_feeds;

/// A line of damaged_summaries.txt.
struct DamagedSummary {
  std::string name, change, message;
};

std::ostream& operator<<(std::ostream& out, const DamagedSummary& damaged) {
  return out << damaged.change;
}

std::vector<DamagedSummary> damaged_summaries() {
  std::ifstream stream(SLOPE_DAMAGED_SUMMARIES);
  std::vector<DamagedSummary> damaged;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::size_t change = line.find(" :: "), message = line.find(" ::", change + 4);
    if (message == std::string::npos) throw std::runtime_error("no damaged summary: " + line);
    damaged.push_back(
        {line.substr(0, change), line.substr(change + 4, message - change - 4), line.substr(message + 3)});
  }
  return damaged;
}

/// The summary that a line describes.
std::string content_of(const std::string& change) {
  std::string text = summary_json(a_summary());
  if (change.starts_with("cut ")) return text.substr(0, std::stoul(change.substr(4)));
  if (change.starts_with("[[ ")) return std::string(std::stoul(change.substr(5)), change[3]);
  const std::size_t arrow = change.find(" =>");
  if (arrow == std::string::npos) return with_line_feeds(change);
  const std::string from = change.substr(0, arrow);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("the summary has no " + from);
  return text.replace(at, from.size(), arrow + 4 < change.size() ? change.substr(arrow + 4) : "");
}

class DamagedSummaries : public ::testing::TestWithParam<DamagedSummary> {};

TEST_P(DamagedSummaries, AreRefusedWithPlaceKeyAndWhatIsExpected) {
  std::string told = "nothing";
  try {
    (void)summary_of(content_of(GetParam().change), "s.json");
  } catch (const FileError& error) {
    told = error.what();
  }
  const std::string& message = GetParam().message;
  EXPECT_EQ(told.substr(0, 6), "s.json");
  if (message.front() == ' ') {
    EXPECT_NE(told.find(": " + message.substr(1)), std::string::npos) << told.substr(0, 2000);
  } else {
    EXPECT_EQ(told.substr(0, 7 + message.size()), "s.json:" + message) << told.substr(0, 2000);
  }
  EXPECT_LT(told.size(), 10000u) << "nobody reads that";
}

INSTANTIATE_TEST_SUITE_P(With, DamagedSummaries, ::testing::ValuesIn(damaged_summaries()),
                         [](const auto& instance) { return instance.param.name; });

TEST(DamagedSummary, CutAnywhereIsRefused) {
  const std::string text = summary_json(a_summary());
  for (std::size_t length = 0; length + 2 < text.size(); length += 3) {
    EXPECT_THROW((void)summary_of(text.substr(0, length), "s.json"), FileError) << length;
  }
}

TEST(DamagedSummary, WithAByteChangedIsReadOrRefused) {
  std::string text = summary_json(a_summary());
  for (std::size_t at = 0; at < text.size(); at += 5) {
    char& byte = text[at];
    for (const char other : {'\0', '"', '{', ']', '7', '\xff'}) {
      const char kept = std::exchange(byte, other);
      try {
        (void)summary_of(text, "s.json");
      } catch (const FileError&) {
      }
      byte = kept;
    }
  }
}

}  // namespace
}  // namespace slope::couple::test
