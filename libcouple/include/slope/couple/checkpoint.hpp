#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "slope/couple/case.hpp"
#include "slope/couple/state.hpp"

namespace slope::couple {

/// What a run needs to go on where it was.
struct Checkpoint {
  std::string case_path;                ///< file that the case was read from
  std::string case_text;                ///< resolved_yaml() of the case
  std::map<std::string, double> notes;  ///< of the program that runs it: what it counts, in its own words
  SimulationState state;
};

/// The content of a checkpoint file, little-endian: the 16 letters "slope checkpoint"; version (8 bytes); length of the
/// body (8); XXH3 checksum of version, length and body (16, as xxhsum prints it); body. The body has the fields of a
/// Checkpoint in the order of their lists, each with its name before it; a text or an array begins with its length,
/// what is one of several kinds with the number of its kind. So other programs can read it too, and nothing of it has
/// to be guessed. These 48 bytes stay what they are in all versions.
[[nodiscard]] std::string checkpoint_bytes(const Checkpoint& checkpoint);
/// @param name  of the file, for messages. @throws FileError that says whether it is no checkpoint, cut off, damaged,
/// or of another version
[[nodiscard]] Checkpoint checkpoint_of(std::string_view bytes, const std::string& name);

/// Writes a checkpoint in place of an older one: to a file beside it, which is renamed once it is on the disk. Whatever
/// happens, one of the two is there, and whole.
/// @throws FileError if it cannot be written; the older one is then left.
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);
/// @throws FileError if it cannot be read, see checkpoint_of().
[[nodiscard]] Checkpoint read_checkpoint(const std::filesystem::path& file);

/// @throws InputError that shows the first line that differs, if a case is not that of a checkpoint
void require_case_of(const Checkpoint& checkpoint, const Case& input);

}  // namespace slope::couple
