#include "jobs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "folder_lock.hpp"
#include "interruption.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::tools {

namespace {

constexpr int cannot_start = 127;
constexpr auto pause = std::chrono::milliseconds(20);
constexpr auto between_looks = std::chrono::seconds(1);

/// A command that fails, or is killed, does not keep the others from being run.
std::vector<std::string> words_of(const JobOptions& options) {
  const std::string at_once = std::to_string(options.at_once);
  if (options.engine == Engine::parallel) {
    return {"parallel", "--will-cite", "--halt", "never", "--termseq", "TERM,10000,KILL,25", "--jobs", at_once};
  }
  return {"xargs", "-d", "\\n", "-P", at_once, "-I", "{}", "sh", "-c", "{} || :"};
}

/// In a process group of its own, so that an interruption reaches it once.
pid_t start(std::vector<std::string> words, const std::filesystem::path& input) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t id = fork();
  if (id != 0) return id;
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int opened = open(input.c_str(), O_RDONLY);
  if (getppid() != parent || opened < 0 || dup2(opened, STDIN_FILENO) < 0) _exit(cannot_start);
  close(opened);
  execvp(pointers.front(), pointers.data());
  _exit(cannot_start);
}

bool in_use(const std::filesystem::path& folder) {
  try {
    const FolderLock lock(folder);
    return false;
  } catch (const couple::FileError&) {
    return true;
  }
}

}  // namespace

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char letter : word) {
    if (letter == '\'') {
      text += R"('\'')";
    } else {
      text += letter;
    }
  }
  return text + "'";
}

void run_jobs(const std::filesystem::path& file, const JobOptions& options, const std::function<void()>& look) {
  const std::vector<std::string> words = words_of(options);
  const pid_t engine = start(words, file);
  if (engine < 0) throw couple::FileError(words.front() + ": cannot be started");
  bool told = false;
  int status = 0;
  auto last = std::chrono::steady_clock::now();
  while (waitpid(engine, &status, WNOHANG) == 0) {
    if (interrupted() && !told) {
      kill(-engine, SIGTERM);  // an interruption may be ignored, as by what a shell starts in the background
      told = true;
    }
    if (std::chrono::steady_clock::now() - last > between_looks) {
      look();
      last = std::chrono::steady_clock::now();
    }
    std::this_thread::sleep_for(pause);
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == cannot_start) {
    throw couple::FileError(fmt::format(
        "{}: cannot be started; install it, choose another --engine, or run what --list prints", words.front()));
  }
}

void wait_for_others(const std::vector<std::filesystem::path>& folders) {
  for (const std::filesystem::path& folder : folders) {
    while (in_use(folder)) std::this_thread::sleep_for(pause);
  }
}

}  // namespace slope::tools
