// Independent jobs, one for each number below a count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace kinestat {

/// Does the job of every number below `count`, in any order or at the same time.
using ForEach = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

void one_after_another(std::size_t count, const std::function<void(std::size_t)>& job);

/// On up to that many threads, 0 for as many as the machine has cores. Threads take the numbers in
/// their order. An exception of a job is thrown again once all threads have ended.
ForEach for_each_on_threads(std::uint64_t jobs);

}  // namespace kinestat
