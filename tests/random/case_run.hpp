#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "random_case.hpp"

namespace slope::random_cases {

/// How the run of a case came to its end.
enum class Ending {
  done,     ///< by one of the case's own criteria
  budget,   ///< stopped after as many steps as it may take
  physics,  ///< broken physics, told as such (slope-sim: exit code 3, or 0 for soil that did not stand before the
            ///< start)
  refused,  ///< taken for a wrong case
  fault,    ///< an exception that nobody documents
  crash,    ///< a signal
  hang      ///< more processor time than it may take
};

[[nodiscard]] const char* text_of(Ending ending);

struct Outcome {
  Ending ending = Ending::crash;
  std::string verdict;       ///< of the summary
  std::string end;           ///< end reason of the summary, or the message of the error
  double water_error = 0.0;  ///< see Promises (-)
  std::size_t particles = 0, steps = 0;
  double time = 0.0, share = 0.0;   ///< simulated (s), and of stop.time (-)
  double displacement = 0.0;        ///< largest (m)
  double seconds = 0.0;             ///< of the processor
  std::vector<std::string> broken;  ///< promises

  [[nodiscard]] bool kept() const {
    return broken.empty() && (ending == Ending::done || ending == Ending::budget || ending == Ending::physics);
  }
};

struct Budget {
  std::size_t steps = 4000;           ///< of the run
  std::size_t initial_steps = 40000;  ///< of the search for the state before the start
  unsigned seconds = 60;              ///< of the processor
};

/// Writes a case into a folder: case.yaml and the tables that it names.
void write_case(const RandomCase& random, const std::filesystem::path& folder);

/// Runs a case file in a process of its own, so that whatever it does ends nothing else.
[[nodiscard]] Outcome run_case(const std::filesystem::path& file, const Budget& budget);

}  // namespace slope::random_cases
