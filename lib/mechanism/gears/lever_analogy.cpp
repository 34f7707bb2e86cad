#include "mechanism/gears/lever_analogy.hpp"

#include <algorithm>
#include <optional>

#include "core/tolerance.hpp"
#include "graph/components.hpp"
#include "mechanism/gears/mesh.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

namespace {

struct Line {
  Vec3 direction = Vec3::UnitZ();
  Vec3 point = Vec3::Zero();
};

// A gear that turns in the carrier of a set.
struct SetGear {
  int body = 0;
  Line line;
  std::optional<double> speed;  // relative to the carrier; of the first gear 1
};

class LeverSearch {
 public:
  LeverSearch(const Topology& topology, const Geometry& geometry)
      : topology_(topology),
        geometry_(geometry),
        meshes_(find_meshes(topology, geometry)),
        lines_(topology.bodies.size()) {
    for (const CouplingTopology& coupling : topology.couplings) {
      add_lines(coupling);
    }
  }

  std::vector<Lever> run() const {
    std::vector<Lever> levers;
    for (const std::vector<int>& set : sets()) {
      if (std::optional<Lever> lever = lever_of(set)) {
        levers.push_back(*std::move(lever));
      }
    }
    return levers;
  }

 private:
  const CouplingTopology& coupling(const Mesh& mesh) const {
    return topology_.coupling(mesh.coupling);
  }

  // The lines about which the bodies of a coupling may turn against each other.
  void add_lines(const CouplingTopology& coupling) {
    if (!is_hinge(coupling.type)) {
      return;
    }
    for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
      const auto i = static_cast<std::size_t>(f);
      const auto axis = find_axis(geometry_.motions[i], geometry_.length);
      if (topology_.freedoms[i].is_rotation && axis && axis->point) {
        const Line line = {.direction = axis->direction, .point = *axis->point};
        lines_[static_cast<std::size_t>(coupling.tail.value)].push_back(line);
        lines_[static_cast<std::size_t>(coupling.head.value)].push_back(line);
      }
    }
  }

  bool is_one_line(const Line& a, const Line& b) const {
    const Vec3 between = b.point - a.point;
    return a.direction.cross(b.direction).norm() <= kParallelAxes &&
           between.cross(a.direction).norm() <= kParallelAxes * geometry_.length;
  }

  // On which both have hinges.
  std::optional<Line> common_line(int a, int b) const {
    for (const Line& line : lines_[static_cast<std::size_t>(a)]) {
      for (const Line& other : lines_[static_cast<std::size_t>(b)]) {
        if (is_one_line(line, other)) {
          return line;
        }
      }
    }
    return std::nullopt;
  }

  // Meshes in one moving carrier that hang together by their gears, as indices into meshes_.
  std::vector<std::vector<int>> sets() const {
    Digraph joined{.vertex_count = static_cast<int>(meshes_.size()), .edges = {}};
    for (int m = 0; m < joined.vertex_count; ++m) {
      for (int n = 0; n < m; ++n) {
        if (are_joined(meshes_[static_cast<std::size_t>(m)],
                       meshes_[static_cast<std::size_t>(n)])) {
          joined.edges.push_back({.tail = n, .head = m});
        }
      }
    }
    return find_components(joined);
  }

  bool are_joined(const Mesh& a, const Mesh& b) const {
    const CouplingTopology& one = coupling(a);
    const CouplingTopology& other = coupling(b);
    return a.carrier && a.carrier == b.carrier &&
           (one.tail == other.tail || one.tail == other.head || one.head == other.tail ||
            one.head == other.head);
  }

  std::optional<Lever> lever_of(const std::vector<int>& set) const {
    const std::optional<BodyId> carrier = meshes_[static_cast<std::size_t>(set.front())].carrier;
    if (!carrier || carrier->value == 0) {
      return std::nullopt;
    }
    std::vector<SetGear> gears = gears_of(set, carrier->value);
    if (gears.empty() || !find_speeds(set, gears)) {
      return std::nullopt;
    }
    const std::optional<Line> main = main_line(gears, carrier->value);
    return main ? std::optional(make_lever(*carrier, *main, gears)) : std::nullopt;
  }

