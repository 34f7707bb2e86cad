// How far a sweep is, on standard error.
#pragma once

#include <chrono>
#include <cstddef>

#include "run/sweep.hpp"

namespace kinestat::app {

enum class ProgressChoice {
  automatic,  ///< where standard error is a terminal
  always,
  never
};

/// One line that is written over again on a terminal, elsewhere a line now and then. The clock is
/// one that nobody sets back.
class ProgressLine {
 public:
  explicit ProgressLine(ProgressChoice choice);

  bool is_wanted() const { return is_wanted_; }

  void show(const SweepProgress& progress);

  /// Makes room for what is written next.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  bool is_wanted_ = false;
  bool is_terminal_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_;
  bool has_shown_ = false;
  std::size_t width_ = 0;
};

}  // namespace kinestat::app
