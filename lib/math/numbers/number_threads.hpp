// Threads that work with numbers.
#pragma once

#include <cstddef>
#include <functional>

namespace kinestat {

/// Runs `work` on this thread and on count - 1 others, or on fewer where the system gives no more,
/// and comes back when all have ended it. `work` shares what is to do among those that call it, and
/// throws nothing.
void work_on_threads(std::size_t count, const std::function<void()>& work);

}  // namespace kinestat
