#include "encoder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#ifdef SLOPE_HAS_THEORA
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>
#include <vtkPNGReader.h>

#include "quiet_vtk.hpp"
#endif

namespace slope::tools {
namespace {

namespace fs = std::filesystem;

/// Runs a program from the PATH and lets nothing of what it says through.
/// @return whether there is such a program and it succeeded.
bool run_quietly(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (auto& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, arguments.front(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failure != 0) {
    return false;
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool written(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  return !error && size > 0;
}

bool encode_with_ffmpeg(const FrameSequence& frames, const fs::path& film, int rate) {
  // The colours of all frames together make the palette: a palette for each frame would flicker.
  return run_quietly({"ffmpeg", "-y", "-framerate", std::to_string(rate), "-i",
                      (frames.folder / (frames.stem + "_%04d.png")).string(), "-filter_complex",
                      "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none", "-loop", "0", film.string()});
}

bool encode_with_image_magick(const std::string& program, const FrameSequence& frames, const fs::path& film, int rate) {
  std::vector<std::string> words{program, "-delay", std::to_string(100 / rate), "-loop", "0"};
  for (int i = 0; i < frames.count; ++i) {
    words.push_back(frames.frame(i).string());
  }
  words.insert(words.end(), {"+dither", "-layers", "optimize", film.string()});
  return run_quietly(words);
}

#ifdef SLOPE_HAS_THEORA
bool encode_with_theora(const FrameSequence& frames, const fs::path& film, int rate) {
  const QuietVtk quiet;
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(frames.frame(0).c_str());
  vtkNew<vtkOggTheoraWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName(film.c_str());
  writer->SetQuality(2);
  writer->SetRate(rate);
  writer->SubsamplingOff();
  writer->Start();
  for (int i = 0; i < frames.count; ++i) {
    reader->SetFileName(frames.frame(i).c_str());
    writer->Write();
  }
  writer->End();
  return writer->GetError() == 0;
}
#endif

}  // namespace

fs::path FrameSequence::frame(int index) const {
  return folder / fmt::format("{}_{:04d}.png", stem, index);
}

std::optional<fs::path> encode_film(const FrameSequence& frames, const fs::path& film, int frames_per_second) {
  const fs::path gif = film.string() + ".gif";
  std::error_code ignored;
  fs::remove(gif, ignored);
  if ((encode_with_ffmpeg(frames, gif, frames_per_second) && written(gif)) ||
      (encode_with_image_magick("magick", frames, gif, frames_per_second) && written(gif)) ||
      (encode_with_image_magick("convert", frames, gif, frames_per_second) && written(gif))) {
    return gif;
  }
  fs::remove(gif, ignored);  // what an encoder that failed may have begun
#ifdef SLOPE_HAS_THEORA
  const fs::path video = film.string() + ".ogv";
  if (encode_with_theora(frames, video, frames_per_second) && written(video)) {
    return video;
  }
#endif
  return std::nullopt;
}

std::string known_encoders() {
  return "ffmpeg, ImageMagick's magick or convert, a VTK with its Theora writer";
}

}  // namespace slope::tools
