// JSON values whose keys keep their order.
#pragma once

#include <nlohmann/json.hpp>

namespace kinestat {

using Json = nlohmann::ordered_json;

}  // namespace kinestat
