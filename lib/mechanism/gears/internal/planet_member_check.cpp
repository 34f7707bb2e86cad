#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "description/gear_expansion.hpp"
#include "mechanism/gears/internal/gear_train_check.hpp"

namespace kinestat {

namespace {

class PlanetMemberCheck {
 public:
  PlanetMemberCheck(const SectionContext& context,
                    const GearTrain& train,
                    const GearNumbers& numbers)
      : context_(context), gears_(*context.description.gears), train_(train), numbers_(numbers) {}

  void run() {
    for (std::size_t p = 0; p < train_.axes.size(); ++p) {
      check_distance(p);
    }
    for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
      check_carrier(gears_.meshes[m], train_.first[m]);
      check_carrier(gears_.meshes[m], train_.second[m]);
    }
    for (std::size_t i = 0; i < gears_.members.size(); ++i) {
      check_words_of_planets(static_cast<int>(i));
      check_one_distance(static_cast<int>(i));
    }
  }

 private:
  const GearMember& member(int index) const {
    return gears_.members[static_cast<std::size_t>(index)];
  }

  int axis_of(int member) const { return train_.axis_of[static_cast<std::size_t>(member)]; }

  // What bears a body, and what is fixed to that.
  std::vector<std::string> holders_of(const std::string& body) const {
    std::vector<std::string> holders;
    const auto add = [&](const CouplingDescription& coupling, const std::string& from) {
      const Name& other = coupling.tail.text == from ? coupling.head : coupling.tail;
      const bool is_at = coupling.tail.text == from || coupling.head.text == from;
      if (is_at && !coupling.is_mesh() && other.text != body &&
          std::ranges::find(holders, other.text) == holders.end()) {
        holders.push_back(other.text);
      }
    };
    for (const CouplingDescription& coupling : context_.description.couplings) {
      add(coupling, body);
    }
    for (std::size_t i = 0; i < holders.size(); ++i) {
      const std::string holder = holders[i];
      for (const CouplingDescription& coupling : context_.description.couplings) {
        if (coupling.type == CouplingType::rigid) {
          add(coupling, holder);
        }
      }
    }
    return holders;
  }

  // Losses and positions follow from the body on which the planet really turns.
  void check_carrier(const MeshDescription& mesh, int index) {
    const int axis = axis_of(index);
    const std::string& body = member(index).body.text;
    const std::string& ground = context_.description.ground.text;
    const std::string& carrier = carrier_of(mesh, context_.description);
    const std::vector<std::string> holders = holders_of(body);
    if (axis < 0 || holders.empty()) {
      return;
    }
    const bool is_planet = train_.axes[at(axis)].carrier != ground;
    if (is_planet && is_idler_on_shaft(index, holders.front())) {
      refuse_idler(mesh, index, holders.front());
      return;
    }
    // A shaft beside the main axis may be the centre of a planetary set.
    const bool is_centre = !is_planet && carrier != ground && train_.axis_on(carrier) == axis;
    const bool is_borne = std::ranges::any_of(holders, [&](const std::string& holder) {
      return holder == carrier || (train_.axis_on(holder) == axis && holder != ground);
    });
    if (is_centre || is_borne) {
      return;
    }
    if (mesh.carrier) {
      context_.found.error("E0314",
                           mesh.carrier->where,
                           fmt::format("the carrier of mesh '{}' is '{}', but its planet '{}' "
                                       "turns on '{}'",
                                       mesh.name.text,
                                       carrier,
                                       member(index).name.text,
                                       holders.front()),
                           "name the body that bears the planet");
    } else {
      context_.found.error(
          "E0303",
          mesh.name.where,
          fmt::format("mesh '{}' needs a carrier: its planet '{}' turns on '{}', not on the ground",
                      mesh.name.text,
                      member(index).name.text,
                      holders.front()),
          fmt::format("add 'carrier: {0}'; or, if both turn about one axis, as an idler on its "
                      "shaft does, say so in 'axes' of 'gears': {{bodies: [{0}, {1}]}}",
                      holders.front(),
                      body));
    }
  }

  // A planet transmits what it takes from one gear to another, or to what its body drives. What
  // meshes once, turns on a shaft and is clutched to it alone is an idler of a lay shaft.
  bool is_idler_on_shaft(int index, const std::string& shaft) const {
    const std::string& body = member(index).body.text;
    const auto meshes = std::ranges::count_if(gears_.meshes, [&](const MeshDescription& mesh) {
      return is_on(mesh.first, body) || is_on(mesh.second, body);
    });
    bool is_clutched = false;
    for (const CouplingDescription& coupling : context_.description.couplings) {
      const bool is_at = coupling.tail.text == body || coupling.head.text == body;
      const Name& other = coupling.tail.text == body ? coupling.head : coupling.tail;
      if (is_at && !coupling.is_mesh() && other.text != shaft) {
        return false;
      }
      is_clutched = is_clutched || (is_at && coupling.type == CouplingType::clutch);
    }
    return shaft != context_.description.ground.text && is_clutched && meshes == 1;
  }

