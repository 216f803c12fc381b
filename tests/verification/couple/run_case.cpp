#include "run_case.hpp"

#include <cmath>
#include <filesystem>

#include "slope/couple/read_case.hpp"

namespace slope::testing {

namespace {

couple::Simulation start(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  couple::Simulation simulation(couple::read_case(file, overrides));
  simulation.initialise();
  return simulation;
}

}  // namespace

couple::Simulation start_case(const std::string& name, const std::vector<std::string>& overrides) {
  return start(std::filesystem::path(SLOPE_COUPLE_CASES_DIR) / name, overrides);
}

couple::Simulation start_shipped_case(const std::string& name, const std::vector<std::string>& overrides) {
  return start(std::filesystem::path(SLOPE_CASES_DIR) / name, overrides);
}

void run(couple::Simulation& simulation, const std::function<void(const couple::ParticleTable&)>& at_snapshot) {
  for (couple::Event event; !event.finished;) {
    event = simulation.advance();
    if (event.snapshot) at_snapshot(simulation.particles());
  }
}

std::string time_text(double time) {
  return std::to_string(std::lround(time));
}

}  // namespace slope::testing
