#pragma once

#include <filesystem>

#include "jobs.hpp"
#include "run.hpp"

namespace slope::tools {

struct StudyOptions {
  std::filesystem::path file;     ///< of the study
  std::filesystem::path folder;   ///< for its results and its runs
  std::filesystem::path program;  ///< slope-sim, which the runs are started with
  JobOptions jobs;
  bool lists = false;  ///< prints the commands of the runs to come instead of running them
  bool quiet = false;
};

/// Runs what is not finished of a study, and fills its folder: study.csv and study.json, and a run in each folder of
/// runs/. Started again it goes on; whatever interrupted it, the same study leaves the same study.csv and study.json.
/// @throws couple::InputError, couple::FileError
[[nodiscard]] ExitCode run_study(const StudyOptions& options);

}  // namespace slope::tools
