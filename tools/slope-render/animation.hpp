#pragma once

#include <filesystem>

#include "encoder.hpp"
#include "run_folder.hpp"

namespace slope::tools {

/// Draws a field of every snapshot as <field>_0000.png, <field>_0001.png, ..., all with one colour scale and of one
/// size.
/// @param folder  for the pictures; created if need be. Frames of an earlier, longer sequence are removed.
/// A snapshot that cannot be read is noted and has no picture.
/// @throws couple::FileError if a picture cannot be written; std::invalid_argument for an unknown field.
FrameSequence write_frames(const RunFolder& run, const std::string& field, const std::filesystem::path& folder,
                           int width, Losses& losses);

}  // namespace slope::tools
