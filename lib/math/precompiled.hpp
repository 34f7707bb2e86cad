// What nearly every source includes, compiled once for all of them; the modules share the result.
// A source still names each header it needs: it must compile without this one, as it does with
// -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/types.hpp"
#include "math/numbers/rational.hpp"
