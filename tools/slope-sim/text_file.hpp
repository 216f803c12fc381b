#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace slope::tools {

/// What the system said about the last failure, from errno.
[[nodiscard]] std::string system_message();

/// Writes a whole file; its name shows the old content or the new, never a part.
/// @throws couple::FileError if it cannot be written.
void write_at_once(const std::filesystem::path& file, std::string_view content);

}  // namespace slope::tools
