#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "animation.hpp"
#include "paper_figures.hpp"
#include "paper_report.hpp"
#include "pictures.hpp"
#include "render_window.hpp"
#include "run_figures.hpp"
#include "slope/couple/read_case.hpp"
#include "standard_streams.hpp"
#include "study_pictures.hpp"

namespace {

namespace fs = std::filesystem;
using namespace slope::tools;

constexpr int fault = 1;
constexpr int bad_input = 2;
constexpr int input_output = 4;
constexpr int frames_per_second = 4;

int fail(const std::exception& error, int code) {
  std::fprintf(stderr, "%s\n", error.what());
  return code;
}

fs::path out_or(const std::string& out, const fs::path& otherwise) {
  return out.empty() ? otherwise : fs::path(out);
}

/// Tells what was lost, and how the program ends then.
int tell(const Losses& losses) {
  for (const auto& message : losses.messages()) {
    std::fprintf(stderr, "%s\n", message.c_str());
  }
  return losses.bad_input() ? bad_input : losses.messages().empty() ? 0 : input_output;
}

int worse(int one, int other) {
  return one == bad_input || other == bad_input ? bad_input : std::max(one, other);
}

void tell(const std::vector<std::string>& notes) {
  for (const auto& note : notes) std::fprintf(stderr, "%s\n", note.c_str());
}

int draw_run(const fs::path& folder, const std::string& out, PictureOptions options) {
  Losses losses;
  const auto run = read_run_folder(folder, losses);
  const int read = tell(losses);
  tell(run.notes);
  options.folder = out_or(out, run.path / "figures");
  const Pictures pictures = write_pictures(run, options);
  tell(pictures.notes);
  for (const auto& file : pictures.written) {
    say(file.string() + "\n");
  }
  return worse(read, tell(pictures.losses));
}

int draw_study(const fs::path& folder, const std::string& out, int width) {
  Losses losses;
  for (const auto& file : write_study_pictures(folder, out_or(out, folder / "figures"), width, losses)) {
    say(file.string() + "\n");
  }
  return tell(losses);
}

int draw_paper(const std::vector<std::string>& folders, const std::string& out, int width) {
  const PaperRuns runs = read_paper_runs({folders.begin(), folders.end()});
  for (const auto& [name, run] : runs.runs) tell(run.notes);
  const auto figures = write_paper_figures(runs, out, width);
  const fs::path report = fs::path(out) / "report.md";
  write_paper_report(runs, report);
  say(report.string() + "\n");
  for (const auto& file : figures.written) {
    say(file.string() + "\n");
  }
  for (const auto& reason : figures.left_out) {
    std::fprintf(stderr, "left out: %s\n", reason.c_str());
  }
  return figures.written.empty() ? bad_input : 0;
}

int compare(const std::vector<std::string>& folders, const fs::path& out) {
  tell(write_comparison({folders.begin(), folders.end()}, out));
  say(out.string() + "\n");
  return 0;
}

int animate(const fs::path& folder, const std::string& out, const PictureOptions& options) {
  Losses losses;
  const auto run = read_run_folder(folder);
  tell(run.notes);
  const fs::path target = out_or(out, run.path / "figures");
  const auto fields = options.fields.empty() ? std::vector<std::string>{"deviatoric_strain"} : options.fields;
  for (const auto& field : fields) {
    const auto frames = write_frames(run, field, target / "frames", options.width, losses);
    if (frames.count == 0) continue;
    say(frames.frame(0).string() + " ... " + frames.frame(frames.count - 1).filename().string() + "\n");
    if (const auto film = encode_film(frames, target / field, frames_per_second)) {
      say(film->string() + "\n");
    } else {
      std::fprintf(stderr, "%s: no film was made of the pictures, for none of these is there: %s\n", field.c_str(),
                   known_encoders().c_str());
    }
  }
  return tell(losses);
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  survive_failed_writes();
  CLI::App app(
      "Draws the pictures of a run of slope-sim, contours, histories and profiles, or of a study of many runs.",
      "slope-render");
  app.footer(
      "Exit codes: 0 done, 1 a fault of the program, 2 bad arguments or case, 4 a file cannot be read or written.\n"
      "Of a folder that is damaged, what can be drawn is drawn, and the rest is named.");
  std::vector<std::string> folders;
  PictureOptions options;
  std::string out;
  bool paper = false;
  bool animation = false;
  bool comparison = false;
  app.add_option("DIR", folders,
                 "Output folder of slope-sim run, safety or study; with --paper or --compare, one or more")
      ->required();
  auto* out_option = app.add_option(
      "-o,--out", out, "Folder for the pictures (default: DIR/figures); with --compare, the file to write");
  app.add_option("--width", options.width, "Width of the pictures in pixels")
      ->check(CLI::Range(400, 8000))
      ->capture_default_str();
  auto* times = app.add_option("--times", options.times,
                               "Times of the contour pictures in s, with commas (default: the case's, or start, onset "
                               "and end)")
                    ->delimiter(',')
                    ->check([](const std::string& time) {
                      return std::abs(std::strtod(time.c_str(), nullptr)) <= largest_drawn
                                 ? std::string()
                                 : "\"" + time + "\" is no time that a run can have";
                    });
  auto* field =
      app.add_option("--field", options.fields,
                     "Fields of the contour pictures, with commas: suction, deviatoric_strain, displacement, "
                     "pore_pressure, saturation, porosity, preconsolidation_pressure, mechanism_shear_strain, "
                     "mechanism_speed (default: the first "
                     "two)")
          ->delimiter(',');
  auto* paper_flag =
      app.add_flag("--paper", paper,
                   "Draws the paper's Figs. 4 and 6 to 18, and judges its claims in report.md, from the runs of its "
                   "cases, which are known by the "
                   "names of their folders: liakopoulos, slope-w1 to slope-w3, slope-h1 to slope-h3; names "
                   "what it leaves out")
          ->needs(out_option)
          ->excludes(times)
          ->excludes(field);
  auto* comparison_flag =
      app.add_flag("--compare", comparison,
                   "Writes a table of runs side by side in Markdown: displacement times, failure zones, suction left")
          ->needs(out_option)
          ->excludes(times)
          ->excludes(field)
          ->excludes(paper_flag);
  app.add_flag("--animate", animation,
               "Draws every snapshot with one colour scale, the deviatoric strain unless --field says "
               "otherwise, and makes a film of them if there is an encoder")
      ->excludes(times)
      ->excludes(paper_flag)
      ->excludes(comparison_flag);
  try {
    app.parse(argc, argv);
    if (folders.size() > 1 && !paper && !comparison) {
      throw CLI::ValidationError("DIR", "more than one folder is only for --paper and --compare");
    }
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_input;
  }

  try {
    const int code = paper                          ? draw_paper(folders, out, options.width)
                     : comparison                   ? compare(folders, out)
                     : holds_study(folders.front()) ? draw_study(folders.front(), out, options.width)
                     : animation                    ? animate(folders.front(), out, options)
                                                    : draw_run(folders.front(), out, options);
    flush_output();
    return code;
  } catch (const slope::couple::FileError& error) {
    return fail(error, input_output);
  } catch (const RenderError& error) {
    return fail(error, input_output);
  } catch (const slope::couple::InputError& error) {
    return fail(error, bad_input);
  } catch (const std::invalid_argument& error) {
    return fail(error, bad_input);
  } catch (const fs::filesystem_error& error) {
    return fail(error, input_output);
  } catch (const std::exception& error) {
    return fail(error, fault);
  }
}
