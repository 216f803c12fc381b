#include "paper_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace slope::tools {
namespace {

bool is_paper_case(const std::string& name) {
  return std::ranges::find(paper_cases, name) != paper_cases.end();
}

}  // namespace

std::string paper_case_of(const RunFolder& run) {
  const std::string folder =
      std::filesystem::absolute(run.path / "").lexically_normal().parent_path().filename().string();
  if (is_paper_case(folder)) {
    return folder;
  }
  const std::string stem = std::filesystem::path(run.summary ? run.summary->case_file : "").stem().string();
  return is_paper_case(stem) ? stem : "";
}

PaperRuns read_paper_runs(const std::vector<std::filesystem::path>& folders) {
  PaperRuns result;
  std::map<std::string, std::filesystem::path> seen;
  for (const auto& folder : folders) {
    RunFolder run = read_run_folder(folder);
    const std::string name = paper_case_of(run);
    if (name.empty()) {
      throw std::invalid_argument(
          fmt::format("{}: is a run of none of the paper's cases; give its folder the name of "
                      "one: {}",
                      folder.string(), fmt::join(paper_cases, ", ")));
    }
    const auto [earlier, is_new] = seen.try_emplace(name, folder);
    if (!is_new) {
      throw std::invalid_argument(fmt::format("{} and {}: are both runs of {}; give one of them",
                                              earlier->second.string(), folder.string(), name));
    }
    if (run.summary && couple::is_complete(run.summary->found.end_reason)) {
      result.runs.emplace(name, std::move(run));
    } else {
      result.unusable.emplace(name, fmt::format("the run {} did not come to its end", folder.string()));
    }
  }
  return result;
}

}  // namespace slope::tools
