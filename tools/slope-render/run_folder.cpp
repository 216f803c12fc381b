#include "run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "slope/couple/read_case.hpp"

namespace slope::tools {
namespace {

/// A time that the pictures can hold; else none, which is noted.
void keep_if_drawn(std::optional<double>& time, const std::filesystem::path& file, const char* key, Losses& losses) {
  if (!time || std::abs(*time) <= largest_drawn) return;
  losses.leave_out(fmt::format("{}: {}: {:g} s is no time that can be drawn", file.string(), key, *time));
  time.reset();
}

/// What the summary tells; of a run that was cut short before it wrote one, the onset is the snapshot's.
void take_summary(const std::filesystem::path& file, RunFolder& run, Losses& losses) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    const auto onset = std::ranges::find(run.snapshots, "onset", &Snapshot::label);
    run.onset = onset != run.snapshots.end() ? std::optional(onset->time) : std::nullopt;
    return;
  }
  std::vector<couple::Problem> not_understood;
  run.summary = couple::read_summary(file, &not_understood);
  for (const couple::Problem& problem : not_understood) run.notes.push_back(problem.text());
  couple::Summary& found = run.summary->found;
  keep_if_drawn(found.onset_time, file, "onset.time_s", losses);
  keep_if_drawn(found.displacement_onset, file, "onset_by_displacement_s", losses);
  keep_if_drawn(found.runaway_onset, file, "onset_by_runaway_s", losses);
  run.onset = found.onset_time;
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
  losses.attempt([&] { take_summary(path / "summary.json", run, losses); });
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
