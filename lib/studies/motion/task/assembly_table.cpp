#include "studies/motion/task/assembly_table.hpp"

#include <cmath>
#include <vector>

namespace kinestat {

namespace {

std::vector<CouplingGap> gaps_of(const std::vector<CouplingMiss>& misses,
                                 const Topology& topology,
                                 const FileUnits& units) {
  std::vector<CouplingGap> result;
  for (const CouplingMiss& miss : misses) {
    result.push_back({.coupling = topology.coupling(miss.coupling).name,
                      .distance = units.from_si(QuantityKind::length, miss.distance),
                      .angle = units.from_si(QuantityKind::angle, miss.angle)});
  }
  return result;
}

}  // namespace

void add_assembly(const Assembly& assembly,
                  const Mechanism& mechanism,
                  const FileUnits& units,
                  MotionTable& table) {
  table.drawn_gaps = gaps_of(assembly.drawn_misses, mechanism.topology, units);
  table.nearest_gaps = gaps_of(assembly.nearest_misses, mechanism.topology, units);
  for (std::size_t b = 1; b < assembly.corrections.size(); ++b) {
    const BodyPose& pose = assembly.corrections[b];
    const Vec3& reference = mechanism.geometry.references[b];
    const Vec3 shift = pose.point(reference) - reference;
    const double angle = std::abs(Eigen::AngleAxisd(pose.rotation).angle());
    table.corrections.push_back({.body = mechanism.topology.bodies[b].name,
                                 .shift = shift.unaryExpr([&](double x) {
                                   return units.from_si(QuantityKind::length, x) + 0.0;
                                 }),
                                 .angle = units.from_si(QuantityKind::angle, angle)});
  }
}

}  // namespace kinestat
