#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input.hpp"

namespace slope::couple {

/// A case file with the cases that it includes under it.
struct LoadedCase {
  Document document;               ///< every node with the file and line that it really stands in
  std::vector<std::string> files;  ///< the case file, its base, the base of that, and so on
};

/// Reads a case file and, if it has the key `include`, its base; see merged().
/// @param problems  takes what is wrong with a file that can still be used, such as a key given twice.
/// @throws InputError if a file holds no case or an include leads nowhere; FileError if a file cannot be read.
[[nodiscard]] LoadedCase load_case(const std::filesystem::path& file, std::vector<Problem>& problems);

/// Puts the soils that come from a library (key `from`) in their places: see merged().
/// @param files  takes the names of the libraries
/// @throws InputError if a library holds no such soil or is not there; FileError if it cannot be read.
void take_library_soils(Document& document, const std::filesystem::path& file, std::vector<std::string>& files,
                        std::vector<Problem>& problems);

/// The base with everything that `over` says in its place:
/// - maps are merged key by key, and so are the entries of two lists whose items all have a name, by these names;
/// - a value or another list takes the place of what the base has;
/// - so does a map of another kind: another `model` or `type`, or another condition (see water_conditions).
[[nodiscard]] Document merged(const Document& base, const Document& over);

}  // namespace slope::couple
