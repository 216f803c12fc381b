#include <xxhash.h>

#include <cstdlib>
#include <string>

#include "fuzz_folder.hpp"
#include "slope/couple/checkpoint.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/simulation.hpp"

// The reader of checkpoints: whatever it is given, it throws its own error, and a checkpoint that it takes it writes so
// that it takes that again. A mutation hardly ever has the right checksum, so each is read as it is and with the length
// and the checksum that fit it; a state that comes of it either fits the case or is refused.
namespace {

using namespace slope;

constexpr std::size_t head_size = 48, version_at = 16, length_at = 24, checksum_at = 32;

void read(std::string_view bytes) {
  const couple::Checkpoint checkpoint = couple::checkpoint_of(bytes, "checkpoint.bin");
  const std::string written = couple::checkpoint_bytes(checkpoint);
  if (couple::checkpoint_bytes(couple::checkpoint_of(written, "checkpoint.bin")) != written) std::abort();
  static const couple::Case input = couple::read_case(SLOPE_FUZZ_CASE);
  try {
    const couple::Simulation simulation(input, checkpoint.state);
    (void)simulation.summary();
    (void)simulation.particles();
  } catch (const couple::InputError&) {
  }
}

std::string with_fitting_checksum(std::string bytes) {
  const std::uint64_t length = bytes.size() - head_size;
  for (std::size_t i = 0; i < sizeof length; ++i) bytes[length_at + i] = static_cast<char>(length >> (8 * i));
  const std::string hashed = bytes.substr(version_at, checksum_at - version_at) + bytes.substr(head_size);
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(hashed.data(), hashed.size()));
  return bytes.replace(checksum_at, sizeof canonical, reinterpret_cast<const char*>(canonical.digest),
                       sizeof canonical);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(fuzz::text_of(data, size));
  try {
    read(bytes);
  } catch (const couple::FileError&) {
  }
  if (size < head_size) return 0;
  try {
    read(with_fitting_checksum(bytes));
  } catch (const couple::FileError&) {
  }
  return 0;
}
