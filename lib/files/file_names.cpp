#include "files/file_names.hpp"

#include "files/load_file.hpp"
#include "files/parameter_names.hpp"
#include "mechanism/motion_plan.hpp"
#include "studies/tolerance/watched_position.hpp"

namespace kinestat {

FileNames names_of(const Loaded& loaded) {
  FileNames names;
  names.parameters = parameter_names(loaded.description);
  for (const CurveDescription& curve : loaded.description.curves) {
    names.curves.push_back(curve.name.text);
  }
  const Topology& topology = loaded.mechanism.topology;
  for (const ActuatorTopology& actuator : topology.actuators) {
    names.actuators.push_back(actuator.name);
    names.quantities.push_back(actuator.name);
  }
  for (int f = 0; f < topology.freedom_count(); ++f) {
    names.quantities.push_back(topology.freedom_name(f));
  }
  for (int a = 0; a < topology.action_count(); ++a) {
    names.quantities.push_back(topology.action_name(a));
  }
  for (const Case& one : loaded.mechanism.cases) {
    names.cases.push_back(one.label);
  }
  const std::optional<MotionPlan> plan = bind_motion(loaded.description, loaded.mechanism);
  names.positions =
      watched_names(loaded.mechanism, plan ? plan->trace : std::vector<TracedPoint>());
  return names;
}

FileNames names_in_file(const std::string& path) {
  SourceFile source;
  Diagnostics found;
  const std::optional<Loaded> loaded = load(path, {}, source, found);
  return loaded ? names_of(*loaded) : FileNames{};
}

}  // namespace kinestat
