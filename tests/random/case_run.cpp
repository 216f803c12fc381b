#include "case_run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "promises.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/results.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::random_cases {

namespace {

constexpr std::array endings{"done", "step budget", "physics broke", "refused", "fault", "crash", "hang"};
constexpr std::size_t initial_steps_per_question = 20;  // of slope::couple's observer

/// The run of a case in this process.
class Run {
 public:
  Run(couple::Case input, const Budget& budget) : simulation_(std::move(input)), budget_(budget) {}

  void carry_out(Outcome& outcome) {
    std::size_t asked = 0;
    const bool found = simulation_.initialise(
        [&](const couple::InitialProgress&) { return ++asked * initial_steps_per_question < budget_.initial_steps; });
    if (!found) {
      outcome.ending = Ending::budget;
      outcome.end = "before the start";
      return;
    }
    Promises promises(simulation_.input(), simulation_.particles(), simulation_.summary());
    try {
      promises.look_at_row(simulation_.history_row(), simulation_.budget_row());
      outcome.ending = advance(promises);
    } catch (const couple::SimulationError& error) {
      outcome.ending = Ending::physics;
      outcome.end = error.what();
    }
    if (outcome.ending == Ending::done) promises.look_at_end(simulation_.summary());
    conclude(promises, outcome);
  }

 private:
  Ending advance(Promises& promises) {
    for (;;) {
      const couple::Event event = simulation_.advance();
      if (event.history) promises.look_at_row(simulation_.history_row(), simulation_.budget_row());
      promises.look(simulation_.particles(), simulation_.summary());
      if (event.finished) return Ending::done;
      if (simulation_.progress().steps >= budget_.steps) return Ending::budget;
    }
  }

  void conclude(const Promises& promises, Outcome& outcome) const {
    const couple::Summary summary = simulation_.summary();
    outcome.verdict = couple::text_of(summary.verdict);
    if (outcome.end.empty()) outcome.end = couple::text_of(summary.end_reason);
    outcome.water_error = promises.water_error();
    outcome.particles = summary.particles;
    outcome.steps = summary.steps;
    outcome.time = summary.time;
    outcome.share = summary.time / simulation_.input().stop.time;
    outcome.displacement = summary.largest_displacement;
    outcome.broken = promises.broken();
  }

  couple::Simulation simulation_;
  Budget budget_;
};

Outcome run_here(const std::filesystem::path& file, const Budget& budget) {
  Outcome outcome;
  try {
    Run(couple::read_case(file), budget).carry_out(outcome);
  } catch (const couple::InputError& error) {
    outcome.ending = Ending::refused;
    outcome.end = error.what();
  } catch (const couple::FileError& error) {
    outcome.ending = Ending::refused;
    outcome.end = error.what();
  } catch (const couple::SimulationError& error) {  // before the start
    outcome.ending = Ending::physics;
    outcome.end = error.what();
  } catch (const std::exception& error) {
    outcome.ending = Ending::fault;
    outcome.end = error.what();
  }
  outcome.seconds = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return outcome;
}

/// What goes through the pipe: a value a line, then the broken promises.
std::string packed(const Outcome& outcome) {
  std::string end = outcome.end;
  for (char& letter : end) {
    if (letter == '\n') letter = ' ';
  }
  std::string text = fmt::format("{}\n{}\n{}\n{} {} {} {} {} {} {}\n", static_cast<int>(outcome.ending),
                                 outcome.verdict, end, outcome.water_error, outcome.particles, outcome.steps,
                                 outcome.time, outcome.share, outcome.displacement, outcome.seconds);
  for (const std::string& promise : outcome.broken) text += promise + "\n";
  return text;
}

Outcome unpacked(const std::string& text) {
  Outcome outcome;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  outcome.ending = static_cast<Ending>(std::stoi(line));
  std::getline(lines, outcome.verdict);
  std::getline(lines, outcome.end);
  lines >> outcome.water_error >> outcome.particles >> outcome.steps >> outcome.time >> outcome.share >>
      outcome.displacement >> outcome.seconds;
  std::getline(lines, line);
  while (std::getline(lines, line)) outcome.broken.push_back(line);
  return outcome;
}

Outcome of_signal(int number) {
  Outcome outcome;
  outcome.ending = number == SIGXCPU || number == SIGKILL ? Ending::hang : Ending::crash;
  outcome.end = fmt::format("signal {}", number);
  return outcome;
}

}  // namespace

const char* text_of(Ending ending) {
  return endings[static_cast<std::size_t>(ending)];
}

void write_case(const RandomCase& random, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "case.yaml") << random.yaml;
  for (const auto& [name, table] : random.tables) std::ofstream(folder / name) << table;
}

Outcome run_case(const std::filesystem::path& file, const Budget& budget) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe can be made");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process can be made");
  if (child == 0) {
    close(ends[0]);
    const rlimit limit{budget.seconds, budget.seconds + 5};
    setrlimit(RLIMIT_CPU, &limit);
    const std::string text = packed(run_here(file, budget));
    const bool told = write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
    _exit(told ? 0 : 1);
  }
  close(ends[1]);
  std::string text;
  std::array<char, 4096> piece{};
  for (ssize_t size = 0; (size = read(ends[0], piece.data(), piece.size())) > 0;)
    text.append(piece.data(), static_cast<std::size_t>(size));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) return of_signal(WTERMSIG(status));
  if (text.empty()) throw std::runtime_error(file.string() + ": its process told nothing");
  return unpacked(text);
}

}  // namespace slope::random_cases
