#include "text_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "slope/couple/read_case.hpp"

namespace slope::tools {

std::string system_message() {
  return errno != 0 ? std::strerror(errno) : "unknown reason";
}

void write_at_once(const std::filesystem::path& file, std::string_view content) {
  std::filesystem::path unfinished = file;
  unfinished += ".tmp";
  errno = 0;
  std::ofstream stream(unfinished, std::ios::binary);
  stream << content;
  stream.close();
  const std::string reason = stream ? "" : system_message();
  std::error_code error;
  if (!stream) {
    std::filesystem::remove(unfinished, error);
    throw couple::FileError(fmt::format("{}: cannot be written: {}", file.string(), reason));
  }
  std::filesystem::rename(unfinished, file, error);
  if (error) throw couple::FileError(fmt::format("{}: cannot be written: {}", file.string(), error.message()));
}

void synchronise_file(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = descriptor >= 0 && fsync(descriptor) == 0;
  const int reason = errno;
  if (descriptor >= 0) close(descriptor);
  if (!done)
    throw couple::FileError(fmt::format("{}: cannot be brought to the disk: {}", file.string(), std::strerror(reason)));
}

void cut_back(const std::filesystem::path& file, std::uintmax_t kept_bytes) {
  std::error_code error;
  const std::uintmax_t length = std::filesystem::file_size(file, error);
  if (!error && length < kept_bytes) {
    throw couple::FileError(fmt::format("{}: has {} bytes instead of the {} that the checkpoint counts on",
                                        file.string(), length, kept_bytes));
  }
  if (!error) std::filesystem::resize_file(file, kept_bytes, error);
  if (error) throw couple::FileError(fmt::format("{}: cannot be cut back: {}", file.string(), error.message()));
}

}  // namespace slope::tools
