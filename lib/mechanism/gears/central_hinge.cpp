#include "mechanism/gears/central_hinge.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/gears/hinge_lines.hpp"
#include "mechanism/gears/planet_load.hpp"

namespace kinestat {

namespace {

using Bodies = std::vector<bool>;

bool is_pin(const Mechanism& mechanism, const CouplingTopology& coupling) {
  return planets_of(mechanism, coupling) > 1 && is_hinge(coupling.type);
}

// Follows a line of hinges, without one of them, as far as the ground. What engages bears a couple
// alone.
class LineWalk {
 public:
  LineWalk(const Topology& topology, const HingeLine& line, CouplingId without)
      : topology_(topology), line_(line), without_(without), reached(topology.bodies.size()) {}

  void from(BodyId body) {
    if (body.value == 0) {
      is_grounded = true;
      return;
    }
    if (reached[at(body.value)]) {
      return;
    }
    reached[at(body.value)] = true;
    for (const CouplingId hinge : line_.hinges) {
      const CouplingTopology& one = topology_.coupling(hinge);
      if (hinge != without_ && !kind_of(one.type).engages &&
          (one.tail == body || one.head == body)) {
        from(one.tail == body ? one.head : one.tail);
      }
    }
  }

  bool is_grounded = false;
  Bodies reached;

 private:
  const Topology& topology_;
  const HingeLine& line_;
  CouplingId without_;
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
      for (std::size_t b = 0; one.has_inertia() && b < mechanism.masses.size(); ++b) {
        bears_load_[b] = bears_load_[b] || mechanism.masses[b].counts();
      }
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
        for (const CouplingId hinge : line.hinges) {
          found[at(hinge.value)] = central_hinge(line, hinge);
        }
      }
    }
    return found;
  }

 private:
  // The ground may bear planets of other lines.
  bool is_central(const HingeLine& line) const {
    return std::ranges::none_of(
               line.hinges,
               [&](CouplingId hinge) { return is_pin(mechanism_, topology_.coupling(hinge)); }) &&
           std::ranges::any_of(line.bodies, [&](BodyId body) {
             return body.value != 0 && bears_planets_[at(body.value)];
           });
  }

  CentralHinge central_hinge(const HingeLine& line, CouplingId hinge) const {
    const CouplingTopology& coupling = topology_.coupling(hinge);
    LineWalk head(topology_, line, hinge);
    head.from(coupling.head);
    LineWalk tail(topology_, line, hinge);
    tail.from(coupling.tail);
    const bool carries_head = !head.is_grounded && tail.is_grounded;
    CentralHinge result{
        .axis = line.direction, .across = CentralHinge::Across::rest, .planets = {}};
    if (carries_head || (!tail.is_grounded && head.is_grounded)) {
      const Bodies carried = with_planets(carries_head ? head.reached : tail.reached);
      add_planets(carried, carries_head ? 1.0 : -1.0, result);
      result.across =
          bears_more(line, carried) ? CentralHinge::Across::rest : CentralHinge::Across::nothing;
      return result;
    }
    Bodies all(topology_.bodies.size());
    for (const BodyId body : line.bodies) {
      all[at(body.value)] = body.value != 0;
    }
    result.across = bears_more(line, with_planets(std::move(all))) ? CentralHinge::Across::shared
                                                                   : CentralHinge::Across::nothing;
    return result;
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

  // Beside the planets, its hinges and what engages.
  bool bears_more(const HingeLine& line, const Bodies& carried) const {
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingTopology& one = topology_.coupling(CouplingId{e});
      const bool is_known = planets_of(mechanism_, one) > 1 || kind_of(one.type).engages ||
                            std::ranges::find(line.hinges, CouplingId{e}) != line.hinges.end();
      if (!is_known && (carried[at(one.tail.value)] || carried[at(one.head.value)])) {
        return true;
      }
    }
    for (std::size_t b = 0; b < carried.size(); ++b) {
      if (carried[b] && bears_load_[b]) {
        return true;
      }
    }
    return false;
  }

  const Mechanism& mechanism_;
  const Topology& topology_;
  Bodies bears_planets_;
  Bodies bears_load_;
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
