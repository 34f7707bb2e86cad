// Jobs timed in turn, so that whatever slows the machine slows all of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ratio_table.hpp"

namespace kinestat::bench {

struct Job {
  std::string name;
  std::function<void()> run;
  std::optional<double> target;
  double parts = 1.0;  ///< one run does so many of what the ratio is of
};

struct Interleaved {
  std::vector<Ratio> ratios;  ///< of every job to the unit
  double unit_seconds = 0.0;  ///< median of the unit
};

/// As studies/benchmark/interleaved_times has it, by the steady clock of the process.
Interleaved measure(const std::function<void()>& unit, const std::vector<Job>& jobs, int rounds);

/// Makes the compiler believe that `value` is looked at.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

}  // namespace kinestat::bench
