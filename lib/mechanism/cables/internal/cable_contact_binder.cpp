#include "mechanism/cables/internal/cable_contact_binder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "mechanism/cables/capstan.hpp"
#include "mechanism/cables/internal/cable_station_binder.hpp"

namespace kinestat {

namespace {

// What one cable has become.
struct Route {
  std::vector<CouplingId> segments;
  std::vector<CableSpan> spans;
  std::vector<CableStationGeometry> stations;
  std::map<std::size_t, CouplingId> links;  // revolute couplings of virtual links, by station
};

class ContactBinder {
 public:
  ContactBinder(const MechanismDescription& description,
                Evaluator& evaluator,
                Diagnostics& found,
                Mechanism& mechanism)
      : description_(description),
        evaluator_(evaluator),
        found_(found),
        mechanism_(mechanism),
        routes_(description.cables.size()) {}

  void run() {
    for (std::size_t e = 0; e < description_.couplings.size(); ++e) {
      if (description_.couplings[e].part != nullptr) {
        add_part(*description_.couplings[e].part, CouplingId{static_cast<int>(e)});
      }
    }
    for (std::size_t c = 0; c < routes_.size(); ++c) {
      const CableDescription& cable = description_.cables[c];
      for (std::size_t i = 0; i < cable.over.size(); ++i) {
        if (cable.over[i].is_pulley) {
          bind_station_of(cable, routes_[c], i);
        }
      }
    }
  }

 private:
  void add_part(const CablePart& part, CouplingId id) {
    Route& route = routes_[static_cast<std::size_t>(part.cable)];
    if (part.segment == 0) {
      route.links.emplace(static_cast<std::size_t>(part.station), id);
      return;
    }
    const auto from = bind_station<double>(part.from, evaluator_);
    const auto to = bind_station<double>(part.to, evaluator_);
    if (!from || !to) {
      return;  // not so: the route has been checked
    }
    route.segments.push_back(id);
    route.stations.push_back(*from);
    route.spans.push_back(tangent_span<double>(*from, *to));
    const CableDescription& cable = description_.cables[static_cast<std::size_t>(part.cable)];
    if (!cable.closed && part.segment == segment_count(cable)) {
      route.stations.push_back(*to);
    }
  }

  // The segment that leaves station i has its index; the one before it arrives.
  void bind_station_of(const CableDescription& cable, const Route& route, std::size_t i) {
    const CableStation& station = cable.over[i];
    const CableStationGeometry& pulley = route.stations[i];
    const std::size_t count = route.segments.size();
    const bool has_before = cable.closed || i > 0;
    const bool has_after = i < count;
    const std::size_t before = (i + count - 1) % count;
    CableFriction drag;
    if (has_before) {
      drag.arrives = route.segments[before];
    }
    if (has_after) {
      drag.leaves = route.segments[i];
    }
    std::optional<double> wrap;
    if (has_before && has_after && pulley.radius != 0.0) {
      wrap = wrap_angle<double>(pulley, route.spans[before], route.spans[i]) +
             2.0 * std::numbers::pi * number(station.turns).value_or(0.0);
    }
    const auto link = route.links.find(i);
    const std::optional<CouplingId> slips =
        link == route.links.end() ? std::nullopt : std::optional(link->second);
    const std::optional<double> mu = number(station.friction);
    const double eta = number(station.eta).value_or(1.0);
    if (has_before && has_after) {
      mechanism_.contacts.push_back({.name = name_of(cable, station, slips),
                                     .arrives = *drag.arrives,
                                     .leaves = *drag.leaves,
                                     .slips = slips,
                                     .radius = pulley.radius,
                                     .wrap = wrap,
                                     .friction = mu,
                                     .efficiency = eta,
                                     .where = station.where});
    }
    if ((mu.value_or(0.0) > 0.0 || eta < 1.0) && !check_sense(station)) {
      return;
    }
    const double held = capstan_ratio(mu.value_or(0.0), wrap.value_or(0.0));
    if (!std::isfinite(held)) {
      found_.error("E0316",
                   station.where,
                   fmt::format("the tensions that friction holds on pulley '{}' have a ratio of "
                               "exp({:.6g}), which is too large for a number",
                               station.body.text,
                               *mu * *wrap),
                   "give fewer turns or less friction");
      return;
    }
    // Friction acts where the cable slips; elsewhere it is a limit.
    drag.radius = pulley.radius;
    drag.ratio = (slips ? held : 1.0) / eta;
    drag.slips = slips.has_value();
    if (drag.ratio > 1.0) {
      add_friction(station, pulley, slips, drag);
    }
    if (slips && eta < 1.0) {
      drag.ratio = 1.0 / eta;
      drag.slips = false;
      drag.unless_slip = slips;
      add_gripped(station, pulley, drag);
    }
  }

  std::optional<double> number(const std::optional<Value>& value) {
    return value ? evaluator_.number(*value, QuantityKind::dimensionless) : std::nullopt;
  }

