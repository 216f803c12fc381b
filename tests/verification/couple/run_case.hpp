#pragma once

#include <functional>
#include <string>
#include <vector>

#include "slope/couple/simulation.hpp"

namespace slope::testing {

/// A case file beside this source, or one in the cases folder, ready to run.
[[nodiscard]] couple::Simulation start_case(const std::string& name, const std::vector<std::string>& overrides = {});
[[nodiscard]] couple::Simulation start_shipped_case(const std::string& name,
                                                    const std::vector<std::string>& overrides = {});

/// Runs to the end; calls `at_snapshot` at each time that the case lists.
void run(couple::Simulation& simulation, const std::function<void(const couple::ParticleTable&)>& at_snapshot);

/// The time as reference files write it in their column names: "60", "7200".
[[nodiscard]] std::string time_text(double time);

}  // namespace slope::testing
