#include <cstdlib>

#include "fuzz_folder.hpp"
#include "slope/couple/results.hpp"

// The reader of summaries: whatever it is given, it throws its own error, and a summary that it takes it writes so that
// it takes that again, as the same text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slope;
  std::string written;
  try {
    std::vector<couple::Problem> not_understood;
    written = couple::summary_json(
        couple::summary_of(std::string(fuzz::text_of(data, size)), "summary.json", &not_understood));
  } catch (const couple::FileError&) {
    return 0;
  }
  try {
    std::vector<couple::Problem> not_understood;
    const couple::RunSummary again = couple::summary_of(written, "summary.json", &not_understood);
    if (couple::summary_json(again) != written) std::abort();  // libFuzzer keeps the input
  } catch (const couple::FileError&) {
    std::abort();
  }
  return 0;
}
