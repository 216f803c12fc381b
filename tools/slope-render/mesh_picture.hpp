#pragma once

#include <filesystem>

#include "slope/couple/case.hpp"

namespace slope::tools {

/// The background grid, the outline of the soil and the verification points.
/// @throws couple::FileError if it cannot be written.
void write_mesh_picture(const std::filesystem::path& file, int width, const couple::Case& input);

}  // namespace slope::tools
