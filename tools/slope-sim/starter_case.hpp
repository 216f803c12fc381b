#pragma once

#include <filesystem>
#include <string_view>

namespace slope::tools {

/// A small slope under rain, complete and commented, from which a case of one's own can grow.
[[nodiscard]] std::string_view starter_case();

/// Writes the starter case.
/// @throws couple::FileError if the file exists already or cannot be written.
void write_starter_case(const std::filesystem::path& file);

}  // namespace slope::tools
