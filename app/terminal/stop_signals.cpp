#include "terminal/stop_signals.hpp"

#include <array>
#include <csignal>

namespace kinestat::app {

namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

// A handler reaches nothing but what is global.
std::atomic<bool> has_come{false};
std::atomic<int> which{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void note_signal(int signal) {
  which.store(signal);
  has_come.store(true);
}

}  // namespace

StopSignals::StopSignals() {
  for (const int signal : kSignals) {
    struct sigaction present = {};
    ::sigaction(signal, nullptr, &present);
    if (present.sa_handler == SIG_IGN) {
      continue;  // as nohup wants it
    }
    struct sigaction action = {};
    action.sa_handler = note_signal;
    action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
    ::sigaction(signal, &action, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (const int signal : kSignals) {
    struct sigaction present = {};
    ::sigaction(signal, nullptr, &present);
    if (present.sa_handler == note_signal) {
      std::signal(signal, SIG_DFL);
    }
  }
}

const std::atomic<bool>& StopSignals::flag() const {
  return has_come;
}

void StopSignals::raise_again() const {
  if (has_come.load()) {
    std::signal(which.load(), SIG_DFL);
    std::raise(which.load());
  }
}

void raise_closed_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
}

}  // namespace kinestat::app
