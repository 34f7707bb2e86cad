#include "mechanism/mesh.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <vector>

#include "core/tolerance.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

bool is_mesh(CouplingType type) {
  return type == gear || type == bevel_gear;
}

bool is_hinge(CouplingType type) {
  return type == revolute || type == cylindrical || type == clutch || type == brake;
}

// Two bodies that turn about a common line.
struct Hinge {
  int tail = 0;
  int head = 0;
  Vec3 direction;
  Vec3 point;
  double mark = 0.0;  // the same for hinges on one line, up to rounding
};

// Where the line comes nearest to the origin, along a direction in which few mechanisms lie.
double mark_of(const Vec3& point, const Vec3& direction) {
  const Vec3 foot = point - point.dot(direction) * direction;
  return foot.dot(Vec3(0.61, 0.67, 0.43));
}

class CarrierSearch {
 public:
  CarrierSearch(const Topology& topology, const Geometry& geometry)
      : length_(geometry.length), hinges_at_(topology.bodies.size()) {
    for (const CouplingTopology& coupling : topology.couplings) {
      if (is_hinge(coupling.type)) {
        add(coupling, topology, geometry);
      }
    }
    for (std::vector<std::size_t>& hinges : hinges_at_) {
      std::ranges::sort(hinges, {}, [this](std::size_t h) { return hinges_[h].mark; });
    }
  }

  std::optional<BodyId> carrier_of(int first, int second) const {
    std::set<int> found;
    for (const std::size_t a : hinges_at_[static_cast<std::size_t>(first)]) {
      for (const std::size_t b : hinges_at_[static_cast<std::size_t>(second)]) {
        if (!is_one_line(hinges_[a], hinges_[b])) {
          std::ranges::set_intersection(turning_on(hinges_[a], first),
                                        turning_on(hinges_[b], second),
                                        std::inserter(found, found.end()));
        }
      }
    }
    found.erase(first);
    found.erase(second);
    return found.size() == 1 ? std::optional(BodyId{*found.begin()}) : std::nullopt;
  }

 private:
  void add(const CouplingTopology& coupling, const Topology& topology, const Geometry& geometry) {
    for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
      const auto i = static_cast<std::size_t>(f);
      const std::optional<ScrewAxis> axis = find_axis(geometry.motions[i], geometry.length);
      if (topology.freedoms[i].is_rotation && axis && axis->point) {
        hinges_at_[static_cast<std::size_t>(coupling.tail.value)].push_back(hinges_.size());
        hinges_at_[static_cast<std::size_t>(coupling.head.value)].push_back(hinges_.size());
        hinges_.push_back({.tail = coupling.tail.value,
                           .head = coupling.head.value,
                           .direction = axis->direction,
                           .point = *axis->point,
                           .mark = mark_of(*axis->point, axis->direction)});
        farthest_ = std::max(farthest_, axis->point->norm());
        return;
      }
    }
  }

  bool is_one_line(const Hinge& a, const Hinge& b) const {
    const Vec3 between = b.point - a.point;
    return a.direction.cross(b.direction).norm() <= kParallelAxes &&
           between.cross(a.direction).norm() <= kParallelAxes * length_;
  }

  // The body, and all that turn with it or against it about the line of the hinge.
  std::set<int> turning_on(const Hinge& line, int body) const {
    std::set<int> bodies = {body};
    std::vector<int> waiting = {body};
    while (!waiting.empty()) {
      const auto at = static_cast<std::size_t>(waiting.back());
      waiting.pop_back();
      for (const std::size_t h : hinges_near(line, at)) {
        const Hinge& hinge = hinges_[h];
        const int other = hinge.tail == static_cast<int>(at) ? hinge.head : hinge.tail;
        if (is_one_line(line, hinge) && bodies.insert(other).second) {
          waiting.push_back(other);
        }
      }
    }
    return bodies;
  }

  // The hinges of a body that may be on that line: of a housing of many shafts, few.
  std::span<const std::size_t> hinges_near(const Hinge& line, std::size_t body) const {
    const double slack = 4.0 * kParallelAxes * (length_ + farthest_);
    const std::vector<std::size_t>& hinges = hinges_at_[body];
    const auto mark = [this](std::size_t h) { return hinges_[h].mark; };
    const auto begin = std::ranges::lower_bound(hinges, line.mark - slack, {}, mark);
    const auto end = std::ranges::upper_bound(hinges, line.mark + slack, {}, mark);
    return {begin, end};
  }

  double length_;
  double farthest_ = 0.0;  // of all points from the origin
  std::vector<Hinge> hinges_;
  std::vector<std::vector<std::size_t>> hinges_at_;  // of each body, by their marks
};

}  // namespace

std::vector<Mesh> find_meshes(const Topology& topology, const Geometry& geometry) {
  std::vector<Mesh> meshes;
  if (std::ranges::none_of(topology.couplings, is_mesh, &CouplingTopology::type)) {
    return meshes;
  }
  const CarrierSearch search(topology, geometry);
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.coupling(CouplingId{e});
    if (is_mesh(coupling.type)) {
      meshes.push_back({.coupling = CouplingId{e},
                        .carrier = search.carrier_of(coupling.tail.value, coupling.head.value)});
    }
  }
  return meshes;
}

}  // namespace kinestat
