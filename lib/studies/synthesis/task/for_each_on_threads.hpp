// Independent jobs on several threads.
#pragma once

#include <cstdint>

#include "studies/synthesis/selection/selection.hpp"

namespace kinestat {

/// On up to that many threads, 0 for as many as the machine has cores. Threads take the numbers in
/// their order. An exception of a job is thrown again once all threads have ended.
ForEach for_each_on_threads(std::uint64_t jobs);

}  // namespace kinestat
