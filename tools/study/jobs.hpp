#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace slope::tools {

/// What starts the processes: a program that takes shell commands line by line.
enum class Engine { xargs, parallel };

struct JobOptions {
  Engine engine = Engine::xargs;
  int at_once = 1;  ///< processes
};

/// A word as a shell takes it for one.
[[nodiscard]] std::string quoted(const std::string& word);

/// Runs shell commands, one a line of a file, and waits for their end. What is interrupted is interrupted in the
/// commands too. If this program is killed, the engine starts no more of them.
/// @param look  called about once a second
/// @throws couple::FileError if the engine cannot be started.
void run_jobs(const std::filesystem::path& file, const JobOptions& options, const std::function<void()>& look);

/// Waits until no other program is at work in any of the folders, as the runs of a study are that was killed.
void wait_for_others(const std::vector<std::filesystem::path>& folders);

}  // namespace slope::tools
