// The columns of a motion that inertia has.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/motion/task/columns/motion_columns.hpp"

namespace kinestat {

/// A component of the wrench on the ground, or of shaking, about the world origin.
struct DynamicWrenchComponent {
  std::string element;   ///< "ground" or "shaking"
  std::string quantity;  ///< "force/x"
  QuantityKind kind = QuantityKind::force;
  std::function<std::optional<double>(const CaseDynamics&)> value;  ///< [SI]
};

/// Those that exist in the space of the mechanism, which must outlive them.
std::vector<DynamicWrenchComponent> dynamic_wrenches(const Mechanism& mechanism);

/// Energy, the wrenches on the ground and of shaking, and the reduced equation at the drives.
std::vector<MotionReading> dynamic_readings(const FileUnits& units,
                                            const Mechanism& mechanism,
                                            const MotionPlan& plan);

}  // namespace kinestat
