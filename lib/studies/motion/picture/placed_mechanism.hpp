// A mechanism as it stands in positions of its drive, and its drawing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"
#include "draw/linkage/linkage_drawing.hpp"
#include "draw/picture.hpp"

namespace kinestat {

struct PlacedMechanism {
  Analysis drawn;  ///< as drawn, without counts; its only case, if any, in the first position
  std::vector<LinkagePosition> positions;
  std::vector<std::string> words;  ///< of each: "motor = 30 deg"
};

/// Where it is to stand.
struct PlaceChoice {
  std::vector<std::string> at;  ///< of the first drive, from the drawn position, as typed
  std::string case_label;       ///< whose forces are shown; empty: that of the motion, if any
};

/// Follows the motion of the description, which must have one, to each of the positions; the other
/// drives go with the first. Empty iff an error was added: a value is none, there is no such case,
/// or the mechanism does not come so far.
std::optional<PlacedMechanism> place_mechanism(std::string file,
                                               const MechanismDescription& description,
                                               const Mechanism& mechanism,
                                               const PlaceChoice& choice,
                                               Diagnostics& found);

/// To scale, in the first position with names and forces, faintly in the others.
Picture draw_placed(const PlacedMechanism& placed);

}  // namespace kinestat