  bool is_on(const Name& name, const std::string& body) const {
    const GearMember* one = find_member(gears_, name);
    return one != nullptr && one->body.text == body;
  }

  void refuse_idler(const MeshDescription& mesh, int index, const std::string& shaft) {
    context_.found.error(
        "E0319",
        mesh.carrier ? mesh.carrier->where : mesh.name.where,
        fmt::format("gear '{}' turns on shaft '{}', meshes once and is clutched to the shaft: an "
                    "idler, whose shaft is not the carrier of its mesh",
                    member(index).name.text,
                    shaft),
        fmt::format("remove 'carrier: {}': the centres of both gears are fixed to the ground",
                    shaft));
  }

  // What only planets have, and only some of them.
  void check_words_of_planets(int index) {
    const GearMember& one = member(index);
    const int planet = axis_of(index);
    if (planet < 0 && (one.count || one.centre_distance)) {
      context_.found.error(
          "E0314",
          one.count ? one.count->where : one.centre_distance->where,
          fmt::format("gear member '{}' is on the main axis with its body '{}' and has no '{}'",
                      one.name.text,
                      one.body.text,
                      one.count ? "count" : "centre_distance"),
          "write it for a planet, or remove it");
    } else if (one.side == PlanetSide::right &&
               (planet < 0 || train_.axes[static_cast<std::size_t>(planet)].neighbour < 0)) {
      context_.found.warning(
          "W0301",
          one.name.where,
          fmt::format("'side' of gear member '{}' is never used: it is on {}",
                      one.name.text,
                      planet < 0 ? "the main axis" : "+y, as the first of its chain"),
          "write it for another planet, which meshes with the first, or remove it");
    }
  }

  // All gears of a body stand on one axis.
  void check_one_distance(int index) {
    const GearMember& one = member(index);
    const int p = axis_of(index);
    if (p < 0 || !one.centre_distance) {
      return;
    }
    const GearAxis& axis = train_.axes[at(p)];
    const double first = *numbers_.distance[at(p)];
    const auto own = context_.evaluator.number(*one.centre_distance, QuantityKind::length);
    const bool is_of_axis = axis.distance_giver.empty();
    if ((is_of_axis || axis.distance_giver == one.body.text) && own &&
        std::abs(*own - first) > kReportsAgree * first) {
      context_.found.error("E0314",
                           one.centre_distance->where,
                           fmt::format("body '{}' is {} from {} by {} and {} by '{}'",
                                       one.body.text,
                                       length(first),
                                       name_of_axis(train_, axis.about),
                                       is_of_axis ? "its axis in 'axes'" : "one of its members",
                                       length(*own),
                                       one.name.text),
                           is_of_axis ? "write 'centre_distance' once, for the axis"
                                      : "write one 'centre_distance' for the members of a body");
    }
  }

  void check_distance(std::size_t p) {
    const GearAxis& planet = train_.axes[p];
    const GearMember& first = member(planet.members.front());
    const bool has_distance = numbers_.distance[p] || planet.is_in_line ||
                              std::ranges::any_of(planet.on_centre, [&](int m) {
                                return numbers_.module[at(m)].has_value();
                              });
    if (!has_distance) {
      context_.found.error(
          "E0303",
          first.name.where,
          fmt::format("{} '{}' has no distance from {}",
                      word_of(planet, context_),
                      first.name.text,
                      name_of_axis(train_, planet.about)),
          planet.on_centre.empty()
              ? fmt::format("add 'centre_distance', as it meshes with no gear on {}",
                            name_of_axis(train_, planet.about))
              : fmt::format(
                    "add 'module' to 'gears' or to its mesh, or 'centre_distance' to the {}",
                    word_of(planet, context_)));
    }
    if (planet.neighbour_mesh >= 0 &&
        !numbers_.module[static_cast<std::size_t>(planet.neighbour_mesh)]) {
      const Name& mesh = gears_.meshes[static_cast<std::size_t>(planet.neighbour_mesh)].name;
      context_.found.error("E0303",
                           mesh.where,
                           fmt::format("mesh '{}' between two {}s lacks the key 'module'",
                                       mesh.text,
                                       word_of(planet, context_)),
                           "add it here or to 'gears': the distance of the two follows from it");
    }
  }

  std::string length(double metres) const {
    const FileUnits& units = context_.description.units;
    return fmt::format(
        "{:.6g} {}", units.from_si(QuantityKind::length, metres), units.text(QuantityKind::length));
  }

  const SectionContext& context_;
  const GearsDescription& gears_;
  const GearTrain& train_;
  const GearNumbers& numbers_;
};

}  // namespace

void check_planet_members(const SectionContext& context,
                          const GearTrain& train,
                          const GearNumbers& numbers) {
  PlanetMemberCheck(context, train, numbers).run();
}

}  // namespace kinestat
