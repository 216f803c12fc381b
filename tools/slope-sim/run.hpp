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
  bool tells_safety = false;   ///< at the end, instead of the summary
  bool keeps_nothing = false;  ///< the folder is gone afterwards
};

/// Runs a case and fills its output folder, or goes on where an earlier run in it was. Shows progress on the standard
/// error stream and a summary on the standard output. Whatever ends the run, what was computed until then is on disk.
/// @throws couple::InputError, couple::FileError
[[nodiscard]] ExitCode run(const RunOptions& options);

/// Runs a case to the last time at which its factor of safety is asked for, which is the start if it asks for none, and
/// tells what was found. Without a folder nothing is kept.
/// @throws couple::InputError, couple::FileError
[[nodiscard]] ExitCode tell_safety(RunOptions options);

}  // namespace slope::tools
