#include "mechanism/bind/bind_counted.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mechanism/bind/bind.hpp"
#include "mechanism/bind/structure_binder.hpp"
#include "mechanism/check/geometry_check.hpp"
#include "mechanism/unanalysed.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

bool knows_directions_of(const CouplingDescription& coupling, Space space) {
  switch (coupling.type) {
    case revolute:
    case clutch:
    case brake:
    case gear:
      return coupling.axis || space == Space::planar;
    case prismatic:
    case helical:
    case cylindrical:
    case sphere_in_tube:
      return coupling.axis.has_value();
    case bevel_gear:
    case worm:
    case rack:
      return coupling.screw != nullptr || coupling.axis || space == Space::planar;
    case universal:
      return coupling.axes.size() == 2;
    case planar:
    case point_contact:
    case cam:
      return coupling.normal.has_value();
    case line_contact:
      return coupling.normal && coupling.line;
    case pin_in_slot:
      return coupling.slot.has_value();
    case cable:
      return coupling.is_segment() || (coupling.from && coupling.to);
    case spherical:
    case rigid:
    case screws:
      return true;
  }
  return false;
}

// What would make the counts wrong; a missing place does not.
bool is_countable(const MechanismDescription& description, Diagnostics& found) {
  bool is_good = true;
  for (const Unanalysed& one : find_unanalysed(description)) {
    if (one.decides && !one.can_be_counted) {
      is_good = false;
      found.error("E0315", one.where, fmt::format("{} is not analysed yet", one.what), one.hint);
    }
  }
  return is_good;
}

}  // namespace

bool can_only_be_counted(const MechanismDescription& description) {
  return std::ranges::any_of(description.couplings, is_counted_only);
}

bool knows_directions(const MechanismDescription& description) {
  return std::ranges::all_of(description.couplings, [&](const CouplingDescription& coupling) {
    return knows_directions_of(coupling, description.space);
  });
}

std::optional<CountedMechanism> bind_counted(const MechanismDescription& description,
                                             Diagnostics& found) {
  Diagnostics checked;  // its warnings say that the file cannot be analysed, which nobody asked for
  if (!check(description, checked)) {
    found = std::move(checked);
    return std::nullopt;
  }
  if (!is_countable(description, found)) {
    return std::nullopt;
  }
  std::optional<Mechanism> in_space = bind_in_space(description, found);
  if (!in_space) {
    return std::nullopt;
  }
  CountedMechanism counted;
  Evaluator evaluator = make_evaluator(description, found);
  const ScrewSpaces spaces{.motions = description.space, .actions = description.space};
  counted.mechanism.name = description.name;
  counted.mechanism.space = description.space;
  bind_bodies_and_couplings(description, spaces, evaluator, found, counted.mechanism);
  counted.mechanism.graph = in_space->graph;
  counted.in_space = *std::move(in_space);
  return counted;
}

}  // namespace kinestat
