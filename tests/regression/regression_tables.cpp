#include <cstdio>
#include <exception>

#include "products.hpp"

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: regression-tables RUN TOLERANCES FOLDER\n", stderr);
    return 2;
  }
  try {
    slope::testing::write_tables(argv[1], slope::testing::read_tolerances(argv[2]), argv[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 4;
  }
  return 0;
}
