#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "pictures.hpp"
#include "render_window.hpp"
#include "slope/couple/read_case.hpp"

namespace {

constexpr int bad_input = 2;
constexpr int input_output = 4;

int fail(const std::exception& error, int code) {
  std::fprintf(stderr, "%s\n", error.what());
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Draws the pictures of a run of slope-sim: contours, histories and profiles.", "slope-render");
  app.footer("Exit codes: 0 done, 2 bad arguments or case, 4 a file cannot be read or written.");
  std::string folder;
  slope::tools::PictureOptions options;
  std::string out;
  app.add_option("DIR", folder, "Output folder of slope-sim")->required();
  app.add_option("-o,--out", out, "Folder for the pictures (default: DIR/figures)");
  app.add_option("--width", options.width, "Width of the pictures in pixels")
      ->check(CLI::Range(400, 8000))
      ->capture_default_str();
  app.add_option("--times", options.times,
                 "Times of the contour pictures in s, with commas (default: the case's, or start, onset and end)")
      ->delimiter(',');
  app.add_option(
         "--field", options.fields,
         "Fields of the contour pictures, with commas: suction, deviatoric_strain, displacement, pore_pressure, "
         "saturation, porosity (default: the first two)")
      ->delimiter(',');
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_input;
  }

  try {
    const auto run = slope::tools::read_run_folder(folder);
    options.folder = out.empty() ? run.path / "figures" : std::filesystem::path(out);
    for (const auto& file : slope::tools::write_pictures(run, options)) {
      std::puts(file.c_str());
    }
    return 0;
  } catch (const slope::couple::FileError& error) {
    return fail(error, input_output);
  } catch (const slope::tools::RenderError& error) {
    return fail(error, input_output);
  } catch (const slope::couple::InputError& error) {
    return fail(error, bad_input);
  } catch (const std::invalid_argument& error) {
    return fail(error, bad_input);
  }
}
