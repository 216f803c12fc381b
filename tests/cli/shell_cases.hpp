#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace slope::tools::test {

/// A line of a file of cases: a name, the shell command that makes the case, and what is expected of it.
struct ShellCase {
  std::string name, command;
  std::vector<std::string> expected;
};

std::ostream& operator<<(std::ostream& out, const ShellCase& shell_case);

/// The cases of a file, cells parted by " :: ". Lines that begin with '#' are comments; one that does not begin with a
/// name and " :: " goes on with the line before.
[[nodiscard]] std::vector<ShellCase> shell_cases(const std::filesystem::path& file, std::size_t expectations);

/// Runs a command in a folder, after some definitions.
/// @throws std::runtime_error if it fails.
void do_in(const std::filesystem::path& folder, const std::string& command, const std::string& definitions);

}  // namespace slope::tools::test
