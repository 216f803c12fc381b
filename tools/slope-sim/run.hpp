#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slope::tools {

/// How the program ends.
enum class ExitCode { fine = 0, fault = 1, bad_input = 2, broken_physics = 3, input_output = 4, interrupted = 130 };

struct RunOptions {
  std::filesystem::path case_file;
  std::filesystem::path folder;
  std::vector<std::string> overrides;  ///< "dotted.key=value"
  int threads = 1;
  bool quiet = false;
};

/// Runs a case and fills its output folder. Shows progress on the standard error stream and a summary on the standard
/// output. Whatever ends the run, what was computed until then is on disk.
/// @throws couple::InputError, couple::FileError
[[nodiscard]] ExitCode run(const RunOptions& options);

}  // namespace slope::tools
