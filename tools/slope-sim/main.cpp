#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "design.hpp"
#include "profile_file.hpp"
#include "read_study.hpp"
#include "run.hpp"
#include "slope/couple/geometry.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/results.hpp"
#include "standard_streams.hpp"
#include "starter_case.hpp"
#include "study_results.hpp"
#include "study_run.hpp"

namespace {

using slope::tools::ExitCode;

/// Reads the case and says what it holds.
void check(const std::string& file, const std::vector<std::string>& overrides) {
  std::vector<slope::couple::Problem> warnings;
  const slope::couple::Case input = slope::couple::read_case(file, overrides, &warnings);
  for (const auto& warning : warnings) std::fputs(fmt::format("warning: {}\n", warning.text()).c_str(), stderr);
  const slope::couple::Domain& domain = input.domain;
  const auto cells = [&](std::size_t axis) {
    return std::lround((domain.upper[axis] - domain.lower[axis]) / domain.cell_size);
  };
  slope::tools::say(fmt::format("{}: fine: {} particles of {} soil{} on {} x {} cells of {} m, until {:g} s\n", file,
                                first_particles(input).x.size(), input.soils.size(), input.soils.size() == 1 ? "" : "s",
                                cells(0), cells(1), domain.cell_size, input.stop.time));
}

/// Reads the study and says what it holds.
void check_study(const std::string& file) {
  const slope::tools::Study study = slope::tools::read_study(file).study;
  const std::size_t parameters = study.parameters.size(), runs = slope::tools::samples_of(study).size();
  slope::tools::say(fmt::format("{}: fine: {} parameter{}, {} runs at most of the design {}\n", file, parameters,
                                parameters == 1 ? "" : "s", runs, name_of(study.design)));
}

void add_case(CLI::App& command, std::string& file, std::vector<std::string>& overrides) {
  command.add_option("CASE", file, "Case file (YAML)")->required();
  command
      .add_option("--set", overrides,
                  "KEY=VALUE in place of what the case says, such as soils.clay.porosity=0.4; repeatable")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

void add_running(CLI::App& command, slope::tools::RunOptions& options) {
  command.add_option("--threads", options.threads, "Number of threads; the result does not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command
      .add_option("--checkpoint-interval", options.checkpoint_interval,
                  "Wall time in seconds after which a checkpoint is written, though never so often that it takes more "
                  "than a hundredth of the run")
      ->check(CLI::Range(0.0, 1.0e9))
      ->capture_default_str();
  command.add_flag("--quiet", options.quiet, "No progress, no summary");
}

void add_study(CLI::App& app, slope::tools::StudyOptions& study, std::string& engine) {
  CLI::App* command = app.add_subcommand("study", "Runs a case many times with parameters that are not known for sure");
  command->add_option("STUDY", study.file, "Study file (YAML)")->required();
  command->add_option("-o,--output", study.folder, "Output folder; a study in it goes on where it was left")
      ->required();
  command->add_option("-j,--jobs", study.jobs.at_once, "Number of runs at once; the result does not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--engine", engine, "What starts the runs: xargs, or GNU parallel")
      ->check(CLI::IsMember({"xargs", "parallel"}))
      ->capture_default_str();
  command->add_flag(
      "--list", study.lists,
      "Prints the commands of the runs to come, one a line, instead of running them: for GNU parallel, or "
      "an array of jobs; afterwards the same command without it tells the result");
  command->add_flag("--quiet", study.quiet, "No progress, no results on the standard output");
}

ExitCode fail(const std::exception& error, ExitCode code) {
  std::fprintf(stderr, "%s\n", error.what());
  return code;
}

/// Of the commands that make a file, or print what one should hold.
struct FileOptions {
  std::string poly_line, profile, starter;
  bool of_results = false, of_study = false;
};

std::string schema_of(const FileOptions& files) {
  if (files.of_study) return files.of_results ? slope::tools::study_results_schema() : slope::tools::study_schema();
  return files.of_results ? slope::couple::summary_schema() : slope::couple::case_schema();
}

ExitCode execute(const CLI::App& app, const slope::tools::RunOptions& options, const FileOptions& files,
                 const slope::tools::StudyOptions& study) {
  try {
    if (app.got_subcommand("schema")) {
      slope::tools::say(schema_of(files));
    } else if (app.got_subcommand("study")) {
      const ExitCode code = slope::tools::run_study(study);
      if (code != ExitCode::fine) return code;
    } else if (app.got_subcommand("check") && slope::tools::is_study(options.case_file)) {
      check_study(options.case_file.string());
    } else if (app.got_subcommand("check")) {
      check(options.case_file.string(), options.overrides);
    } else if (app.got_subcommand("new")) {
      slope::tools::write_starter_case(files.starter);
      slope::tools::say(fmt::format("{}: written; slope-sim run {} -o results\n", files.starter, files.starter));
    } else if (app.got_subcommand("profile")) {
      slope::tools::write_profile(files.profile, slope::tools::read_poly_line(files.poly_line));
    } else {
      const ExitCode code = options.tells_safety ? slope::tools::tell_safety(options) : slope::tools::run(options);
      if (code != ExitCode::fine) return code;
    }
    slope::tools::flush_output();
    return ExitCode::fine;
  } catch (const slope::couple::InputError& error) {
    return fail(error, ExitCode::bad_input);
  } catch (const slope::couple::FileError& error) {
    return fail(error, ExitCode::input_output);
  } catch (const std::bad_alloc&) {
    return fail(std::runtime_error("there is not enough memory"), ExitCode::fault);
  } catch (const std::exception& error) {
    return fail(error, ExitCode::fault);
  }
}

}  // namespace

int main(int argc, char** argv) {
  slope::tools::open_standard_streams();
  slope::tools::survive_failed_writes();
  CLI::App app("Rain-induced slope failure: soil as material points, pore water as smoothed particles.", "slope-sim");
  app.set_version_flag("--version", std::string("slope-sim ") + SLOPE_VERSION);
  app.footer(
      "Exit codes: 0 fine, 1 a fault of the program, 2 bad arguments or case, 3 the physics broke,\n"
      "4 a file cannot be read or written, 130 interrupted. Whatever ends a run, what was computed until then is in\n"
      "the output folder, and slope-sim resume goes on with it. SIGUSR1 asks a run for a checkpoint.");
  app.require_subcommand(1);

  slope::tools::RunOptions options;
  FileOptions files;
  std::string case_file;
  std::string folder;
  CLI::App* run = app.add_subcommand("run", "Runs a case and fills an output folder");
  add_case(*run, case_file, options.overrides);
  run->add_option("-o,--output", folder, "Output folder; one that holds an earlier run is refused")->required();
  bool overwrites = false, resumes = false;
  CLI::Option* overwrite = run->add_flag("--overwrite", overwrites, "Replaces an earlier run in the folder");
  run->add_flag("--resume", resumes, "Goes on with an earlier run in the folder, or begins if there is none")
      ->excludes(overwrite);
  CLI::App* resume = app.add_subcommand("resume", "Goes on with the run in an output folder from its checkpoint");
  resume->add_option("FOLDER", folder, "Output folder of slope-sim run")->required();
  for (CLI::App* command : {run, resume}) add_running(*command, options);
  CLI::App* safety = app.add_subcommand("safety", "Finds the factor of safety of a case by strength reduction");
  add_case(*safety, case_file, options.overrides);
  std::string times, tolerance;
  safety->add_option("--at", times, "Times, such as \"0 h, 18 h\"; without them those of the case, or the start");
  safety->add_option("--tolerance", tolerance, "Width of the bracket over the factor; without it that of the case");
  safety->add_option("-o,--output", folder, "Output folder, as of run; without it nothing is kept");
  overwrite = safety->add_flag("--overwrite", overwrites, "Replaces an earlier run in the folder");
  safety->add_flag("--resume", resumes, "Goes on with an earlier run in the folder, or begins if there is none")
      ->excludes(overwrite);
  add_running(*safety, options);
  CLI::App* check = app.add_subcommand("check", "Says what is wrong with a case or a study, or that it is fine");
  add_case(*check, case_file, options.overrides);
  slope::tools::StudyOptions study;
  std::string engine = "xargs";
  add_study(app, study, engine);
  CLI::App* schema = app.add_subcommand("schema", "Prints the JSON Schema of case files");
  schema->add_flag("--results", files.of_results,
                   "Of summary.json instead: unit, sign and meaning of each of its keys");
  schema->add_flag("--study", files.of_study, "Of study files, or with --results of study.json");
  CLI::App* starter = app.add_subcommand("new", "Writes a small, commented case to start from");
  starter->add_option("FILE", files.starter, "Case file to write; an existing one is left alone")->required();
  CLI::App* profile = app.add_subcommand("profile", "Turns a VTK poly-line into a table for geometry.surface");
  profile->add_option("VTP", files.poly_line, "VTK PolyData file (.vtp): x to the right, y upwards, in metres")
      ->required();
  profile->add_option("-o,--output", files.profile, "CSV file to write")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::bad_input);
  }
  options.case_file = case_file;
  options.folder = folder;
  if (overwrites) options.earlier = slope::tools::EarlierRun::overwrite;
  if (resumes || resume->parsed()) options.earlier = slope::tools::EarlierRun::resume;
  if (safety->parsed()) {
    if (!times.empty()) options.overrides.push_back("safety.times=[" + times + "]");
    if (!tolerance.empty()) options.overrides.push_back("safety.tolerance=" + tolerance);
    options.tells_safety = true;
  }
  if (engine == "parallel") study.jobs.engine = slope::tools::Engine::parallel;
  study.program = std::filesystem::read_symlink("/proc/self/exe");
  return static_cast<int>(execute(app, options, files, study));
}
