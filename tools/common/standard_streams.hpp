#pragma once

#include <string>

namespace slope::tools {

/// Opens /dev/null in place of each standard stream that is closed. The first files that are opened would take their
/// numbers otherwise, and get what is said to the user.
void open_standard_streams();

/// A reader that goes away, or a file that may not grow, ends no program from now on: writing to it fails instead.
void survive_failed_writes();

/// Puts a text on the standard output; flush_output() tells whether it arrived.
void say(const std::string& text);

/// Hands over all that was said on the standard output.
/// @throws couple::FileError with the reason if it could not be written.
void flush_output();

}  // namespace slope::tools
