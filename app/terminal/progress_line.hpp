// How far a long run is, on standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace kinestat::app {

enum class ProgressChoice {
  automatic,  ///< where standard error is a terminal
  always,
  never
};

/// What there is to tell: so many of the things that a run goes through, and what came of them.
struct Progress {
  std::uint64_t done = 0;
  std::uint64_t known = 0;  ///< of those, from before the run began
  std::uint64_t total = 0;
  std::string things;        ///< "states"
  std::string result;        ///< "12 rows"
  double share = 1.0;        ///< of the work that is done
  double known_share = 0.0;  ///< from before
};

/// One line that is written over again on a terminal, elsewhere a line now and then. The clock is
/// one that nobody sets back.
class ProgressLine {
 public:
  explicit ProgressLine(ProgressChoice choice);

  bool is_wanted() const { return is_wanted_; }

  void show(const Progress& progress);

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
