#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "animation.hpp"
#include "paper_figures.hpp"
#include "paper_report.hpp"
#include "pictures.hpp"
#include "render_window.hpp"
#include "run_figures.hpp"
#include "slope/couple/read_case.hpp"

namespace {

namespace fs = std::filesystem;
using namespace slope::tools;

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

int draw_run(const fs::path& folder, const std::string& out, PictureOptions options) {
  const auto run = read_run_folder(folder);
  options.folder = out_or(out, run.path / "figures");
  const Pictures pictures = write_pictures(run, options);
  for (const auto& note : pictures.notes) {
    std::fprintf(stderr, "%s\n", note.c_str());
  }
  for (const auto& file : pictures.written) {
    std::puts(file.c_str());
  }
  return 0;
}

int draw_paper(const std::vector<std::string>& folders, const std::string& out, int width) {
  const PaperRuns runs = read_paper_runs({folders.begin(), folders.end()});
  const auto figures = write_paper_figures(runs, out, width);
  const fs::path report = fs::path(out) / "report.md";
  write_paper_report(runs, report);
  std::puts(report.c_str());
  for (const auto& file : figures.written) {
    std::puts(file.c_str());
  }
  for (const auto& reason : figures.left_out) {
    std::fprintf(stderr, "left out: %s\n", reason.c_str());
  }
  return figures.written.empty() ? bad_input : 0;
}

int compare(const std::vector<std::string>& folders, const fs::path& out) {
  write_comparison({folders.begin(), folders.end()}, out);
  std::puts(out.c_str());
  return 0;
}

int animate(const fs::path& folder, const std::string& out, const PictureOptions& options) {
  const auto run = read_run_folder(folder);
  const fs::path target = out_or(out, run.path / "figures");
  const auto fields = options.fields.empty() ? std::vector<std::string>{"deviatoric_strain"} : options.fields;
  for (const auto& field : fields) {
    const auto frames = write_frames(run, field, target / "frames", options.width);
    std::printf("%s ... %s\n", frames.frame(0).c_str(), frames.frame(frames.count - 1).filename().c_str());
    if (const auto film = encode_film(frames, target / field, frames_per_second)) {
      std::puts(film->c_str());
    } else {
      std::fprintf(stderr, "%s: no film was made of the pictures, for none of these is there: %s\n", field.c_str(),
                   known_encoders().c_str());
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Draws the pictures of a run of slope-sim: contours, histories and profiles.", "slope-render");
  app.footer("Exit codes: 0 done, 2 bad arguments or case, 4 a file cannot be read or written.");
  std::vector<std::string> folders;
  PictureOptions options;
  std::string out;
  bool paper = false;
  bool animation = false;
  bool comparison = false;
  app.add_option("DIR", folders, "Output folder of slope-sim; with --paper or --compare, one or more")->required();
  auto* out_option = app.add_option(
      "-o,--out", out, "Folder for the pictures (default: DIR/figures); with --compare, the file to write");
  app.add_option("--width", options.width, "Width of the pictures in pixels")
      ->check(CLI::Range(400, 8000))
      ->capture_default_str();
  auto* times = app.add_option("--times", options.times,
                               "Times of the contour pictures in s, with commas (default: the case's, or start, onset "
                               "and end)")
                    ->delimiter(',');
  auto* field = app.add_option("--field", options.fields,
                               "Fields of the contour pictures, with commas: suction, deviatoric_strain, displacement, "
                               "pore_pressure, saturation, porosity (default: the first two)")
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
    if (paper) {
      return draw_paper(folders, out, options.width);
    }
    if (comparison) {
      return compare(folders, out);
    }
    return animation ? animate(folders.front(), out, options) : draw_run(folders.front(), out, options);
  } catch (const slope::couple::FileError& error) {
    return fail(error, input_output);
  } catch (const RenderError& error) {
    return fail(error, input_output);
  } catch (const slope::couple::InputError& error) {
    return fail(error, bad_input);
  } catch (const std::invalid_argument& error) {
    return fail(error, bad_input);
  }
}
