#include <algorithm>

#include "studies/motion/task/motion_findings.hpp"

namespace kinestat {

void add_motion_loss_findings(const MotionPlan& plan,
                              const Mechanism& mechanism,
                              Diagnostics& found) {
  const MotionReport& report = plan.report;
  const bool tells_actions = report.action || report.power || report.dynamics ||
                             report.mechanical_advantage || !report.actions.empty();
  const auto loses = [](const LossyMesh& one) { return one.law || one.share > 0.0; };
  if (tells_actions && std::ranges::any_of(mechanism.lossy_meshes, loses)) {
    found.warning(
        "W0610",
        plan.where,
        "actions and powers of the motion are without the losses of meshes",
        "'kinestat analyze' has those of a case with losses, 'kinestat simulate' those of "
        "a motion in time");
  }
}

}  // namespace kinestat
