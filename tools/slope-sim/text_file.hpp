#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace slope::tools {

/// What the system said about the last failure, from errno.
[[nodiscard]] std::string system_message();

/// Writes a whole file; its name shows the old content or the new, never a part.
/// @throws couple::FileError if it cannot be written.
void write_at_once(const std::filesystem::path& file, std::string_view content);

/// Waits until what was written to a file is on the disk.
/// @throws couple::FileError if it cannot be brought there.
void synchronise_file(const std::filesystem::path& file);

/// Takes off what a file has beyond a length.
/// @throws couple::FileError if it is not that long, or cannot be written.
void cut_back(const std::filesystem::path& file, std::uintmax_t kept_bytes);

}  // namespace slope::tools
