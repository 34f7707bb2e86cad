// Before what takes moments of lines for any type of number.
#include "mechanism/bind/tooth_rules.hpp"

#include <algorithm>
#include <utility>

#include "core/index.hpp"
#include "mechanism/gears/internal/tooth_binder.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

// n - 2 (n·r) r/(r·r)
template <class Scalar>
Vec3Of<Scalar> mirrored(const Vec3Of<Scalar>& line, const Vec3Of<Scalar>& normal) {
  const Scalar twice = Scalar(2.0) * line.dot(normal) / normal.squaredNorm();
  return line - twice * normal;
}

bool has_other_flank(int action, const Geometry& geometry) {
  return std::ranges::find(geometry.other_flanks, action, &OtherFlankOf<double>::action) !=
         geometry.other_flanks.end();
}

// Whether `passive` leaves teeth their force.
bool bears(const CouplingTopology& coupling, const Topology& topology) {
  return coupling.action_count > 0 && topology.actions[at(coupling.first_action)].actuator < 0;
}

template <class Scalar>
OtherFlankOf<Scalar>& flank_of(int action, GeometryOf<Scalar>& geometry) {
  return *std::ranges::find(geometry.other_flanks, action, &OtherFlankOf<Scalar>::action);
}

}  // namespace

std::vector<TurningTeeth> find_turning_teeth(const MechanismDescription& description,
                                             const Topology& topology,
                                             const Geometry& geometry) {
  std::vector<TurningTeeth> teeth;
  for (std::size_t e = 0; e < description.couplings.size(); ++e) {
    const CouplingDescription& coupling = description.couplings[e];
    if (turns_flank(coupling) && !coupling.contact && bears(topology.couplings[e], topology)) {
      const int action = topology.couplings[e].first_action;
      teeth.push_back({.coupling = CouplingId{static_cast<int>(e)},
                       .action = action,
                       .internal = coupling.internal,
                       .has_other = has_other_flank(action, geometry)});
    }
  }
  return teeth;
}

std::vector<int> find_one_flanked(const MechanismDescription& description,
                                  const Topology& topology,
                                  const Geometry& geometry) {
  std::vector<int> actions;
  for (std::size_t e = 0; e < description.couplings.size(); ++e) {
    const CouplingTopology& bound = topology.couplings[e];
    if (turns_flank(description.couplings[e]) && bears(bound, topology) &&
        !has_other_flank(bound.first_action, geometry)) {
      actions.push_back(bound.first_action);
    }
  }
  return actions;
}

template <class Scalar>
void complete_flanks(const std::vector<ToothRule>& rules,
                     const Topology& topology,
                     GeometryOf<Scalar>& geometry) {
  std::vector<Twist> motions;
  for (std::size_t f = 0; f < geometry.motions.size() && !rules.empty(); ++f) {
    motions.push_back({.angular = values_of<Scalar>(geometry.motions[f].angular),
                       .linear = values_of<Scalar>(geometry.motions[f].linear)});
  }
  for (const ToothRule& rule : rules) {
    WrenchOf<Scalar>& action = geometry.actions[at(rule.action)];
    if (!rule.has_other) {
      const Vec3Of<Scalar> other =
          mirrored<Scalar>(action.force, pitch_normal<Scalar>(rule, topology, geometry));
      geometry.other_flanks.push_back(
          {.action = rule.action,
           .screw = unit_force<Scalar>(other, geometry.points[at(rule.coupling.value)])});
    }
    const Vec3 point = values_of<Scalar>(geometry.points[at(rule.coupling.value)]);
    if (is_pulling(rule, topology, motions, point, values_of<Scalar>(action.force))) {
      std::swap(action, flank_of<Scalar>(rule.action, geometry).screw);
    }
  }
  std::ranges::sort(geometry.other_flanks, {}, &OtherFlankOf<Scalar>::action);
}

template void complete_flanks(const std::vector<ToothRule>&, const Topology&, Geometry&);
template void complete_flanks(const std::vector<ToothRule>&, const Topology&, GeometryOf<Dual>&);
template void complete_flanks(const std::vector<ToothRule>&,
                              const Topology&,
                              GeometryOf<ExactInput>&);

}  // namespace kinestat
