#include "power/internal/net_power.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/bounded_motion.hpp"
#include "power/net_shafts.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

class NetFinder {
 public:
  NetFinder(const Mechanism& mechanism,
            const KinematicSolution& motion,
            const StaticSolution& action,
            std::span<const Mesh> meshes)
      : topology_(mechanism.topology),
        motion_(motion),
        action_(action),
        shafts_(mechanism.topology, meshes) {}

  std::vector<PowerArc> run(const std::vector<PowerArc>& arcs) {
    for (const PowerArc& arc : arcs) {
      if (!shafts_.bears_planet(arc.coupling)) {
        add({.coupling = arc.coupling,
             .from = shafts_.shaft_of(arc.from),
             .to = shafts_.shaft_of(arc.to),
             .power = arc.power,
             .bound = arc.bound});
      }
    }
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      if (shafts_.bears_planet(CouplingId{e}) && action_.wrenches[static_cast<std::size_t>(e)]) {
        add(from_carrier(CouplingId{e}));
      }
    }
    return sums();
  }

 private:
  // What the carrier gives, which may be negative.
  PowerArc from_carrier(CouplingId id) const {
    const CouplingTopology& coupling = topology_.coupling(id);
    const bool is_tail = shafts_.planet_on(id) == coupling.head;
    const BodyId carrier = is_tail ? coupling.tail : coupling.head;
    const BoundedNumber on_carrier =
        power(*bounded_wrench(action_, id), bounded_body(motion_, carrier));
    return {.coupling = id,
            .from = carrier,
            .to = shafts_.shaft_of(is_tail ? coupling.head : coupling.tail),
            .power = is_tail ? on_carrier.value : -on_carrier.value,
            .bound = on_carrier.bound};
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
      for (std::size_t j = i + 1; j < parts_.size() && shafts_.is_summed(parts_[i].coupling); ++j) {
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
    const bool is_same_kind = shafts_.is_summed(b.coupling) &&
                              shafts_.bears_planet(a.coupling) == shafts_.bears_planet(b.coupling);
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
  NetShafts shafts_;
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
