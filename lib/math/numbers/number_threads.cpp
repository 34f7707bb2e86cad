#include "math/numbers/number_threads.hpp"

#include <system_error>
#include <thread>
#include <vector>

#include "math/numbers/big_float.hpp"

namespace kinestat {

void work_on_threads(std::size_t count, const std::function<void()>& work) {
  std::vector<std::thread> helpers;
  helpers.reserve(count);
  try {
    while (helpers.size() + 1 < count) {
      helpers.emplace_back([&work] {
        const BigFloatMemory memory;
        work();
      });
    }
  } catch (const std::system_error&) {
    // Fewer threads give the same result, later.
  }
  work();
  for (std::thread& helper : helpers) {
    helper.join();
  }
}

}  // namespace kinestat
