#include "run_writer.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <utility>

#include "slope/couple/read_case.hpp"
#include "text_file.hpp"

namespace slope::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::array run_files{"case.yaml", "log.txt", "history.csv", "budget.csv", "summary.json", "summary.json.tmp"};

bool is_particle_file(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with("particles") && (name.ends_with(".vtp") || name.ends_with(".pvd"));
}

/// A run writes its case and its log before anything else.
bool holds_run(const fs::path& folder) {
  return fs::exists(folder / "case.yaml") && fs::exists(folder / "log.txt");
}

void remove_run(const fs::path& folder) {
  for (const char* name : run_files) fs::remove(folder / name);
  std::vector<fs::path> particle_files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (is_particle_file(entry.path())) particle_files.push_back(entry.path());
  }
  for (const fs::path& file : particle_files) fs::remove(file);
}

void prepare(const fs::path& folder) {
  fs::create_directories(folder);
  if (fs::is_empty(folder)) return;
  if (!holds_run(folder)) {
    throw couple::FileError(
        fmt::format("{}: holds something else than a run of slope-sim; choose another folder", folder.string()));
  }
  remove_run(folder);
}

}  // namespace

RunWriter::RunWriter(fs::path folder) : folder_(std::move(folder)) {
  try {
    prepare(folder_);
  } catch (const fs::filesystem_error& error) {
    throw couple::FileError(
        fmt::format("{}: cannot be used as output folder: {}", folder_.string(), error.code().message()));
  }
  errno = 0;
  log_.open(folder_ / "log.txt");
  if (!log_)
    throw couple::FileError(fmt::format("{}: cannot be written: {}", (folder_ / "log.txt").string(), system_message()));
  particles_.emplace(folder_);
}

void RunWriter::write_case(couple::Case input) {
  if (!input.figures.profile_reference.empty()) {
    const fs::path source = fs::path(input.path).parent_path() / input.figures.profile_reference;
    const fs::path copy = folder_ / source.filename();
    std::error_code error;
    if (!fs::equivalent(source, copy, error)) {
      fs::copy_file(source, copy, fs::copy_options::overwrite_existing, error);
      if (error)
        throw couple::FileError(
            fmt::format("{}: cannot be copied to {}: {}", source.string(), folder_.string(), error.message()));
    }
    input.figures.profile_reference = source.filename().string();
  }
  write_at_once(folder_ / "case.yaml", couple::resolved_yaml(input));
}

void RunWriter::begin_history(const std::vector<couple::HistoryColumn>& columns) {
  history_.emplace(folder_ / "history.csv", columns);
}

void RunWriter::add_history(const std::vector<double>& row) {
  history_.value().add(row);
}

void RunWriter::begin_budget(const std::vector<couple::HistoryColumn>& columns) {
  budget_.emplace(folder_ / "budget.csv", columns);
}

void RunWriter::add_budget(const std::vector<double>& row) {
  budget_.value().add(row);
}

void RunWriter::add_snapshot(const couple::ParticleTable& particles, std::string_view label) {
  particles_.value().write(particles, label);
}

void RunWriter::write_summary(const couple::Case& input, const couple::Summary& summary, const RunRecord& record) {
  write_at_once(folder_ / "summary.json", summary_json(input, summary, record));
}

void RunWriter::log(std::string_view lines) {
  errno = 0;
  log_ << lines << '\n' << std::flush;
  if (!log_)
    throw couple::FileError(fmt::format("{}: cannot be written: {}", (folder_ / "log.txt").string(), system_message()));
}

}  // namespace slope::tools
