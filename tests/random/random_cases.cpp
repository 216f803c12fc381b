// Runs random valid cases and judges what comes of each: see the README, "Random cases".

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

#include "case_run.hpp"
#include "random_case.hpp"

namespace slope::random_cases {

namespace {

struct Options {
  std::uint64_t seed = 1, first = 0, count = 12;
  std::filesystem::path folder = "random-cases";
  Budget budget;
  bool only_write = false;
};

constexpr double most_broken_physics = 0.1;  // of the cases

std::string quoted(std::string text) {
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '"');
  return '"' + text + '"';
}

std::string promises_text(const Outcome& outcome) {
  std::string text;
  for (const std::string& promise : outcome.broken) text += (text.empty() ? "" : "; ") + promise;
  return text;
}

std::string row(std::uint64_t number, const RandomCase& random, const Outcome& outcome) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{:.2g},{},{},{:.6g},{:.3g},{:.2f},{}\n", number, quoted(random.ground),
                     quoted(random.soils), quoted(random.water), quoted(random.conditions), quoted(random.scheme),
                     text_of(outcome.ending), quoted(outcome.verdict), quoted(outcome.end), outcome.water_error,
                     outcome.particles, outcome.steps, outcome.time, outcome.share, outcome.seconds,
                     quoted(promises_text(outcome)));
}

/// @return whether every case kept what is promised, and not too many broke the physics
bool run(const Options& options) {
  std::filesystem::create_directories(options.folder);
  std::ofstream table(options.folder / "outcomes.csv");
  table << "case,ground,soils,water,conditions,scheme,outcome,verdict,end,water_error,particles,steps,time_s,share,"
           "cpu_s,broken_promises\n";
  std::map<std::string, std::size_t> counts;
  std::size_t not_kept = 0, physics = 0;
  for (std::uint64_t number = options.first; number < options.first + options.count; ++number) {
    const RandomCase random = random_case(options.seed, number);
    const std::filesystem::path folder = options.folder / fmt::format("{}-{}", options.seed, number);
    write_case(random, folder);
    if (options.only_write) continue;
    const Outcome outcome = run_case(folder / "case.yaml", options.budget);
    table << row(number, random, outcome) << std::flush;
    ++counts[fmt::format("{}{}{}", text_of(outcome.ending), outcome.verdict.empty() ? "" : ", ", outcome.verdict)];
    physics += outcome.ending == Ending::physics ? 1 : 0;
    if (outcome.kept()) continue;
    ++not_kept;
    std::cout << fmt::format("{}: {}: {}; {}\n", (folder / "case.yaml").string(), text_of(outcome.ending), outcome.end,
                             promises_text(outcome));
  }
  for (const auto& [outcome, count] : counts) std::cout << fmt::format("{:4} {}\n", count, outcome);
  const bool few = static_cast<double>(physics) <= most_broken_physics * static_cast<double>(options.count);
  if (!few) std::cout << "in too many of them the physics broke\n";
  return not_kept == 0 && few;
}

}  // namespace

}  // namespace slope::random_cases

int main(int argc, char** argv) {
  using namespace slope::random_cases;
  Options options;
  CLI::App app{"Runs random valid cases, each in a process of its own, and tells which do not keep what is promised."};
  app.add_option("--seed", options.seed, "of the cases")->capture_default_str();
  app.add_option("--first", options.first, "number of the first case")->capture_default_str();
  app.add_option("--count", options.count, "how many")->capture_default_str();
  app.add_option("--steps", options.budget.steps, "that a run may take")->capture_default_str();
  app.add_option("-o,--output", options.folder, "folder for the cases and outcomes.csv")->capture_default_str();
  app.add_flag("--only-write", options.only_write, "writes the cases and runs none");
  CLI11_PARSE(app, argc, argv);
  return run(options) ? 0 : 1;
}
