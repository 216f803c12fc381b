#pragma once

#include <filesystem>

namespace slope::tools {

/// Makes sure that a particle file is laid out as ParticleFileSeries writes it and that all of it is there: one piece,
/// arrays of known types in compressed blocks inside the file, each as long as its points ask for. VTK's reader takes
/// all of this on trust.
/// @throws couple::FileError if that is not so, or the file cannot be read.
void check_particle_layout(const std::filesystem::path& file);

}  // namespace slope::tools
