// What a key means in several kinds.
#pragma once

#include <string_view>

namespace kinestat {

inline constexpr std::string_view kPointOfContact =
    "The point of contact in the drawn position: [x, y] in the plane, [x, y, z] in space; or "
    "{TAIL: point, HEAD: point} as drawn on each body.";

inline constexpr std::string_view kPointForDrawings =
    "A point of the coupling in the drawn position, for drawings and reports; the mechanics of "
    "this type do not depend on it.";

inline constexpr std::string_view kAxisOfTurningAndSliding =
    "The axis, along which the head slides as it turns: x, y, z, -x, -y, -z or a vector [ax, ay, "
    "az] of any length but zero.";

}  // namespace kinestat
