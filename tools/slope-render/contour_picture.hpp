#pragma once

#include <filesystem>

#include "contour_panel.hpp"

namespace slope::tools {

/// A picture of one panel with title, legend and colour bar, `width` pixels wide (narrower for a tall domain).
/// @throws couple::FileError if it cannot be written.
void write_contour_picture(const std::filesystem::path& file, int width, const ContourPanel& panel);

}  // namespace slope::tools
