// The actuators of a description, bound as internalised actions of the topology.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "couplings/coupling_catalogue.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Adds the actuators of each coupling: those that the file declares, and clutches and brakes.
class ActuatorBinder {
 public:
  /// Adds an error for each actuator on a coupling that is not declared.
  ActuatorBinder(const MechanismDescription& description, Mechanism& result, Diagnostics& found);

  /// Adds the actuators of the coupling that was added last to the topology. Its screws are about
  /// the origin of the geometry.
  void add(CouplingId id,
           const CouplingDescription& coupling,
           const CouplingScrews& screws,
           const Vec3& at);

 private:
  // An actuator that waits for its freedom and action to be numbered.
  struct Pending {
    std::string name;
    std::string freedom;
    SourceRange where;
  };

  void refuse(const ActuatorDescription& actuator);
  std::vector<Pending> take(const CouplingDescription& coupling);
  std::optional<std::size_t> choose_freedom(const Pending& actuator,
                                            const CouplingDescription& coupling,
                                            const CouplingScrews& screws);
  void append(CouplingId id,
              const Pending& actuator,
              std::size_t freedom,
              const NamedWrench& action);

  const MechanismDescription& description_;
  Topology& topology_;
  Geometry& geometry_;
  Diagnostics& found_;
  std::map<std::string, std::vector<Pending>> pending_;  ///< by coupling
};

}  // namespace kinestat
