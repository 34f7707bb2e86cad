// Places of a report: JSON Pointers (RFC 6901).
#pragma once

#include <string>
#include <string_view>

#include "report/json_values.hpp"

namespace kinestat {

/// Takes the first token off a pointer that begins with '/'.
std::string take_token(std::string_view& pointer);

/// Where a pointer leads, or how far it leads and what there is instead.
struct PointerTarget {
  const Json* value = nullptr;
  std::string problem;
  std::string hint;
};

PointerTarget follow_pointer(const Json& report, std::string_view pointer);

/// What stands where a number was looked for: "a text".
std::string_view kind_of_json(const Json& value);

}  // namespace kinestat
