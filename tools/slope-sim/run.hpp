#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run_writer.hpp"

namespace slope::tools {

/// How the program ends.
enum class ExitCode { fine = 0, fault = 1, bad_input = 2, broken_physics = 3, input_output = 4, interrupted = 130 };

struct RunOptions {
  std::filesystem::path case_file;  ///< empty: the case that lies in the folder
  std::filesystem::path folder;
  std::vector<std::string> overrides;  ///< "dotted.key=value"
  EarlierRun earlier = EarlierRun::refuse;
  double checkpoint_interval = 60.0;  ///< wall time between checkpoints (s), >= 0
  int threads = 1;
  bool quiet = false;
};

/// Runs a case and fills its output folder, or goes on where an earlier run in it was. Shows progress on the standard
/// error stream and a summary on the standard output. Whatever ends the run, what was computed until then is on disk.
/// @throws couple::InputError, couple::FileError
[[nodiscard]] ExitCode run(const RunOptions& options);

}  // namespace slope::tools
