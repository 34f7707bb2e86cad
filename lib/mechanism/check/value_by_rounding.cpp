#include "mechanism/check/value_by_rounding.hpp"

#include <fmt/format.h>

namespace kinestat {

void refuse_value_by_rounding(const Value& value, Diagnostics& found) {
  found.error("E0316",
              value.where,
              fmt::format("'{}' has a value by the rounding of 16 digits alone, and none with more",
                          value.expression.text()),
              "check what it is made of");
}

}  // namespace kinestat
