// Compiled once for each solver library, with nothing but that library linked.
#if defined(SLOPE_WALL_AROUND_SOLID)
#if !__has_include("slope/solid/soil.hpp")
#error "slope::solid does not bring its own headers"
#endif
#if __has_include("slope/seepage/soil.hpp") || __has_include("slope/couple/case.hpp")
#error "headers of another room are within reach of slope::solid"
#endif
#include "slope/solid/soil.hpp"
#elif defined(SLOPE_WALL_AROUND_SEEPAGE)
#if !__has_include("slope/seepage/soil.hpp")
#error "slope::seepage does not bring its own headers"
#endif
#if __has_include("slope/solid/soil.hpp") || __has_include("slope/couple/case.hpp")
#error "headers of another room are within reach of slope::seepage"
#endif
#include "slope/seepage/soil.hpp"
#else
#error "define the room"
#endif

int main() {
  return 0;
}
