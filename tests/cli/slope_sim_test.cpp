#include "slope_sim_test.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

namespace slope::tools::test {

Outcome SlopeSim::run_box(const fs::path& out, std::vector<std::string> more) const {
  more.insert(more.begin(), {"run", box, "-o", out.string()});
  return call(more);
}

fs::path SlopeSim::write(const std::string& name, const std::string& content) const {
  std::ofstream(scratch_ / name) << content;
  return scratch_ / name;
}

couple::RunSummary SlopeSim::summary_of(const fs::path& out) {
  return couple::read_summary(out / "summary.json");
}

std::vector<std::string> SlopeSim::lines_of(const fs::path& file) {
  std::istringstream stream(content_of(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void SlopeSim::expect_whole_history(const fs::path& out, std::size_t least_rows) {
  EXPECT_TRUE(content_of(out / "history.csv").ends_with('\n'));
  const auto lines = lines_of(out / "history.csv");
  ASSERT_GE(lines.size(), least_rows + 1);
  for (const std::string& line : lines) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(lines[0].begin(), lines[0].end(), ',')) << line;
  }
}

bool SlopeSim::has_text(Program& program, const fs::path& file, std::string_view text, int times) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (std::chrono::steady_clock::now() < limit && program.running()) {
    const std::string content = content_of(file);
    int found = 0;
    for (std::size_t at = content.find(text); at != std::string::npos; at = content.find(text, at + text.size())) {
      ++found;
    }
    if (found >= times) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

}  // namespace slope::tools::test
