#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

#include "losses.hpp"

namespace slope::tools {

/// The particles of a file that can be drawn: with a place, a positive volume that is not far above the others', and
/// values that are numbers. The others, as a run that broke may leave them, are noted and left out.
/// @throws couple::FileError if the file cannot be read, lacks an array that pictures need, or holds no such particle.
[[nodiscard]] vtkSmartPointer<vtkPolyData> read_drawable_particles(const std::filesystem::path& file, Losses& losses);

}  // namespace slope::tools
