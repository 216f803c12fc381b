// All three libraries: reads the case file given, or prints the schema of case files.

#include <cstdio>
#include <slope/couple/read_case.hpp>

int main(int argc, char** argv) {
  try {
    if (argc > 1) {
      const auto input = slope::couple::read_case(argv[1]);
      std::printf("%s: %zu soils\n", input.title.c_str(), input.soils.size());
      return input.soils.empty() ? 1 : 0;
    }
    std::puts(slope::couple::case_schema().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
