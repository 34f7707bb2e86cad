#include "power/internal/net_power.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "couplings/kinds.hpp"
#include "kinematics/bounded_motion.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

// Planets, and the shaft that each body counts as.
class PlanetGroups {
 public:
  PlanetGroups(const Topology& topology, std::span<const Mesh> meshes) : topology_(topology) {
    for (int b = 0; b < topology_.body_count(); ++b) {
      shaft_of_.push_back(BodyId{b});
    }
    carrier_of_.resize(topology_.bodies.size());
    for (const Mesh& mesh : meshes) {
      find_planets(mesh);
    }
    for (const Mesh& mesh : meshes) {
      join_planets(mesh);
    }
  }

  // The first planet of those that it meshes with; any other body itself.
  BodyId shaft_of(BodyId body) const { return shaft_of_[index(body)]; }

  // On which a planet turns.
  const std::optional<BodyId>& carrier_of(BodyId body) const { return carrier_of_[index(body)]; }

 private:
  static std::size_t index(BodyId body) { return static_cast<std::size_t>(body.value); }

  // A gear that nothing holds but its carrier and teeth.
  bool turns_on(BodyId gear, BodyId carrier) const {
    return std::ranges::all_of(topology_.couplings, [&](const CouplingTopology& coupling) {
      const bool is_at = coupling.tail == gear || coupling.head == gear;
      const BodyId other = coupling.tail == gear ? coupling.head : coupling.tail;
      return !is_at || joins_wheels(coupling.type) || other == carrier;
    });
  }

  void find_planets(const Mesh& mesh) {
    if (!mesh.carrier || mesh.carrier->value == 0) {
      return;
    }
    const CouplingTopology& teeth = topology_.coupling(mesh.coupling);
    for (const BodyId gear : {teeth.tail, teeth.head}) {
      if (turns_on(gear, *mesh.carrier)) {
        carrier_of_[index(gear)] = mesh.carrier;
      }
    }
  }

  void join_planets(const Mesh& mesh) {
    const CouplingTopology& teeth = topology_.coupling(mesh.coupling);
    if (!carrier_of(teeth.tail) || carrier_of(teeth.tail) != carrier_of(teeth.head)) {
      return;
    }
    const BodyId tail = shaft_of(teeth.tail);
    const BodyId head = shaft_of(teeth.head);
    std::ranges::replace(shaft_of_, std::max(tail, head), std::min(tail, head));
  }

  const Topology& topology_;
  std::vector<BodyId> shaft_of_;
  std::vector<std::optional<BodyId>> carrier_of_;
};

class NetFinder {
 public:
  NetFinder(const Mechanism& mechanism,
            const KinematicSolution& motion,
            const StaticSolution& action,
            std::span<const Mesh> meshes)
      : topology_(mechanism.topology),
        motion_(motion),
        action_(action),
        planets_(mechanism.topology, meshes) {}

  std::vector<PowerArc> run(const std::vector<PowerArc>& arcs) {
    for (const PowerArc& arc : arcs) {
      if (!bears_planet(arc.coupling)) {
        add({.coupling = arc.coupling,
             .from = planets_.shaft_of(arc.from),
             .to = planets_.shaft_of(arc.to),
             .power = arc.power,
             .bound = arc.bound});
      }
    }
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      if (bears_planet(CouplingId{e}) && action_.wrenches[static_cast<std::size_t>(e)]) {
        add(from_carrier(CouplingId{e}));
      }
    }
    return sums();
  }

 private:
  // Whether it joins a planet and its carrier.
  bool bears_planet(CouplingId id) const {
    const CouplingTopology& coupling = topology_.coupling(id);
    return planets_.carrier_of(coupling.head) == coupling.tail ||
           planets_.carrier_of(coupling.tail) == coupling.head;
  }

  // What the carrier gives, which may be negative.
  PowerArc from_carrier(CouplingId id) const {
    const CouplingTopology& coupling = topology_.coupling(id);
    const bool is_tail = planets_.carrier_of(coupling.head) == coupling.tail;
    const BodyId carrier = is_tail ? coupling.tail : coupling.head;
    const BoundedNumber on_carrier =
        power(*bounded_wrench(action_, id), bounded_body(motion_, carrier));
    return {.coupling = id,
            .from = carrier,
            .to = planets_.shaft_of(is_tail ? coupling.head : coupling.tail),
            .power = is_tail ? on_carrier.value : -on_carrier.value,
            .bound = on_carrier.bound};
  }

  // Whether a coupling counts together with others between the same two.
  bool is_summed(CouplingId id) const {
    return topology_.coupling(id).type == CouplingType::cable || bears_planet(id);
  }

  void add(const PowerArc& arc) {
    if (arc.from != arc.to) {
      parts_.push_back(arc);
    }
  }

  // Of each pair what one side gives more than the other, in the place of its first part; those
  // that give as much as they take transmit nothing.
  std::vector<PowerArc> sums() const {
    std::vector<PowerArc> result;
    std::vector<bool> is_done(parts_.size(), false);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (is_done[i]) {
        continue;
      }
      BoundedNumber sum = bounded(parts_[i], 1.0);
      std::vector<PowerArc> alike = {parts_[i]};
      for (std::size_t j = i + 1; j < parts_.size() && is_summed(parts_[i].coupling); ++j) {
        const double sense = sense_between(parts_[i], parts_[j]);
        if (sense != 0.0) {
          is_done[j] = true;
          sum = sum + bounded(parts_[j], sense);
          alike.push_back(parts_[j]);
          alike.back().power *= sense;
        }
      }
      if (sum.zeroed() != 0.0) {
        result.push_back(strongest(parts_[i], alike, sum));
      }
    }
    std::ranges::stable_sort(result, {}, &PowerArc::coupling);
    return result;
  }

  // 1 where b joins the same two as a in the same sense, -1 in the other, 0 if it does neither.
  double sense_between(const PowerArc& a, const PowerArc& b) const {
    const bool is_same_kind =
        is_summed(b.coupling) && bears_planet(a.coupling) == bears_planet(b.coupling);
    if (!is_same_kind) {
      return 0.0;
    }
    return a.from == b.from && a.to == b.to ? 1.0 : a.from == b.to && a.to == b.from ? -1.0 : 0.0;
  }

  static BoundedNumber bounded(const PowerArc& arc, double sense) {
    return {.value = sense * arc.power, .bound = arc.bound};
  }

  static PowerArc strongest(const PowerArc& first,
                            const std::vector<PowerArc>& alike,
                            const BoundedNumber& sum) {
    const bool is_back = sum.value < 0.0;
    const double sign = is_back ? -1.0 : 1.0;
    PowerArc result =
        *std::ranges::max_element(alike, {}, [&](const PowerArc& arc) { return sign * arc.power; });
    result.from = is_back ? first.to : first.from;
    result.to = is_back ? first.from : first.to;
    result.power = std::abs(sum.value);
    result.bound = sum.bound;
    return result;
  }

  const Topology& topology_;
  const KinematicSolution& motion_;
  const StaticSolution& action_;
  PlanetGroups planets_;
  std::vector<PowerArc> parts_;
};

}  // namespace

std::vector<PowerArc> find_net_powers(const Mechanism& mechanism,
                                      const KinematicSolution& motion,
                                      const StaticSolution& action,
                                      std::span<const Mesh> meshes,
                                      const std::vector<PowerArc>& arcs) {
  return NetFinder(mechanism, motion, action, meshes).run(arcs);
}

}  // namespace kinestat
