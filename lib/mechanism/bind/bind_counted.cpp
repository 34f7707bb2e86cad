#include "mechanism/bind/bind_counted.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "couplings/kinds.hpp"
#include "mechanism/bind/bind.hpp"
#include "mechanism/bind/structure_binder.hpp"
#include "mechanism/check/geometry_check.hpp"
#include "mechanism/unanalysed.hpp"

namespace kinestat {

namespace {

// Those that its kind takes; the file may leave out an axis across the plane.
bool knows_directions_of(const CouplingDescription& coupling, Space space) {
  using enum CouplingKey;
  const CouplingKind& kind = kind_of(coupling.type);
  const bool is_turning_known =
      coupling.axis || coupling.screw != nullptr || space == Space::planar;
  return (!takes(kind, turning_axis) || is_turning_known) &&
         (!takes(kind, sliding_axis) || coupling.axis) &&
         (!takes(kind, axes) || coupling.axes.size() == 2) &&
         (!takes(kind, normal) || coupling.normal) && (!takes(kind, line) || coupling.line) &&
         (!takes(kind, slot) || coupling.slot) &&
         (!takes(kind, from) || coupling.is_segment() || (coupling.from && coupling.to));
}

// What would make the counts wrong; a missing place does not.
bool is_countable(const MechanismDescription& description, Diagnostics& found) {
  bool is_good = true;
  for (const Unanalysed& one : find_unanalysed(description)) {
    if (one.decides && !one.can_be_counted) {
      is_good = false;
      found.error("E0315", one.where, one.message(), one.hint);
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
