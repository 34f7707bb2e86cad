// A body as the user wrote it.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// A body, or a virtual link that the section `cables` makes.
struct BodyDescription {
  Name name;
  std::optional<PointDescription> reference;  ///< default: the first coupling's point
  std::optional<Value> mass;
  std::optional<PointDescription> centre_of_mass;
  std::vector<PointDescription> outline;  ///< for pictures
  bool is_virtual = false;                ///< made by `cables`
};

}  // namespace kinestat
