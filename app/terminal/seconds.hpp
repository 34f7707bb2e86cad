// The clock by which methods are timed.
#pragma once

#include <chrono>
#include <ctime>

namespace kinestat::app {

/// Seconds since some moment; never runs backwards.
inline double seconds() {
  const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
  return now.count();
}

/// Those that the processor has spent on this process: others at work beside it do not count.
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace kinestat::app
