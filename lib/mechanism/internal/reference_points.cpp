#include "mechanism/internal/reference_points.hpp"

#include <algorithm>

namespace kinestat {

std::vector<Vec3> bind_reference_points(const MechanismDescription& description,
                                        const Topology& topology,
                                        const std::vector<Vec3>& points,
                                        Evaluator& evaluator) {
  std::vector<Vec3> references(topology.bodies.size(), Vec3::Zero());
  std::vector<bool> is_set(topology.bodies.size(), false);
  for (const BodyDescription& body : description.bodies) {
    const auto at = std::ranges::find(topology.bodies, body.name.text, &BodyTopology::name);
    if (body.reference && at != topology.bodies.end()) {
      const auto b = static_cast<std::size_t>(at - topology.bodies.begin());
      references[b] = evaluator.point(*body.reference).value_or(Vec3::Zero());
      is_set[b] = true;
    }
  }
  for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
    for (const BodyId body : {topology.couplings[e].tail, topology.couplings[e].head}) {
      const auto b = static_cast<std::size_t>(body.value);
      if (!is_set[b]) {
        references[b] = points[e];
        is_set[b] = true;
      }
    }
  }
  return references;
}

double characteristic_length(const std::vector<Vec3>& points) {
  if (points.empty()) {
    return 1.0;
  }
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double diagonal = (high - low).norm();
  return diagonal > 0.0 ? diagonal : 1.0;
}

}  // namespace kinestat
