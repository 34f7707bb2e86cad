// Numbers as JSON: finite, never -0, null where there is no value.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace kinestat {

using Json = nlohmann::ordered_json;

inline Json number(double value) {
  return std::isfinite(value) ? Json(value == 0.0 ? 0.0 : value) : Json(nullptr);
}

inline Json number(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

}  // namespace kinestat