  std::string name_of(const CableDescription& cable,
                      const CableStation& station,
                      const std::optional<CouplingId>& slips) {
    std::string name = slips ? mechanism_.topology.coupling(*slips).name
                             : fmt::format("{}_{}", cable.name.text, station.body.text);
    const std::string first = name;
    for (int again = 2; !names_.insert(name).second; ++again) {
      name = fmt::format("{}_{}", first, again);
    }
    return name;
  }

  // Points alone do not say in which sense the cable turns, nor at which radius.
  bool check_sense(const CableStation& station) {
    if (station.radius && station.wrap) {
      return true;
    }
    found_.error(
        "E0314",
        station.where,
        fmt::format("pulley '{}' has friction, but no 'radius' and 'wrap'", station.body.text),
        "add them to its 'points', or remove 'friction' and 'eta'");
    return false;
  }

  void add_friction(const CableStation& station,
                    const CableStationGeometry& pulley,
                    const std::optional<CouplingId>& slips,
                    const CableFriction& drag) {
    const std::vector<CouplingId> bearings =
        slips ? std::vector<CouplingId>{*slips} : find_bearings(station, pulley);
    if (bearings.size() > 1) {
      found_.error("E0314",
                   station.where,
                   fmt::format("pulley '{}' has an 'eta', but turns on '{}' and on '{}'",
                               station.body.text,
                               mechanism_.topology.coupling(bearings[0]).name,
                               mechanism_.topology.coupling(bearings[1]).name),
                   "remove 'eta', and give the coupling that has friction its own 'friction:'");
      return;
    }
    if (bearings.empty()) {
      found_.error(
          "E0314",
          station.where,
          fmt::format("pulley '{}' has an 'eta', but turns on no revolute coupling at its centre",
                      station.body.text),
          "add the coupling on which it turns, or remove 'eta'");
      return;
    }
    add_drag(station, pulley, bearings.front(), drag);
  }

  // Of a cable that may slip: what holds the pulley back where it turns with its cable. A pulley
  // that turns on nothing, or nobody knows on what, is a post.
  void add_gripped(const CableStation& station,
                   const CableStationGeometry& pulley,
                   const CableFriction& drag) {
    if (station.body.text == description_.ground.text) {
      return;
    }
    const std::vector<CouplingId> bearings = find_bearings(station, pulley);
    if (bearings.size() == 1) {
      add_drag(station, pulley, bearings.front(), drag);
      mechanism_.contacts.back().turns = true;
    }
  }

  void add_drag(const CableStation& station,
                const CableStationGeometry& pulley,
                CouplingId coupling,
                CableFriction drag) {
    const CouplingTopology& turns_on = mechanism_.topology.coupling(coupling);
    const bool is_head =
        drag.slips || mechanism_.topology.body(turns_on.head).name == station.body.text;
    const double along = axis_of(turns_on).dot(pulley.axis);
    drag.radius *= (along > 0.0 ? 1.0 : -1.0) * (is_head ? 1.0 : -1.0);
    auto& frictions = mechanism_.frictions;
    auto at = std::ranges::find(frictions, coupling, &CouplingFriction::coupling);
    if (at == frictions.end()) {
      CouplingFriction friction;
      friction.coupling = coupling;
      friction.where = station.where;
      at = frictions.insert(frictions.end(), friction);
    }
    at->cables.push_back(drag);
  }

  Vec3 axis_of(const CouplingTopology& coupling) const {
    return mechanism_.geometry.motions[static_cast<std::size_t>(coupling.first_freedom)].angular;
  }

  // On which the pulley turns, at its centre.
  std::vector<CouplingId> find_bearings(const CableStation& station,
                                        const CableStationGeometry& pulley) const {
    std::vector<CouplingId> found;
    const Topology& topology = mechanism_.topology;
    for (int e = 0; e < topology.coupling_count(); ++e) {
      const CouplingTopology& coupling = topology.coupling(CouplingId{e});
      const bool is_of_pulley = topology.body(coupling.tail).name == station.body.text ||
                                topology.body(coupling.head).name == station.body.text;
      if (coupling.type != CouplingType::revolute || !is_of_pulley ||
          description_.couplings[static_cast<std::size_t>(e)].part != nullptr) {
        continue;
      }
      const Vec3 axis = axis_of(coupling);
      const Vec3 arm = mechanism_.geometry.points[static_cast<std::size_t>(e)] - pulley.centre;
      if (axis.cross(pulley.axis).norm() <= kParallelAxes &&
          arm.cross(pulley.axis).norm() <= kGrazing * std::abs(pulley.radius)) {
        found.push_back(CouplingId{e});
      }
    }
    return found;
  }

  const MechanismDescription& description_;
  Evaluator& evaluator_;
  Diagnostics& found_;
  Mechanism& mechanism_;
  std::vector<Route> routes_;
  std::set<std::string> names_;
};

}  // namespace

void bind_contacts(const MechanismDescription& description,
                   Evaluator& evaluator,
                   Diagnostics& found,
                   Mechanism& mechanism) {
  if (!description.cables.empty()) {
    ContactBinder(description, evaluator, found, mechanism).run();
  }
}

}  // namespace kinestat
