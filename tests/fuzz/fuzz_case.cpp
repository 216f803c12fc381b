#include <cstdlib>

#include "fuzz_folder.hpp"
#include "slope/couple/read_case.hpp"

// The case reader: whatever it is given, it throws its own errors, and a case that it takes it writes so that it takes
// that again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slope;
  const auto file = fuzz::file_with("case.yaml", fuzz::text_of(data, size));
  std::string resolved;
  try {
    std::vector<couple::Problem> warnings;
    resolved = couple::resolved_yaml(couple::read_case(file, {}, &warnings));
  } catch (const couple::InputError&) {
    return 0;
  } catch (const couple::FileError&) {
    return 0;
  }
  try {
    (void)couple::read_case(fuzz::file_with("resolved.yaml", resolved));
  } catch (const couple::InputError&) {
    std::abort();  // libFuzzer keeps the input
  }
  return 0;
}
