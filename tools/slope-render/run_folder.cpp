#include "run_folder.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "slope/couple/read_case.hpp"
#include "slope/couple/text_file.hpp"

namespace slope::tools {
namespace {

constexpr std::size_t most_summary_bytes = 10'000'000;

/// A number under a key, if there is one; null is none.
std::optional<double> number_at(const YAML::Node& map, const char* key, const std::string& name) {
  if (!map.IsMap()) throw couple::FileError(fmt::format("{} is not a map of keys", name));
  const YAML::Node node = map[key];
  if (!node.IsDefined() || node.IsNull()) return std::nullopt;
  const double value = node.IsScalar() ? node.as<double>(largest_drawn * 2.0) : largest_drawn * 2.0;
  if (!(std::abs(value) <= largest_drawn)) throw couple::FileError(fmt::format("{}.{} is not a number", name, key));
  return value;
}

void take_summary(const YAML::Node& summary, RunFolder& run) {
  const YAML::Node onset = summary["onset"];
  if (onset.IsDefined() && !onset.IsNull()) run.onset = number_at(onset, "time_s", "onset");
  run.displacement_onset = number_at(summary, "onset_by_displacement_s", "summary");
  run.runaway_onset = number_at(summary, "onset_by_runaway_s", "summary");
  run.case_file = summary["case"].as<std::string>("");
  const YAML::Node end = summary["end"];
  const std::string reason = end.IsDefined() && end.IsMap() ? end["reason"].as<std::string>("") : "";
  run.complete = reason == "time" || reason == "displacement" || reason == "after_onset" || reason == "at_rest";
  const YAML::Node zones = summary["failure_zone"];
  if (!zones.IsDefined() || !zones.IsMap()) return;
  const YAML::Node zone = zones["at_end"];
  if (!zone.IsDefined() || !zone.IsMap()) return;
  const auto length = number_at(zone, "length_m", "failure_zone.at_end");
  const auto height = number_at(zone, "height_m", "failure_zone.at_end");
  if (length && height) run.zone = ZoneSize{*length, *height};
}

/// What the summary tells; of a run that was cut short before it wrote one, the onset is the snapshot's.
void read_summary(const std::filesystem::path& file, RunFolder& run) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    const auto onset = std::ranges::find(run.snapshots, "onset", &Snapshot::label);
    run.onset = onset != run.snapshots.end() ? std::optional(onset->time) : std::nullopt;
    return;
  }
  const std::string content = couple::read_text_file(file, most_summary_bytes);
  try {
    const YAML::Node summary = YAML::Load(content);  // JSON is YAML
    if (!summary.IsMap()) throw couple::FileError("is not a summary");
    take_summary(summary, run);
  } catch (const YAML::Exception& wrong) {
    throw couple::FileError(fmt::format("{}: cannot be read: {}", file.string(), wrong.what()));
  } catch (const couple::FileError& wrong) {
    throw couple::FileError(fmt::format("{}: {}", file.string(), wrong.what()));
  }
}

/// A table over time whose rows go forward and whose values can be drawn; what cannot be is noted, and NaN.
CsvTable read_history(const std::filesystem::path& file, Losses& losses) {
  CsvTable table = read_csv(file);
  if (table.columns.empty() || !table.names.front().starts_with("time"))
    throw couple::FileError(fmt::format("{}: has no column of times", file.string()));
  const std::vector<double> times = table.columns.front();
  std::vector<std::size_t> kept;
  for (std::size_t row = 0; row < times.size(); ++row) {
    const bool forward = kept.empty() || times[row] >= times[kept.back()];
    if (std::abs(times[row]) <= largest_drawn && forward) kept.push_back(row);
  }
  if (const std::size_t lost = times.size() - kept.size(); lost > 0) {
    losses.leave_out(fmt::format("{}: {} no time, or one before that of the row above, and {} left out", file.string(),
                                 lost == 1 ? "1 row has" : fmt::format("{} rows have", lost),
                                 lost == 1 ? "is" : "are"));
  }
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t lost = 0;
    std::vector<double> values;
    for (const std::size_t row : kept) {
      const double value = table.columns[c][row];
      const bool drawn = std::abs(value) <= largest_drawn;
      lost += drawn ? 0 : 1;
      values.push_back(drawn ? value : std::numeric_limits<double>::quiet_NaN());
    }
    table.columns[c] = std::move(values);
    if (lost == 0) continue;
    losses.leave_out(fmt::format("{}: {} value{} of \"{}\" {} no number{} that can be drawn", file.string(), lost,
                                 lost == 1 ? "" : "s", table.names[c], lost == 1 ? "is" : "are", lost == 1 ? "" : "s"));
  }
  return table;
}

}  // namespace

RunFolder read_run_folder(const std::filesystem::path& path, Losses& losses) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) {
    throw couple::FileError(fmt::format("{}: no such folder; give an output folder of slope-sim", path.string()));
  }
  RunFolder run;
  run.path = path;
  if (!losses.attempt([&] { run.snapshots = read_particle_series(path); })) {
    run.snapshots = find_particle_files(path);
  }
  losses.attempt([&] { run.input = couple::read_case(path / "case.yaml"); });
  losses.attempt([&] { run.history = read_history(path / "history.csv", losses); });
  if (std::filesystem::exists(path / "budget.csv", error)) {
    losses.attempt([&] { run.budget = read_history(path / "budget.csv", losses); });
  }
  losses.attempt([&] { read_summary(path / "summary.json", run); });
  return run;
}

RunFolder read_run_folder(const std::filesystem::path& path) {
  Losses losses;
  RunFolder run = read_run_folder(path, losses);
  losses.throw_first();
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
