#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace slope::tools {

/// A sequence of pictures of one size: <stem>_0000.png, <stem>_0001.png, ...
struct FrameSequence {
  std::filesystem::path folder;
  std::string stem;
  int count = 0;

  [[nodiscard]] std::filesystem::path frame(int index) const;
};

/// Makes a film of the pictures with the first encoder that works: ffmpeg or ImageMagick (`magick`, `convert`) on the
/// PATH, which make a GIF, or VTK's own Theora writer (.ogv).
/// @param film  the file without its extension.
/// @return the film; nothing if there is no encoder.
[[nodiscard]] std::optional<std::filesystem::path> encode_film(const FrameSequence& frames,
                                                               const std::filesystem::path& film,
                                                               int frames_per_second);

/// The encoders that encode_film() looks for, for a message.
[[nodiscard]] std::string known_encoders();

}  // namespace slope::tools
