// All three libraries: reads a case file and says what is in it, or everything that is wrong with it.

#include <cstdio>
#include <exception>
#include <slope/couple/geometry.hpp>
#include <slope/couple/read_case.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: read_case FILE\n");
    return 2;
  }
  try {
    const auto input = slope::couple::read_case(argv[1]);
    const auto particles = slope::couple::fill_regions(input.domain, input.regions);
    std::printf("%s: %zu soils, %zu particles\n", input.title.c_str(), input.soils.size(), particles.x.size());
    return particles.x.empty() ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
