#include "interruption.hpp"

#include <csignal>
#include <initializer_list>

namespace slope::tools {

namespace {

volatile std::sig_atomic_t stop_asked = 0;

extern "C" void ask_to_stop(int number) {
  if (stop_asked != 0 && number != SIGHUP) {  // a terminal that closes says so more than once
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
  stop_asked = 1;
}

/// A signal that is ignored, as by nohup, stays so.
void catch_unless_ignored(int number) {
  struct sigaction before {};
  sigaction(number, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = SA_RESTART;
  sigaction(number, &action, nullptr);
}

}  // namespace

void catch_interruptions() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) catch_unless_ignored(number);
}

bool interrupted() {
  return stop_asked != 0;
}

}  // namespace slope::tools
