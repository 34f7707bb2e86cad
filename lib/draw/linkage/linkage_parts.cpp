#include "draw/linkage/linkage_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "draw/linkage/file_numbers.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

class PartFinder {
 public:
  PartFinder(const MechanismDescription& description,
             const Mechanism& mechanism,
             std::span<const BodyPose> poses)
      : description_(description),
        mechanism_(mechanism),
        topology_(mechanism.topology),
        poses_(poses),
        numbers_(description, mechanism.geometry.origin) {
    result_.points.resize(topology_.bodies.size());
    result_.outlines.resize(topology_.bodies.size());
    result_.is_virtual.resize(topology_.bodies.size(), false);
  }

  LinkageParts find() {
    add_bodies();
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingDescription& written = description_.couplings[static_cast<std::size_t>(e)];
      if (topology_.coupling(CouplingId{e}).type == cable) {
        add_segment(CouplingId{e}, written);
      } else if (written.part == nullptr) {
        add_points(CouplingId{e});
      }
    }
    add_arcs();
    add_springs();
    for (const MeshWheels& mesh : find_mesh_wheels(description_, mechanism_)) {
      for (const auto* wheel : {&mesh.tail, &mesh.head}) {
        if (*wheel) {
          add_wheel(moved(**wheel));
        }
      }
    }
    return std::move(result_);
  }

 private:
  void add_bodies() {
    for (const BodyDescription& body : description_.bodies) {
      const auto at = std::ranges::find(topology_.bodies, body.name.text, &BodyTopology::name);
      if (at == topology_.bodies.end()) {
        continue;
      }
      const auto b = static_cast<std::size_t>(at - topology_.bodies.begin());
      result_.is_virtual[b] = body.is_virtual;
      for (const PointDescription& corner : body.outline) {
        if (const std::optional<Vec3> point = numbers_.point(corner)) {
          result_.outlines[b].push_back(moved(BodyId{static_cast<int>(b)}, *point));
        }
      }
    }
  }

  // Where a point of the body is that was drawn there.
  Vec3 moved(BodyId body, const Vec3& drawn) const {
    return poses_.empty() ? drawn : poses_[index(body.value)].point(drawn);
  }

  Wheel moved(Wheel wheel) const {
    wheel.centre = moved(wheel.body, wheel.centre);
    wheel.axis =
        poses_.empty() ? wheel.axis : poses_[index(wheel.body.value)].direction(wheel.axis);
    return wheel;
  }

  std::optional<CableStationGeometry> station_at(const CableStation& station) const {
    std::optional<CableStationGeometry> found = numbers_.station(station);
    if (!found || poses_.empty()) {
      return found;
    }
    const BodyPose& pose = poses_[index(body_named(station.body.text).value)];
    found->centre = pose.point(found->centre);
    found->axis = pose.direction(found->axis);
    for (auto* touch : {&found->meets, &found->leaves}) {
      if (*touch) {
        *touch = pose.point(**touch);
      }
    }
    return found;
  }

  BodyId body_named(std::string_view name) const {
    const auto at = std::ranges::find(topology_.bodies, name, &BodyTopology::name);
    return BodyId{at == topology_.bodies.end() ? 0
                                               : static_cast<int>(at - topology_.bodies.begin())};
  }

  void add_point(BodyId body, const Vec3& at, std::optional<CouplingId> coupling) {
    result_.points[static_cast<std::size_t>(body.value)].push_back(
        {.at = at, .coupling = coupling});
  }

  // A mesh of teeth is drawn by its wheels, so that its pitch point is no place of a link.
  void add_points(CouplingId id) {
    const CouplingTopology& coupling = topology_.coupling(id);
    const Vec3 at = mechanism_.geometry.points[static_cast<std::size_t>(id.value)];
    for (const BodyId body : {coupling.tail, coupling.head}) {
      const bool is_rack = coupling.type == rack && !turns(body);
      if (!has_teeth(coupling.type) || is_rack) {
        add_point(body, moved(body, at), id);
      }
    }
  }

  bool turns(BodyId body) const {
    return std::ranges::any_of(topology_.couplings, [body](const CouplingTopology& coupling) {
      return coupling.type == revolute && (coupling.tail == body || coupling.head == body);
    });
  }

  void add_wheel(const Wheel& wheel) {
    const double near = kDrawnTogether * mechanism_.geometry.length;
    const bool is_known = std::ranges::any_of(result_.wheels, [&](const Wheel& other) {
      return other.body == wheel.body && other.kind == wheel.kind &&
             (other.centre - wheel.centre).norm() <= near &&
             std::abs(other.radius - wheel.radius) <= near;
    });
    if (!is_known) {
      result_.wheels.push_back(wheel);
    }
  }

  void add_segment(CouplingId id, const CouplingDescription& written) {
    if (written.part == nullptr) {
      add_free_segment(id, written);
      return;
    }
    const auto from = station_at(written.part->from);
    const auto to = station_at(written.part->to);
    if (!from || !to) {
      return;
    }
    const CableSpan span = tangent_span<double>(*from, *to);
    result_.spans.push_back({.coupling = id, .from = span.from, .to = span.to});
    add_station(id, written.part->from, *from, span.from);
    add_station(id, written.part->to, *to, span.to);
    stations_[{written.part->cable, written.part->station}].leaves = span.from;
    const CableDescription& cable =
        description_.cables[static_cast<std::size_t>(written.part->cable)];
    const std::size_t end = end_station(cable, written.part->segment);
    stations_[{written.part->cable, static_cast<int>(end)}].meets = span.to;
  }

  void add_free_segment(CouplingId id, const CouplingDescription& written) {
    const CouplingTopology& coupling = topology_.coupling(id);
    const auto from = written.from ? numbers_.point(*written.from) : std::nullopt;
    const auto to = written.to ? numbers_.point(*written.to) : std::nullopt;
    if (from && to) {
      const Vec3 begin = moved(coupling.tail, *from);
      const Vec3 end = moved(coupling.head, *to);
      result_.spans.push_back({.coupling = id, .from = begin, .to = end});
      add_point(coupling.tail, begin, id);
      add_point(coupling.head, end, id);
    }
  }

  void add_station(CouplingId id,
                   const CableStation& station,
                   const CableStationGeometry& geometry,
                   const Vec3& touch) {
    const BodyId body = body_named(station.body.text);
    if (!station.is_pulley) {
      add_point(body, touch, id);
      return;
    }
    const double radius =
        geometry.radius != 0.0 ? std::abs(geometry.radius) : (touch - geometry.centre).norm();
    if (radius > 0.0 && station.at) {
      add_wheel({.body = body,
                 .at = id,
                 .kind = WheelKind::pulley,
                 .centre = geometry.centre,
                 .axis = geometry.axis,
                 .radius = radius});
    }
  }

  // Of each pulley between two segments.
  void add_arcs() {
    for (std::size_t c = 0; c < description_.cables.size(); ++c) {
      const CableDescription& cable = description_.cables[c];
      for (std::size_t i = 0; i < cable.over.size(); ++i) {
        const auto touched = stations_.find({static_cast<int>(c), static_cast<int>(i)});
        if (cable.over[i].is_pulley && touched != stations_.end() && touched->second.meets &&
            touched->second.leaves) {
          add_arc(cable, i, *touched->second.meets, *touched->second.leaves);
        }
      }
    }
  }

  // The station of a cable's own list may lack the centre that its parts have filled in.
  void add_arc(const CableDescription& cable, std::size_t i, const Vec3& from, const Vec3& to) {
    for (const CouplingDescription& written : description_.couplings) {
      const bool begins_here = written.is_segment() &&
                               &description_.cables[index(written.part->cable)] == &cable &&
                               index(written.part->station) == i;
      if (!begins_here) {
        continue;
      }
      const auto station = station_at(written.part->from);
      if (station && station->radius != 0.0) {
        result_.arcs.push_back({.body = body_named(cable.over[i].body.text),
                                .centre = station->centre,
                                .axis = station->axis,
                                .radius = std::abs(station->radius),
                                .from = from,
                                .to = to,
                                .is_positive = station->radius > 0.0});
      }
    }
  }

  void add_springs() {
    for (std::size_t s = 0; s < mechanism_.springs.size(); ++s) {
      const Spring& spring = mechanism_.springs[s];
      if (!spring.is_of_freedom()) {
        add_spring(s, spring.from, spring.to);
      } else if (!topology_.freedoms[index(spring.freedom)].is_rotation) {
        add_slide_spring(s);
      }
    }
  }

  void add_spring(std::size_t s, const Vec3& from, const Vec3& to) {
    const Spring& spring = mechanism_.springs[s];
    const SpringLine line = {.spring = s,
                             .from = moved(spring.tail, from),
                             .to = moved(spring.head, to),
                             .drawn = (to - from).norm()};
    result_.springs.push_back(line);
    add_point(spring.tail, line.from, std::nullopt);
    add_point(spring.head, line.to, std::nullopt);
  }

  // The file says not where it begins: away from the rest of its head.
  void add_slide_spring(std::size_t s) {
    constexpr double kLength = 0.25;  // of the mechanism
    const Spring& spring = mechanism_.springs[s];
    const auto f = index(spring.freedom);
    const Vec3 axis = mechanism_.geometry.motions[f].linear.normalized();
    const Vec3 at = mechanism_.geometry.points[index(topology_.freedoms[f].coupling.value)];
    double ahead = 0.0;
    for (std::size_t e = 0; e < topology_.couplings.size(); ++e) {
      const CouplingTopology& coupling = topology_.couplings[e];
      if (coupling.tail == spring.head || coupling.head == spring.head) {
        ahead += axis.dot(mechanism_.geometry.points[e] - at);
      }
    }
    const double away = (ahead < 0.0 ? 1.0 : -1.0) * kLength * mechanism_.geometry.length;
    add_spring(s, at + away * axis, at);
  }

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  struct Touch {
    std::optional<Vec3> meets;
    std::optional<Vec3> leaves;
  };

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  const Topology& topology_;
  std::span<const BodyPose> poses_;  // empty: as drawn
  FileNumbers numbers_;
  LinkageParts result_;
  std::map<std::pair<int, int>, Touch> stations_;  // by cable and station
};

}  // namespace

LinkageParts find_linkage_parts(const MechanismDescription& description,
                                const Mechanism& mechanism,
                                std::span<const BodyPose> poses) {
  return PartFinder(description, mechanism, poses).find();
}

}  // namespace kinestat
