#include "mechanism/check/axis_place_check.hpp"

#include <utility>

#include <fmt/format.h>

namespace kinestat {

namespace {

bool joins_two_planets(const CouplingDescription& coupling, const GearFrame* gears) {
  return gears != nullptr && gears->layout.train.planet_on(coupling.tail.text) >= 0 &&
         gears->layout.train.planet_on(coupling.head.text) >= 0;
}

}  // namespace

bool check_axis_place(const CouplingDescription& coupling,
                      const MechanismDescription& description,
                      const GearFrame* gears,
                      Diagnostics& found) {
  if (!coupling.at || !coupling.at->along_axis) {
    return true;
  }
  const bool is_planar = description.space == Space::planar;
  const std::string_view point = is_planar ? "[x, y]" : "[x, y, z]";
  const auto refuse = [&](std::string hint) {
    found.error("E0314",
                coupling.at->where,
                fmt::format("the point of coupling '{}' is a single number", coupling.name.text),
                std::move(hint));
    return false;
  };
  if (!description.gears) {
    return refuse(
        fmt::format("write {}; a single number is a position along the axis, for the "
                    "couplings of the members of 'gears'",
                    point));
  }
  if (is_planar) {
    return refuse(
        "remove 'at': in the plane the coupling stands on the axis of its gear; or write "
        "[x, y]");
  }
  return !joins_two_planets(coupling, gears) ||
         refuse("write at: [x, y, z], as it joins two planets, which turn on two axes");
}

}  // namespace kinestat
