#include "description/cable_expansion.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace kinestat {

namespace {

class CableExpansion {
 public:
  explicit CableExpansion(MechanismDescription& description) : description_(description) {
    bodies_.insert(description.ground.text);
    for (const BodyDescription& body : description.bodies) {
      bodies_.insert(body.name.text);
    }
    declared_ = bodies_;
    for (std::size_t i = 0; i < description.couplings.size(); ++i) {
      const CouplingDescription& coupling = description.couplings[i];
      taken_.insert(coupling.name.text);
      if (coupling.type == CouplingType::revolute) {
        bearings_.emplace(coupling.tail.text, i);
        bearings_.emplace(coupling.head.text, i);
      }
    }
    bearings_.erase(description.ground.text);  // which turns on none of them
    for (const ActuatorDescription& actuator : description.actuators) {
      taken_.insert(actuator.name.text);
    }
    if (description.gears) {
      for (const MeshDescription& mesh : description.gears->meshes) {
        taken_.insert(mesh.name.text);  // also those that are wrong and became no couplings
      }
    }
  }

  void run() {
    for (std::size_t i = 0; i < description_.cables.size(); ++i) {
      expand(static_cast<int>(i));
    }
  }

 private:
  void expand(int index) {
    const CableDescription& cable = description_.cables[static_cast<std::size_t>(index)];
    const std::vector<VirtualLink> links = virtual_links(cable);
    std::vector<CableStation> stations;
    for (const CableStation& station : cable.over) {
      stations.push_back(resolve(station));
    }
    if (!is_complete(cable, stations) || !take_names(cable, links)) {
      return;
    }
    std::vector<Name> ends;  // the body to which segments are fixed at each station
    for (const CableStation& station : stations) {
      ends.push_back(station.body);
    }
    for (const VirtualLink& link : links) {
      ends[link.station].text = link.name;
    }
    for (int segment = 1; segment <= segment_count(cable); ++segment) {
      add_segment(index, segment, stations, ends);
    }
    for (const VirtualLink& link : links) {
      add_link(index, link, stations[link.station]);
    }
  }

  // The centre and the axis of a pulley are those of the first revolute coupling of its body. In
  // the plane the axis is z.
  CableStation resolve(CableStation station) const {
    const auto bearing = bearings_.find(station.body.text);
    if (!station.is_pulley || bearing == bearings_.end()) {
      return station;
    }
    const CouplingDescription& coupling = description_.couplings[bearing->second];
    if (!station.at && coupling.at) {
      station.at = coupling.at->of_bodies.empty() ? coupling.at->point : point_on_tail(coupling);
    }
    if (!station.axis && description_.space == Space::spatial) {
      station.axis = coupling.axis;
    }
    return station;
  }

  static std::optional<PointDescription> point_on_tail(const CouplingDescription& coupling) {
    for (const auto& [body, point] : coupling.at->of_bodies) {
      if (body.text == coupling.tail.text) {
        return point;
      }
    }
    return std::nullopt;
  }

  bool is_complete(const CableDescription& cable, const std::vector<CableStation>& stations) const {
    for (int segment = 1; segment <= segment_count(cable); ++segment) {
      const CableStation& from = stations[static_cast<std::size_t>(segment) - 1];
      const CableStation& to = stations[end_station(cable, segment)];
      if (is_same_end(from, to)) {
        return false;
      }
    }
    return std::ranges::all_of(stations, [&](const CableStation& station) {
      const bool needs_centre = !station.is_pulley || station.points.empty() || station.slip;
      return declared_.contains(station.body.text) && (station.at || !needs_centre);
    });
  }

  // Whether all names that the cable makes are free; they are not any more.
  bool take_names(const CableDescription& cable, const std::vector<VirtualLink>& links) {
    std::set<std::string> couplings;
    for (int segment = 1; segment <= segment_count(cable); ++segment) {
      couplings.insert(segment_name(cable, segment));
    }
    const std::size_t segments = couplings.size();
    for (const VirtualLink& link : links) {
      couplings.insert(link.name);
      if (bodies_.contains(link.name)) {
        return false;
      }
    }
    const auto is_taken = [&](const std::string& name) { return taken_.contains(name); };
    if (couplings.size() < segments + links.size() || std::ranges::any_of(couplings, is_taken)) {
      return false;
    }
    taken_.merge(couplings);
    for (const VirtualLink& link : links) {
      bodies_.insert(link.name);
    }
    return true;
  }

  void add_segment(int index,
                   int segment,
                   const std::vector<CableStation>& stations,
                   const std::vector<Name>& ends) {
    const CableDescription& cable = description_.cables[static_cast<std::size_t>(index)];
    const std::size_t from = static_cast<std::size_t>(segment) - 1;
    const std::size_t to = end_station(cable, segment);
    CouplingDescription coupling;
    coupling.name = {.text = segment_name(cable, segment), .where = cable.name.where};
    coupling.type = CouplingType::cable;
    coupling.tail = ends[from];
    coupling.head = ends[to];
    coupling.part = std::make_shared<const CablePart>(CablePart{.cable = index,
                                                                .segment = segment,
                                                                .station = static_cast<int>(from),
                                                                .from = stations[from],
                                                                .to = stations[to]});
    description_.couplings.push_back(std::move(coupling));
  }

  // Its velocity is reported at the centre of the pulley.
  void add_link(int index, const VirtualLink& link, const CableStation& pulley) {
    BodyDescription body;
    body.name = {.text = link.name, .where = pulley.body.where};
    body.reference = pulley.at;
    body.is_virtual = true;
    CouplingDescription coupling;
    coupling.name = body.name;
    coupling.type = CouplingType::revolute;
    coupling.tail = pulley.body;
    coupling.head = body.name;
    coupling.at = CouplingPoint{
        .point = pulley.at, .of_bodies = {}, .along_axis = {}, .where = pulley.at->where};
    coupling.axis = pulley.axis;
    if (!coupling.axis && description_.space == Space::spatial) {
      coupling.axis =
          AxisDescription{.keyword = 'z', .sign = 1.0, .components = {}, .where = pulley.where};
    }
    coupling.part =
        std::make_shared<const CablePart>(CablePart{.cable = index,
                                                    .segment = 0,
                                                    .station = static_cast<int>(link.station),
                                                    .from = pulley,
                                                    .to = {}});
    description_.bodies.push_back(std::move(body));
    description_.couplings.push_back(std::move(coupling));
  }

  MechanismDescription& description_;
  std::set<std::string> declared_;               ///< bodies of the file
  std::set<std::string> bodies_;                 ///< and virtual links
  std::set<std::string> taken_;                  ///< names of couplings and actuators
  std::map<std::string, std::size_t> bearings_;  ///< the first revolute of each body
};

}  // namespace

void expand_cables(MechanismDescription& description) {
  if (!description.cables.empty() && description.has_mechanism()) {
    CableExpansion(description).run();
  }
}

bool is_expanded(const MechanismDescription& description) {
  std::set<int> expanded;
  for (const CouplingDescription& coupling : description.couplings) {
    if (coupling.part != nullptr) {
      expanded.insert(coupling.part->cable);
    }
  }
  return expanded.size() == description.cables.size();
}

MechanismDescription without_cable_parts(const MechanismDescription& description) {
  MechanismDescription result = description;
  std::erase_if(result.couplings, [](const CouplingDescription& one) { return one.part; });
  std::erase_if(result.bodies, [](const BodyDescription& one) { return one.is_virtual; });
  return result;
}

}  // namespace kinestat
