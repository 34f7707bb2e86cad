#include "studies/simulation/rubbing.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/index.hpp"
#include "mechanism/gears/hinge_lines.hpp"
#include "mechanism/gears/mesh.hpp"

namespace kinestat {

namespace {

class GearFinder {
 public:
  explicit GearFinder(const Mechanism& mechanism)
      : topology_(mechanism.topology),
        geometry_(mechanism.geometry),
        meshes_(find_meshes(topology_, geometry_)),
        lines_(find_hinge_lines(topology_, geometry_)) {}

  // Of the head, then of the tail; empty where hinges do not join both with the carrier.
  std::vector<Rubbing> gears_of(const LossyMesh& lossy) const {
    const CouplingId id = lossy.coupling;
    const auto mesh = std::ranges::find(meshes_, id, &Mesh::coupling);
    if (mesh == meshes_.end() || !mesh->carrier) {
      return {};
    }
    const CouplingTopology& teeth = topology_.coupling(id);
    std::vector<Rubbing> gears;
    for (const BodyId gear : {teeth.head, teeth.tail}) {
      double sense = 1.0;
      std::vector<SlidingTerm> slides = turning(*mesh->carrier, gear, sense);
      if (slides.empty()) {
        return {};
      }
      const CouplingId hinge = topology_.freedoms[at(slides.front().freedom)].coupling;
      const Twist& axis = geometry_.motions[at(slides.front().freedom)];
      const Vec3 arm = geometry_.points[at(id.value)] - geometry_.points[at(hinge.value)];
      gears.push_back({.coupling = id,
                       .slides = std::move(slides),
                       .gear = DrivenGear{.between = {.tail = *mesh->carrier, .head = gear},
                                          .is_head = gear == teeth.head,
                                          .mesh = &lossy,
                                          .radius = axis.angular.cross(arm).norm(),
                                          .sense = sense}});
    }
    return gears;
  }

 private:
  // About the axis on which hinges join both; empty without one. `sense` is that of the screw of
  // the first along it.
  std::vector<SlidingTerm> turning(BodyId carrier, BodyId gear, double& sense) const {
    for (const HingeLine& line : lines_) {
      const bool has_both =
          std::ranges::count(line.bodies, carrier) > 0 && std::ranges::count(line.bodies, gear) > 0;
      if (has_both) {
        std::vector<SlidingTerm> path;
        std::vector<CouplingId> left = line.hinges;
        if (reach(carrier, gear, line, left, path)) {
          sense = along(line, path.front().freedom);
          return path;
        }
      }
    }
    return {};
  }

  double along(const HingeLine& line, int freedom) const {
    return geometry_.motions[at(freedom)].angular.dot(line.direction) > 0.0 ? 1.0 : -1.0;
  }

  // Over hinges that are left.
  bool reach(BodyId from,
             BodyId to,
             const HingeLine& line,
             std::vector<CouplingId>& left,
             std::vector<SlidingTerm>& path) const {
    if (from == to) {
      return true;
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
      const CouplingId id = left[i];
      const CouplingTopology& hinge = topology_.coupling(id);
      const bool is_forward = hinge.tail == from;
      if ((!is_forward && hinge.head != from) || hinge.freedom_count != 1) {
        continue;
      }
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      const double forward = along(line, hinge.first_freedom);
      path.push_back({.freedom = hinge.first_freedom, .factor = is_forward ? forward : -forward});
      if (reach(is_forward ? hinge.head : hinge.tail, to, line, left, path)) {
        return true;
      }
      path.pop_back();
      i = static_cast<std::size_t>(-1);  // others may be left now
    }
    return false;
  }

  const Topology& topology_;
  const Geometry& geometry_;
  std::vector<Mesh> meshes_;
  std::vector<HingeLine> lines_;
};

}  // namespace

bool Rubbing::is_dry() const {
  return gear || !friction.cables.empty() || friction.mu > 0.0 || friction.tau > 0.0 ||
         friction.tau_of_speed || friction.mu_static;
}

bool Rubbing::is_of_gripped() const {
  const bool is_of_cables = !gear && !friction.cables.empty() && friction.mu == 0.0 &&
                            friction.tau == 0.0 && !friction.tau_of_speed && !friction.mu_static;
  return is_of_cables && std::ranges::all_of(friction.cables, [](const CableFriction& cable) {
           return cable.unless_slip.has_value();
         });
}

std::vector<Rubbing> find_rubbing(const Mechanism& mechanism) {
  std::vector<Rubbing> all;
  for (const CouplingFriction& one : mechanism.frictions) {
    const int freedom = mechanism.topology.coupling(one.coupling).first_freedom;
    all.push_back({.coupling = one.coupling, .slides = {{.freedom = freedom}}, .friction = one});
  }
  if (mechanism.lossy_meshes.empty()) {
    return all;
  }
  const GearFinder finder(mechanism);
  for (const LossyMesh& lossy : mechanism.lossy_meshes) {
    if (lossy.law || lossy.share > 0.0) {
      std::ranges::move(finder.gears_of(lossy), std::back_inserter(all));
    }
  }
  return all;
}

bool turns_on_carrier(const Mechanism& mechanism, const LossyMesh& mesh) {
  return !GearFinder(mechanism).gears_of(mesh).empty();
}

}  // namespace kinestat
