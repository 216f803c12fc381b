#include "slope/couple/text_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "slope/couple/read_case.hpp"

namespace slope::couple {

namespace {

namespace fs = std::filesystem;

/// Bytes of the letter at the beginning of a text; 1 for a byte that begins none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) >= 0xF0 && byte(0) < 0xF5 ? 4 : byte(0) >= 0xE0 ? 3 : byte(0) >= 0xC2 ? 2 : 1;
  if (byte(0) >= 0xF5 || text.size() < length) return 1;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 1;
  }
  return length;
}

/// What stands in the way of reading a file as a text; empty: nothing.
std::string obstacle(const fs::path& file, std::size_t most_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (error) return "cannot be read: " + error.message();
  if (fs::is_directory(status)) return "is a folder, not a file";
  if (!fs::is_regular_file(status)) return "is a pipe or a device, not a file";
  const auto size = fs::file_size(file, error);
  if (!error && size > most_bytes)
    return fmt::format("has {:.3g} MB, more than the {:g} MB that such a file can have",
                       1e-6 * static_cast<double>(size), 1e-6 * static_cast<double>(most_bytes));
  return "";
}

}  // namespace

std::string read_bytes(const fs::path& file, std::size_t most_bytes) {
  const std::string reason = obstacle(file, most_bytes);
  if (!reason.empty()) throw FileError(fmt::format("{}: {}", file.string(), reason));
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string content;
  constexpr std::size_t block = 1U << 16U;
  for (std::size_t filled = 0; stream && filled <= most_bytes;
       filled = content.size()) {  // files of /proc have no size
    content.resize(filled + block);
    stream.read(content.data() + filled, block);
    content.resize(filled + static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.is_open() || stream.bad())
    throw FileError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  if (content.size() > most_bytes)
    throw FileError(fmt::format("{}: has more than the {:g} MB that such a file can have", file.string(),
                                1e-6 * static_cast<double>(most_bytes)));
  return content;
}

std::string read_text_file(const fs::path& file, std::size_t most_bytes) {
  std::string text = read_bytes(file, most_bytes);
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  std::size_t kept = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool carriage_return = text[at] == '\r';
    if (carriage_return && at + 1 < text.size() && text[at + 1] == '\n') continue;
    text[kept++] = carriage_return ? '\n' : text[at];
  }
  text.resize(kept);
  return text;
}

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text.substr(at));
    if (length == 1 && static_cast<unsigned char>(text[at]) >= 0x80) return false;
    at += length;
  }
  return true;
}

std::string shortened(std::string_view text) {
  constexpr std::size_t longest_shown = 60;
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text.substr(at));
    if (shown.size() + length > longest_shown) return shown + "…";
    const bool printable = length > 1 || (text[at] >= ' ' && text[at] < 127);
    shown += printable ? text.substr(at, length) : "?";
    at += length;
  }
  return shown;
}

}  // namespace slope::couple
