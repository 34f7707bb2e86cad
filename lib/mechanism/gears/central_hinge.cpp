#include "mechanism/gears/central_hinge.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/gears/hinge_lines.hpp"
#include "mechanism/gears/planet_load.hpp"

namespace kinestat {

namespace {

using Bodies = std::vector<bool>;

bool is_pin(const Mechanism& mechanism, const CouplingTopology& coupling) {
  return planets_of(mechanism, coupling) > 1 && is_hinge(coupling.type);
}

bool is_on(const HingeLine& line, const Vec3& point, const Mechanism& mechanism) {
  return (point - line.point).cross(line.direction).norm() <=
         kParallelAxes * mechanism.geometry.length;
}

// What holds bodies across a line: its hinges, and other couplings on it.
class Support {
 public:
  Support(const Mechanism& mechanism, const HingeLine& line) : topology_(mechanism.topology) {
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingId id{e};
      const CouplingTopology& one = topology_.coupling(id);
      const bool is_of_line =
          std::ranges::find(line.hinges, id) != line.hinges.end() ||
          one.type == CouplingType::rigid ||
          (bears_across(one) && is_on(line, mechanism.geometry.points[at(e)], mechanism));
      // What engages bears a couple alone.
      if (is_of_line && planets_of(mechanism, one) == 1 && !kind_of(one.type).engages) {
        couplings_.push_back(id);
      }
    }
  }

  bool has(CouplingId id) const { return std::ranges::find(couplings_, id) != couplings_.end(); }

  struct Reach {
    Bodies bodies;
    bool is_grounded = false;
  };

  // What hangs together with a body without that hinge, as far as the ground, or through it.
  Reach reach(BodyId from, CouplingId without, bool through_ground) const {
    Reach found{.bodies = Bodies(topology_.bodies.size())};
    std::vector<BodyId> next = {from};
    while (!next.empty()) {
      const BodyId body = next.back();
      next.pop_back();
      found.is_grounded = found.is_grounded || body.value == 0;
      if (found.bodies[at(body.value)]) {
        continue;
      }
      found.bodies[at(body.value)] = true;
      for (const CouplingId id : couplings_) {
        const CouplingTopology& one = topology_.coupling(id);
        const bool leads_on = body.value != 0 || through_ground;
        if (id != without && leads_on && (one.tail == body || one.head == body)) {
          next.push_back(one.tail == body ? one.head : one.tail);
        }
      }
    }
    return found;
  }

 private:
  bool bears_across(const CouplingTopology& coupling) const {
    int forces = 0;
    for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
      const ActionLabel& action = topology_.actions[at(a)];
      forces += action.actuator < 0 && !action.is_couple ? 1 : 0;
    }
    return forces > 1;
  }

  const Topology& topology_;
  std::vector<CouplingId> couplings_;
};

class CentralHingeSearch {
 public:
  explicit CentralHingeSearch(const Mechanism& mechanism)
      : mechanism_(mechanism),
        topology_(mechanism.topology),
        bears_planets_(topology_.bodies.size()),
        bears_load_(topology_.bodies.size()) {
    for (const CouplingTopology& coupling : topology_.couplings) {
      if (planets_of(mechanism, coupling) > 1) {
        bears_planets_[at(coupling.tail.value)] = true;
        bears_planets_[at(coupling.head.value)] = true;
      }
    }
    for (const Case& one : mechanism.cases) {
      for (const Load& load : one.loads) {
        bears_load_[at(load.acts.body.value)] = true;
      }
      for (const MovingLoad& load : one.moving_loads) {
        bears_load_[at(load.body.value)] = true;
      }
      has_inertia_ = has_inertia_ || one.has_inertia();
    }
    for (const Spring& spring : mechanism.springs) {
      bears_load_[at(spring.tail.value)] = true;
      bears_load_[at(spring.head.value)] = true;
    }
  }

  std::vector<std::optional<CentralHinge>> run() const {
    std::vector<std::optional<CentralHinge>> found(topology_.couplings.size());
    for (const HingeLine& line : find_hinge_lines(topology_, mechanism_.geometry)) {
      if (is_central(line)) {
        const Support support(mechanism_, line);
        for (const CouplingId hinge : line.hinges) {
          found[at(hinge.value)] = central_hinge(line, support, hinge);
        }
      }
    }
    return found;
  }

 private:
  // The axis of planets is that of two of their carriers, suns and rings, one of which may be the
  // ground; a crank pin on a carrier is on another.
  bool is_central(const HingeLine& line) const {
    const auto bears = [&](BodyId body) { return bears_planets_[at(body.value)]; };
    return std::ranges::count_if(line.bodies, bears) > 1 &&
           std::ranges::any_of(line.bodies,
                               [&](BodyId body) { return body.value != 0 && bears(body); }) &&
           std::ranges::none_of(line.hinges, [&](CouplingId hinge) {
             return is_pin(mechanism_, topology_.coupling(hinge));
           });
  }

