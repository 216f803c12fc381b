#include "program.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace slope::tools::test {

namespace {

void send_to(int stream, const std::filesystem::path& file) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, stream) < 0) _exit(127);
  close(opened);
}

void keep_within(int resource, rlim_t most) {
  const rlimit limit{most, most};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

/// The address sanitizer maps terabytes that it does not use.
#ifdef __SANITIZE_ADDRESS__
constexpr bool under_sanitizers = true;
#else
constexpr bool under_sanitizers = false;
#endif

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                 const std::filesystem::path& program)
    : folder_(folder) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  id_ = fork();
  if (id_ < 0) throw std::runtime_error(words.front() + " cannot be started");
  if (id_ == 0) {
    keep_within(RLIMIT_CPU, 120);
    if (!under_sanitizers) keep_within(RLIMIT_AS, rlim_t{4} << 30);
    send_to(STDOUT_FILENO, folder_ / "output");
    send_to(STDERR_FILENO, folder_ / "errors");
    execv(pointers.front(), pointers.data());
    _exit(127);
  }
}

Program::~Program() {
  if (!running()) return;
  kill(id_, SIGKILL);
  waitpid(id_, &status_, 0);
}

void Program::signal(int number) const {
  kill(id_, number);
}

bool Program::catches(int number) const {
  std::ifstream status("/proc/" + std::to_string(id_) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("SigCgt:")) return (std::stoull(line.substr(7), nullptr, 16) >> (number - 1) & 1U) != 0;
  }
  return false;
}

bool Program::running() {
  if (!ended_) ended_ = waitpid(id_, &status_, WNOHANG) != 0;
  return !ended_;
}

Outcome Program::wait() {
  if (!ended_) waitpid(id_, &status_, 0);
  ended_ = true;
  return {WIFEXITED(status_) ? WEXITSTATUS(status_) : -1, content_of(folder_ / "output"),
          content_of(folder_ / "errors")};
}

Outcome slope_sim(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
  return Program(arguments, folder).wait();
}

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

}  // namespace slope::tools::test
