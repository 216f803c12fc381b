#include "checkpoint_request.hpp"

#include <csignal>

namespace slope::tools {

namespace {

volatile std::sig_atomic_t checkpoint_asked = 0;

extern "C" void ask_for_checkpoint(int) {
  checkpoint_asked = 1;
}

}  // namespace

void catch_checkpoint_requests() {
  struct sigaction action {};
  action.sa_handler = ask_for_checkpoint;
  action.sa_flags = SA_RESTART;
  sigaction(SIGUSR1, &action, nullptr);
}

bool checkpoint_requested() {
  const bool asked = checkpoint_asked != 0;
  checkpoint_asked = 0;
  return asked;
}

}  // namespace slope::tools
