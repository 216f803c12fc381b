#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace slope::couple {

/// The whole content of a file.
/// @param most_bytes  a longer file is not what it is taken for, and is refused before it is read.
/// @throws FileError with the reason if the file cannot be read, is longer, or is a folder, a pipe or a device.
[[nodiscard]] std::string read_bytes(const std::filesystem::path& file, std::size_t most_bytes);

/// The same of a text: without a byte order mark, every line ended by a line feed alone.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file, std::size_t most_bytes);

/// Whether a text is UTF-8, as YAML and the pictures' letters must be.
[[nodiscard]] bool is_utf8(std::string_view text);

/// A text of somebody else's file as it can stand in a message: of a long one the beginning and an ellipsis, and a
/// question mark for each byte that is no printable letter.
[[nodiscard]] std::string shortened(std::string_view text);

}  // namespace slope::couple
