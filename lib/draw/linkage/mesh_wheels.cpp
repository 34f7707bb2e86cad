#include <algorithm>
#include <limits>

#include "core/tolerance.hpp"
#include "draw/linkage/linkage_parts.hpp"
#include "mechanism/gears/mesh.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

// A line about which a body turns.
struct HingeLine {
  CouplingId coupling;
  Vec3 point = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();
};

class WheelFinder {
 public:
  WheelFinder(const MechanismDescription& description, const Mechanism& mechanism)
      : description_(description), mechanism_(mechanism) {}

  std::vector<MeshWheels> find() const {
    std::vector<MeshWheels> result;
    for (const Mesh& mesh : find_meshes(mechanism_.topology, mechanism_.geometry)) {
      result.push_back(wheels_of(mesh.coupling, mesh.carrier));
    }
    for (int e = 0; e < mechanism_.topology.coupling_count(); ++e) {
      const CouplingType type = mechanism_.topology.coupling(CouplingId{e}).type;
      if (type == rack || type == worm) {
        result.push_back(wheels_of(CouplingId{e}, std::nullopt));
      }
    }
    return result;
  }

 private:
  MeshWheels wheels_of(CouplingId coupling, std::optional<BodyId> carrier) const {
    const CouplingTopology& joined = mechanism_.topology.coupling(coupling);
    MeshWheels result{.coupling = coupling,
                      .tail = wheel_of(coupling, joined.tail, carrier),
                      .head = wheel_of(coupling, joined.head, carrier)};
    const auto& written = description_.couplings[static_cast<std::size_t>(coupling.value)];
    if (written.internal && result.tail && result.head) {
      Wheel& larger = result.tail->radius > result.head->radius ? *result.tail : *result.head;
      larger.kind = WheelKind::ring;
    }
    return result;
  }

  std::optional<Wheel> wheel_of(CouplingId mesh, BodyId body, std::optional<BodyId> carrier) const {
    const Vec3 pitch_point = mechanism_.geometry.points[static_cast<std::size_t>(mesh.value)];
    std::optional<Wheel> best;
    int best_rank = std::numeric_limits<int>::max();
    for (const HingeLine& line : lines_of(body)) {
      const int rank = rank_of(line, body, carrier);
      const Vec3 arm = pitch_point - line.point;
      const Vec3 across = arm - arm.dot(line.direction) * line.direction;
      const bool is_better =
          rank < best_rank || (rank == best_rank && best && across.norm() < best->radius);
      if (is_better && across.norm() > kZeroAxis * mechanism_.geometry.length) {
        best_rank = rank;
        best = Wheel{.body = body,
                     .at = mesh,
                     .kind = WheelKind::gear,
                     .centre = pitch_point - across,
                     .axis = line.direction,
                     .radius = across.norm()};
      }
    }
    return best;
  }

  // 0: joined to the carrier; 1: on a line of the carrier; 2: neither.
  int rank_of(const HingeLine& line, BodyId body, std::optional<BodyId> carrier) const {
    if (!carrier) {
      return 2;
    }
    const CouplingTopology& hinge = mechanism_.topology.coupling(line.coupling);
    const BodyId other = hinge.tail == body ? hinge.head : hinge.tail;
    if (other == *carrier) {
      return 0;
    }
    const std::vector<HingeLine> lines = lines_of(*carrier);
    const bool is_shared = std::ranges::any_of(lines, [&](const HingeLine& of_carrier) {
      const Vec3 between = of_carrier.point - line.point;
      return between.cross(line.direction).norm() <= kDrawnTogether * mechanism_.geometry.length;
    });
    return is_shared ? 1 : 2;
  }

  std::vector<HingeLine> lines_of(BodyId body) const {
    std::vector<HingeLine> lines;
    const Topology& topology = mechanism_.topology;
    for (int e = 0; e < topology.coupling_count(); ++e) {
      const CouplingTopology& hinge = topology.coupling(CouplingId{e});
      if (!is_hinge(hinge.type) || (hinge.tail != body && hinge.head != body)) {
        continue;
      }
      for (int f = hinge.first_freedom; f < hinge.first_freedom + hinge.freedom_count; ++f) {
        if (topology.freedoms[static_cast<std::size_t>(f)].is_rotation) {
          lines.push_back(
              {.coupling = CouplingId{e},
               .point = mechanism_.geometry.points[static_cast<std::size_t>(e)],
               .direction = mechanism_.geometry.motions[static_cast<std::size_t>(f)].angular});
          break;
        }
      }
    }
    return lines;
  }

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
};

}  // namespace

std::vector<MeshWheels> find_mesh_wheels(const MechanismDescription& description,
                                         const Mechanism& mechanism) {
  return WheelFinder(description, mechanism).find();
}

}  // namespace kinestat
