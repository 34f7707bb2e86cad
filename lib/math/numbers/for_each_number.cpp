#include "math/numbers/for_each_number.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "math/numbers/number_threads.hpp"

namespace kinestat {

namespace {

class Crew {
 public:
  Crew(std::size_t count, const std::function<void(std::size_t)>& job) : count_(count), job_(job) {}

  // What every thread does.
  void work() {
    try {
      for (std::size_t i = next_++; i < count_; i = next_++) {
        job_(i);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = failure_ ? failure_ : std::current_exception();
      next_ = count_;
    }
  }

  void rethrow() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& job_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

void one_after_another(std::size_t count, const std::function<void(std::size_t)>& job) {
  for (std::size_t i = 0; i < count; ++i) {
    job(i);
  }
}

ForEach for_each_on_threads(std::uint64_t jobs) {
  const std::uint64_t cores = std::max(1U, std::thread::hardware_concurrency());
  const auto most = static_cast<std::size_t>(jobs == 0 ? cores : std::min(jobs, cores));
  return [most](std::size_t count, const std::function<void(std::size_t)>& job) {
    Crew crew(count, job);
    work_on_threads(std::min(most, count), [&crew] { crew.work(); });
    crew.rethrow();
  };
}

}  // namespace kinestat
