#include "shell_cases.hpp"

#include <cstdlib>
#include <fstream>
#include <ostream>
#include <stdexcept>

namespace slope::tools::test {

namespace {

ShellCase case_of(std::string line, std::size_t expectations) {
  std::vector<std::string> cells;
  for (std::size_t end = line.find(" ::"); end != std::string::npos; end = line.find(" ::")) {
    cells.push_back(line.substr(0, end));
    line.erase(0, std::min(end + 4, line.size()));
  }
  cells.push_back(line);
  if (cells.size() != expectations + 2) throw std::runtime_error("not a case: " + line);
  return {cells[0], cells[1], {cells.begin() + 2, cells.end()}};
}

bool begins_case(const std::string& line) {
  const auto end = line.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789");
  return end != std::string::npos && end > 0 && line.compare(end, 4, " :: ") == 0;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const ShellCase& shell_case) {
  return out << shell_case.command.substr(0, 200);
}

std::vector<ShellCase> shell_cases(const std::filesystem::path& file, std::size_t expectations) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (begins_case(line)) {
      lines.push_back(line);
    } else {
      lines.back() += '\n' + line;
    }
  }
  std::vector<ShellCase> cases;
  for (const std::string& line : lines) cases.push_back(case_of(line, expectations));
  return cases;
}

void do_in(const std::filesystem::path& folder, const std::string& command, const std::string& definitions) {
  const std::filesystem::path script = folder.parent_path() / "command.sh";
  std::ofstream(script) << definitions << command << '\n';
  const std::string call = "cd '" + folder.string() + "' && sh '" + script.string() + "'";
  if (std::system(call.c_str()) != 0) throw std::runtime_error("this failed: " + command);
}

}  // namespace slope::tools::test