  CentralHinge central_hinge(const HingeLine& line,
                             const Support& support,
                             CouplingId hinge) const {
    using enum CentralHinge::Across;
    const CouplingTopology& coupling = topology_.coupling(hinge);
    CentralHinge result{.axis = line.direction, .across = nothing, .planets = {}};
    const Support::Reach head = support.reach(coupling.head, hinge, false);
    const Support::Reach tail = support.reach(coupling.tail, hinge, false);
    if (support.reach(coupling.head, hinge, true).bodies[at(coupling.tail.value)]) {
      Bodies all = head.bodies;
      for (std::size_t b = 0; b < all.size(); ++b) {
        all[b] = b > 0 && (all[b] || tail.bodies[b]);
      }
      result.across = bears_more(line, support, with_planets(std::move(all))) ? shared : nothing;
      return result;
    }
    const Bodies carried = with_planets(head.is_grounded ? tail.bodies : head.bodies);
    if (!bears_more(line, support, carried)) {
      return result;
    }
    result.across = spreads_inertia(carried) ? shared : rest;
    if (result.across == rest) {
      add_planets(carried, head.is_grounded ? -1.0 : 1.0, result);
    }
    return result;
  }

  // The inertia of planets cancels too, and is not among the actions of couplings.
  bool spreads_inertia(const Bodies& carried) const {
    for (std::size_t b = 0; has_inertia_ && b < mechanism_.masses.size(); ++b) {
      const BodyMass& mass = mechanism_.masses[b];
      if (carried[b] && mass.count > 1 && mass.mass > 0.0) {
        return true;
      }
    }
    return false;
  }

  // What turns about its own centre of mass on an axis at rest presses nothing.
  bool is_pressed_by_inertia(const HingeLine& line, std::size_t body) const {
    if (!has_inertia_ || body >= mechanism_.masses.size()) {
      return false;
    }
    const BodyMass& mass = mechanism_.masses[body];
    const bool is_balanced = line.bodies.front().value == 0 && is_on(line, mass.centre, mechanism_);
    return mass.count == 1 && mass.mass > 0.0 && !is_balanced;
  }

  // With the planets that turn on these bodies.
  Bodies with_planets(Bodies bodies) const {
    const Bodies carriers = bodies;
    for (const CouplingTopology& one : topology_.couplings) {
      if (is_pin(mechanism_, one) &&
          (carriers[at(one.tail.value)] || carriers[at(one.head.value)])) {
        bodies[at(one.tail.value)] = one.tail.value != 0;
        bodies[at(one.head.value)] = one.head.value != 0;
      }
    }
    return bodies;
  }

  void add_planets(const Bodies& carried, double sign, CentralHinge& to) const {
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingTopology& one = topology_.coupling(CouplingId{e});
      const bool has_head = carried[at(one.head.value)];
      if (planets_of(mechanism_, one) > 1 && !is_hinge(one.type) &&
          has_head != carried[at(one.tail.value)]) {
        to.planets.push_back({.coupling = CouplingId{e}, .sign = has_head ? sign : -sign});
      }
    }
  }

  // Beside planets, what supports them and what engages.
  bool bears_more(const HingeLine& line, const Support& support, const Bodies& carried) const {
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingTopology& one = topology_.coupling(CouplingId{e});
      const bool is_known = planets_of(mechanism_, one) > 1 || kind_of(one.type).engages ||
                            support.has(CouplingId{e});
      if (!is_known && carried[at(one.tail.value)] != carried[at(one.head.value)]) {
        return true;
      }
    }
    for (std::size_t b = 0; b < carried.size(); ++b) {
      if (carried[b] && (bears_load_[b] || is_pressed_by_inertia(line, b))) {
        return true;
      }
    }
    return false;
  }

  const Mechanism& mechanism_;
  const Topology& topology_;
  Bodies bears_planets_;
  Bodies bears_load_;
  bool has_inertia_ = false;
};

}  // namespace

std::vector<std::optional<CentralHinge>> find_central_hinges(const Mechanism& mechanism) {
  return has_planets(mechanism)
             ? CentralHingeSearch(mechanism).run()
             : std::vector<std::optional<CentralHinge>>(mechanism.topology.couplings.size());
}

Vec3 borne(const std::optional<CentralHinge>& hinge, const Vec3& own, const Vec3& with_planets) {
  using enum CentralHinge::Across;
  if (!hinge || hinge->across == shared) {
    return own;
  }
  const Vec3& z = hinge->axis;
  const Vec3 along = z * z.dot(own);
  return hinge->across == nothing ? along : Vec3(along + with_planets - z * z.dot(with_planets));
}

}  // namespace kinestat
