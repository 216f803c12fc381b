#include "run_folder.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

#include "slope/couple/read_case.hpp"

namespace slope::tools {
namespace {

/// What the summary tells; of a run that was cut short before it wrote one, the onset is the snapshot's.
void read_summary(const std::filesystem::path& file, RunFolder& run) {
  if (!std::filesystem::is_regular_file(file)) {
    const auto onset = std::ranges::find(run.snapshots, "onset", &Snapshot::label);
    run.onset = onset != run.snapshots.end() ? std::optional(onset->time) : std::nullopt;
    return;
  }
  try {
    YAML::Node summary = YAML::LoadFile(file.string());  // JSON is YAML
    const auto time = summary["onset"]["time_s"];
    const auto number = [](const YAML::Node& node) {
      return node.IsDefined() && !node.IsNull() ? std::optional(node.as<double>()) : std::nullopt;
    };
    run.onset = number(time);
    run.displacement_onset = number(summary["onset_by_displacement_s"]);
    run.runaway_onset = number(summary["onset_by_runaway_s"]);
    run.case_file = summary["case"].as<std::string>("");
    const auto reason = summary["end"]["reason"].as<std::string>("");
    run.complete = reason == "time" || reason == "displacement" || reason == "after_onset" || reason == "at_rest";
    const YAML::Node zone = summary["failure_zone"]["at_end"];
    if (zone.IsDefined() && zone.IsMap()) {
      run.zone = ZoneSize{zone["length_m"].as<double>(), zone["height_m"].as<double>()};
    }
  } catch (const YAML::Exception& error) {
    throw couple::FileError(fmt::format("{}: cannot be read: {}", file.string(), error.what()));
  }
}

}  // namespace

RunFolder read_run_folder(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) {
    throw couple::FileError(fmt::format("{}: no such folder; give an output folder of slope-sim", path.string()));
  }
  RunFolder run;
  run.path = path;
  run.snapshots = read_particle_series(path);
  if (run.snapshots.empty()) {
    throw couple::FileError(fmt::format("{}: holds no snapshot yet", (path / particle_collection).string()));
  }
  run.input = couple::read_case(path / "case.yaml");
  run.history = read_csv(path / "history.csv");
  if (std::filesystem::is_regular_file(path / "budget.csv")) run.budget = read_csv(path / "budget.csv");
  read_summary(path / "summary.json", run);
  return run;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw couple::FileError(fmt::format("{}: cannot be created: {}", folder.string(), error.message()));
  }
}

const Snapshot& nearest_snapshot(const std::vector<Snapshot>& snapshots, double time) {
  return *std::min_element(snapshots.begin(), snapshots.end(), [time](const auto& a, const auto& b) {
    return std::abs(a.time - time) < std::abs(b.time - time);
  });
}

}  // namespace slope::tools
