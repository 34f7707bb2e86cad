// A case as the user wrote it: known motions and actions.
#pragma once

#include <vector>

#include "description/load_description.hpp"
#include "description/value.hpp"

namespace kinestat {

/// `target` is an actuator, or coupling.freedom, or coupling.action.
struct Assignment {
  Name target;
  Value value;
};

struct CaseDescription {
  Name label;
  bool asks_motions = false;  ///< has the key `motion`, be it empty
  bool asks_actions = false;  ///< has the key `action`, be it empty
  bool has_inertia = false;   ///< has the key `acceleration`, be it empty
  std::vector<Assignment> motions;
  std::vector<Assignment> accelerations = {};  ///< of what `motions` name
  std::vector<Assignment> actions;
  std::vector<LoadDescription> loads;  ///< beside those of the top level, or in their place
  std::vector<Name> inputs;            ///< actuators
  std::vector<Name> outputs;           ///< actuators
  bool is_gear = false;                ///< made of `shift`
};

}  // namespace kinestat
