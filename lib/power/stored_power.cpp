#include "power/stored_power.hpp"

#include <fmt/format.h>

namespace kinestat {

std::string stored_power_reason(const Load& load) {
  return load.name.starts_with(kInertiaPrefix)
             ? "the kinetic energy of the bodies also supplies or absorbs power"
         : load.name.starts_with(kSpringPrefix)
             ? fmt::format("'{}' also supplies or absorbs power", load.name)
             : "";
}

}  // namespace kinestat
