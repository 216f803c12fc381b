#include "text_file.hpp"

#include <fmt/format.h>

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
  if (!stream) throw couple::FileError(fmt::format("{}: cannot be written: {}", file.string(), system_message()));
  std::error_code error;
  std::filesystem::rename(unfinished, file, error);
  if (error) throw couple::FileError(fmt::format("{}: cannot be written: {}", file.string(), error.message()));
}

}  // namespace slope::tools
