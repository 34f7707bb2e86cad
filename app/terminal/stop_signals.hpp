// Ctrl-C and the end that a batch system gives: noted, so that what runs can end in order.
#pragma once

#include <atomic>

namespace kinestat::app {

/// From its making on, SIGINT, SIGTERM and SIGHUP are noted instead of ending the process; a second
/// one ends it. One at a time.
class StopSignals {
 public:
  StopSignals();

  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  StopSignals(StopSignals&&) = delete;
  StopSignals& operator=(StopSignals&&) = delete;
  ~StopSignals();

  /// True once a signal has come.
  const std::atomic<bool>& flag() const;

  /// Ends the process by the signal that has come, so that its parent sees why it ended; returns if
  /// none has.
  void raise_again() const;
};

/// Ends the process as a write into a closed pipe does.
void raise_closed_pipe();

}  // namespace kinestat::app
