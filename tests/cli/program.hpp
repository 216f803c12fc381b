#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace slope::tools::test {

/// What a program that has ended leaves behind.
struct Outcome {
  int exit_code = -1;  ///< -1: ended by a signal
  std::string output;
  std::string errors;
};

/// slope-sim, or another program, started with these arguments; its streams go to files in a folder. It may take no
/// more than 4 GB of memory and two minutes of a processor.
class Program {
 public:
  Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
          const std::filesystem::path& program = SLOPE_SIM);
  /// Ends the program if it still runs.
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void signal(int number) const;
  /// Whether it has come so far that it does something of its own on a signal.
  [[nodiscard]] bool catches(int number) const;
  [[nodiscard]] bool running();
  /// Waits for the end.
  Outcome wait();

 private:
  std::filesystem::path folder_;
  pid_t id_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

/// Runs slope-sim to its end.
[[nodiscard]] Outcome slope_sim(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

[[nodiscard]] std::string content_of(const std::filesystem::path& file);

}  // namespace slope::tools::test
