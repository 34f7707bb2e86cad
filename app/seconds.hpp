// The clock by which methods are timed.
#pragma once

#include <chrono>

namespace kinestat::app {

/// Seconds since some moment; never runs backwards.
inline double seconds() {
  const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
  return now.count();
}

}  // namespace kinestat::app
