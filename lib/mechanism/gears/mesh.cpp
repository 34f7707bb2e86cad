#include "mechanism/gears/mesh.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "graph/components.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

namespace {

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

// Bodies that turn with or against each other about one line, joined by hinges on it, are a group.
// A carrier turns about one line with the one gear and about another with the other.
class CarrierSearch {
 public:
  CarrierSearch(const Topology& topology, const Geometry& geometry)
      : length_(geometry.length),
        hinges_at_(topology.bodies.size()),
        groups_at_(topology.bodies.size()),
        reach_(topology.bodies.size(), 0) {
    for (const CouplingTopology& coupling : topology.couplings) {
      if (is_hinge(coupling.type)) {
        add(coupling, topology, geometry);
      }
    }
    find_groups();
  }

  std::optional<BodyId> carrier_of(int first, int second) const {
    const bool is_first_near = at(reach_, first) <= at(reach_, second);
    const int near = is_first_near ? first : second;
    const int far = is_first_near ? second : first;
    std::optional<BodyId> found;
    for (const int group : at(groups_at_, near)) {
      for (const int body : at(members_, group)) {
        const bool is_known = body == near || body == far || (found && found->value == body);
        if (is_known || !turns_about_another_line(body, far, group)) {
          continue;
        }
        if (found) {
          return std::nullopt;
        }
        found = BodyId{body};
      }
    }
    return found;
  }

 private:
  template <class T>
  static T& at(std::vector<T>& values, int i) {
    return values[static_cast<std::size_t>(i)];
  }

  template <class T>
  static const T& at(const std::vector<T>& values, int i) {
    return values[static_cast<std::size_t>(i)];
  }

  void add(const CouplingTopology& coupling, const Topology& topology, const Geometry& geometry) {
    for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
      const auto i = static_cast<std::size_t>(f);
      const std::optional<ScrewAxis> axis = find_axis(geometry.motions[i], geometry.length);
      if (topology.freedoms[i].is_rotation && axis && axis->point) {
        at(hinges_at_, coupling.tail.value).push_back(static_cast<int>(hinges_.size()));
        at(hinges_at_, coupling.head.value).push_back(static_cast<int>(hinges_.size()));
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

  void find_groups() {
    Digraph joined{.vertex_count = static_cast<int>(hinges_.size()), .edges = {}};
    for (std::vector<int>& hinges : hinges_at_) {
      join_lines(hinges, joined);
    }
    for (const std::vector<int>& hinges : find_components(joined)) {
      std::vector<int> bodies;
      for (const int h : hinges) {
        bodies.push_back(at(hinges_, h).tail);
        bodies.push_back(at(hinges_, h).head);
      }
      std::ranges::sort(bodies);
      bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
      members_.push_back(std::move(bodies));
      line_of_.push_back(hinges.front());
    }
    for (int group = 0; group < static_cast<int>(members_.size()); ++group) {
      for (const int body : at(members_, group)) {
        at(groups_at_, body).push_back(group);
        at(reach_, body) += at(members_, group).size();
      }
    }
  }

  // Joins the hinges of one body that lie on one line. Sorted by their marks, each need be compared
  // only with the first of each line near it: of many shafts in a housing, few.
  void join_lines(std::vector<int>& hinges, Digraph& joined) const {
    const double slack = 4.0 * kParallelAxes * (length_ + farthest_);
    std::ranges::sort(hinges, {}, [this](int h) { return at(hinges_, h).mark; });
    std::vector<int> lines;
    for (const int h : hinges) {
      const Hinge& hinge = at(hinges_, h);
      auto line = lines.rbegin();
      while (line != lines.rend() && at(hinges_, *line).mark >= hinge.mark - slack &&
             !is_one_line(at(hinges_, *line), hinge)) {
        ++line;
      }
      if (line != lines.rend() && at(hinges_, *line).mark >= hinge.mark - slack) {
        joined.edges.push_back({.tail = *line, .head = h});
      } else {
        lines.push_back(h);
      }
    }
  }

  // Whether both are in a group on another line than that of `group`.
  bool turns_about_another_line(int body, int other, int group) const {
    const std::vector<int>& a = at(groups_at_, body);
    const std::vector<int>& b = at(groups_at_, other);
    const std::vector<int>& shorter = a.size() <= b.size() ? a : b;
    const std::vector<int>& longer = a.size() <= b.size() ? b : a;
    return std::ranges::any_of(shorter, [&](int shared) {
      return std::ranges::binary_search(longer, shared) &&
             !is_one_line(at(hinges_, at(line_of_, group)), at(hinges_, at(line_of_, shared)));
    });
  }

  double length_;
  double farthest_ = 0.0;  // of all points from the origin
  std::vector<Hinge> hinges_;
  std::vector<std::vector<int>> hinges_at_;  // of each body, by their marks
  std::vector<std::vector<int>> members_;    // of each group: its bodies, ascending
  std::vector<int> line_of_;                 // of each group: one of its hinges
  std::vector<std::vector<int>> groups_at_;  // of each body, ascending
  std::vector<std::size_t> reach_;           // of each body: the members of its groups
};

}  // namespace

bool is_hinge(CouplingType type) {
  return kind_of(type).is_hinge;
}

std::vector<Mesh> find_meshes(const Topology& topology, const Geometry& geometry) {
  std::vector<Mesh> meshes;
  if (std::ranges::none_of(topology.couplings, joins_wheels, &CouplingTopology::type)) {
    return meshes;
  }
  const CarrierSearch search(topology, geometry);
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.coupling(CouplingId{e});
    if (joins_wheels(coupling.type)) {
      meshes.push_back({.coupling = CouplingId{e},
                        .carrier = search.carrier_of(coupling.tail.value, coupling.head.value)});
    }
  }
  return meshes;
}

}  // namespace kinestat