  // Empty if a gear has no axis in the carrier.
  std::vector<SetGear> gears_of(const std::vector<int>& set, int carrier) const {
    std::vector<SetGear> gears;
    for (const int m : set) {
      const CouplingTopology& mesh = coupling(meshes_[static_cast<std::size_t>(m)]);
      for (const int body : {mesh.tail.value, mesh.head.value}) {
        if (find(gears, body) != nullptr) {
          continue;
        }
        const std::optional<Line> line = common_line(body, carrier);
        if (!line) {
          return {};
        }
        gears.push_back({.body = body, .line = *line, .speed = std::nullopt});
      }
    }
    return gears;
  }

  static SetGear* find(std::vector<SetGear>& gears, int body) {
    const auto at = std::ranges::find(gears, body, &SetGear::body);
    return at == gears.end() ? nullptr : &*at;
  }

  // False where teeth on one point cannot roll: then speeds do not depend on each other so.
  bool find_speeds(const std::vector<int>& set, std::vector<SetGear>& gears) const {
    gears.front().speed = 1.0;
    // A mesh after the other gives the speed of one gear more.
    for (std::size_t round = 0; round < set.size(); ++round) {
      for (const int m : set) {
        const CouplingTopology& mesh = coupling(meshes_[static_cast<std::size_t>(m)]);
        SetGear& tail = *find(gears, mesh.tail.value);
        SetGear& head = *find(gears, mesh.head.value);
        const Vec3& point = geometry_.points[static_cast<std::size_t>(
            meshes_[static_cast<std::size_t>(m)].coupling.value)];
        if (tail.speed && !head.speed) {
          head.speed = rolled(tail, head, point);
        } else if (head.speed && !tail.speed) {
          tail.speed = rolled(head, tail, point);
        }
      }
    }
    return std::ranges::all_of(gears, [](const SetGear& gear) { return gear.speed.has_value(); });
  }

  // The speed of a gear whose teeth move with those of another at the pitch point:
  // ω e × (p - a) is the same for both.
  std::optional<double> rolled(const SetGear& from, const SetGear& to, const Vec3& at) const {
    const Vec3 given = *from.speed * from.line.direction.cross(Vec3(at - from.line.point));
    const Vec3 unit = to.line.direction.cross(Vec3(at - to.line.point));
    const double size = unit.squaredNorm();
    if (size == 0.0) {
      return std::nullopt;
    }
    return given.dot(unit) / size;
  }

  bool has_line(int body, const Line& line) const {
    return std::ranges::any_of(lines_[static_cast<std::size_t>(body)],
                               [&](const Line& one) { return is_one_line(one, line); });
  }

  // Where at least two gears and the carrier turn: of several lines that on which the ground has a
  // bearing too, for planets may share a pin.
  std::optional<Line> main_line(const std::vector<SetGear>& gears, int carrier) const {
    std::optional<Line> found;
    for (const SetGear& gear : gears) {
      const auto is_here = [&](const SetGear& other) { return is_one_line(gear.line, other.line); };
      const bool is_main =
          has_line(carrier, gear.line) && std::ranges::count_if(gears, is_here) > 1;
      if (is_main && has_line(0, gear.line)) {
        return gear.line;
      }
      if (is_main && !found) {
        found = gear.line;
      }
    }
    return found;
  }

  Lever make_lever(BodyId carrier, const Line& main, const std::vector<SetGear>& gears) const {
    Lever lever = {.carrier = carrier, .axis = main.direction, .nodes = {}};
    lever.nodes.push_back({.body = carrier, .place = 0.0});
    for (const SetGear& gear : gears) {
      if (is_one_line(gear.line, main)) {
        const double sense = gear.line.direction.dot(main.direction) < 0.0 ? -1.0 : 1.0;
        lever.nodes.push_back({.body = BodyId{gear.body}, .place = sense * *gear.speed});
      }
    }
    std::ranges::stable_sort(lever.nodes, {}, &LeverNode::place);
    return lever;
  }

  const Topology& topology_;
  const Geometry& geometry_;
  std::vector<Mesh> meshes_;
  std::vector<std::vector<Line>> lines_;  // of each body
};

}  // namespace

std::vector<Lever> find_levers(const Topology& topology, const Geometry& geometry) {
  return LeverSearch(topology, geometry).run();
}

}  // namespace kinestat
