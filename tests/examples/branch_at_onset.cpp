// What if the rain had ended when the slope began to slide? Runs a case to the onset of its failure, goes on from there
// twice, with the rain and without it, and compares.
//
//   branch_at_onset cases/quick.yaml

#include <cstdio>
#include <exception>

#include "slope/couple/read_case.hpp"
#include "slope/couple/simulation.hpp"

namespace {

using namespace slope::couple;

Summary finish(Simulation& simulation) {
  while (!simulation.advance().finished) {
  }
  return simulation.summary();
}

void tell(const char* what, const Summary& summary) {
  std::printf("%-14s largest displacement %.3f m after %.1f s, water in %.3f m3/m\n", what,
              summary.largest_displacement, summary.time, summary.water.infiltration);
}

void compare(const char* file) {
  const Case wet = read_case(file);
  Simulation rain(wet);
  rain.initialise();
  for (Event event; event.label != "onset"; event = rain.advance()) {
    if (event.finished) {
      std::puts("the slope stands");
      return;
    }
  }
  tell("at the onset:", rain.summary());

  Case dry = wet;
  dry.water_boundaries.clear();
  Simulation no_rain(dry, rain.state());  // a copy, `Simulation same = rain`, would go on with the rain

  tell("rain goes on:", finish(rain));
  tell("rain ends:", finish(no_rain));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    compare(argc > 1 ? argv[1] : "cases/quick.yaml");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
