#include "run_folder.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

#include "slope/couple/read_case.hpp"

namespace slope::tools {
namespace {

/// The onset that the summary tells; of a run that was cut short, the snapshot's.
std::optional<double> onset_time(const std::filesystem::path& summary, const std::vector<Snapshot>& snapshots) {
  if (std::filesystem::is_regular_file(summary)) {
    try {
      const auto time = YAML::LoadFile(summary.string())["onset"]["time_s"];  // JSON is YAML
      return time.IsDefined() && !time.IsNull() ? std::optional(time.as<double>()) : std::nullopt;
    } catch (const YAML::Exception& error) {
      throw couple::FileError(fmt::format("{}: cannot be read: {}", summary.string(), error.what()));
    }
  }
  const auto found = std::find_if(snapshots.begin(), snapshots.end(), [](const auto& s) { return s.label == "onset"; });
  return found != snapshots.end() ? std::optional(found->time) : std::nullopt;
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
  run.onset = onset_time(path / "summary.json", run.snapshots);
  return run;
}

const Snapshot& nearest_snapshot(const std::vector<Snapshot>& snapshots, double time) {
  return *std::min_element(snapshots.begin(), snapshots.end(), [time](const auto& a, const auto& b) {
    return std::abs(a.time - time) < std::abs(b.time - time);
  });
}

}  // namespace slope::tools
