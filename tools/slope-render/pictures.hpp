#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run_folder.hpp"

namespace slope::tools {

struct PictureOptions {
  std::filesystem::path folder;     ///< that the pictures go to; created if need be
  int width = 1600;                 ///< (pixels)
  std::vector<double> times;        ///< of the contour pictures (s); empty: the case's, or start, onset and end
  std::vector<std::string> fields;  ///< of the contour pictures; empty: suction and deviatoric_strain
};

/// What write_pictures() did.
struct Pictures {
  std::vector<std::filesystem::path> written;
  std::vector<std::string> notes;  ///< of times that were asked for and have no snapshot: which one was drawn
  Losses losses;                   ///< what could not be drawn
};

/// Draws contour pictures, histories at the verification points and, if the case asks for them, suction profiles.
/// What cannot be drawn, because a file is damaged or a picture cannot be written, is noted and left out.
/// @throws couple::FileError if the folder cannot be made; std::invalid_argument for an unknown field.
Pictures write_pictures(const RunFolder& run, const PictureOptions& options);

}  // namespace slope::tools
