// What a mechanism file says, section by section, each number still an expression with its place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/case_description.hpp"
#include "description/coupling_description.hpp"
#include "expression/file_units.hpp"

namespace kinestat {

/// How many coordinates a pass works in; minimal: only those that the screws of the mechanism need.
enum class OrderChoice { minimal, planar, spatial };

struct ParameterDescription {
  Name name;
  Value value;
};

struct BodyDescription {
  Name name;
  std::optional<PointDescription> reference;  ///< default: the first coupling's point
};

/// An active coupling; `freedom` is needed where the coupling has several.
struct ActuatorDescription {
  Name name;
  Name coupling;
  std::optional<Name> freedom;
};

/// A number that the source prints, checked against the report.
struct PublishedValue {
  Name pointer;            ///< JSON Pointer into the report
  double is = 0.0;         ///< the right value, in the report's units
  double tolerance = 0.0;  ///< absolute
  std::string where;       ///< place in the source
  SourceRange is_where;
};

/// One mechanism file. Sections that are absent are empty.
struct MechanismDescription {
  std::string name;
  std::string source;
  Space space = Space::spatial;
  FileUnits units;
  std::vector<ParameterDescription> parameters;
  std::optional<std::vector<Name>> tree;
  SourceRange tree_where;
  OrderChoice kinematic_order = OrderChoice::minimal;
  OrderChoice static_order = OrderChoice::minimal;
  SourceRange order_where;
  Name ground;
  std::vector<BodyDescription> bodies;
  std::vector<CouplingDescription> couplings;
  std::vector<ActuatorDescription> actuators;
  std::vector<CaseDescription> cases;
  std::vector<PublishedValue> published;
};

}  // namespace kinestat
