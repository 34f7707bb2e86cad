#include "mechanism/gears/internal/gear_check.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "description/gear_expansion.hpp"
#include "mechanism/gears/internal/gear_train_check.hpp"

namespace kinestat {

namespace {

constexpr NumberRule kToothCount = {.kind = QuantityKind::dimensionless,
                                    .range = kTeeth,
                                    .allowed = "a whole number from 1 to 10000"};

constexpr NumberRule kPlanetCount = {.kind = QuantityKind::dimensionless,
                                     .range = kPlanets,
                                     .allowed = "a whole number from 1 to 64"};

constexpr NumberRule kLoadSharing = {.kind = QuantityKind::dimensionless,
                                     .range = kAtLeastOne,
                                     .allowed = "a number of at least 1, for example 1.15"};

constexpr NumberRule kPressureAngle = {
    .kind = QuantityKind::angle,
    .range = kAcuteAngle,
    .allowed = "an angle from 0 deg to below 90 deg, for example 20 deg"};

constexpr NumberRule kHelixAngle = {
    .kind = QuantityKind::angle,
    .range = kBelowRightAngle,
    .allowed = "an angle between -90 deg and 90 deg, above zero for right-handed teeth"};

class GearCheck {
 public:
  GearCheck(const SectionContext& context, const GearsDescription& gears)
      : context_(context), gears_(gears), is_used_(gears.members.size(), false) {}

  void run() {
    check_tooth_form(gears_, "'gears'");
    for (const GearAxisDescription& axis : gears_.axes) {
      check_axis(axis);
    }
    for (const GearMember& member : gears_.members) {
      check_member(member);
    }
    for (const MeshDescription& mesh : gears_.meshes) {
      check_mesh(mesh);
    }
    check_module();
    warn_of_unused();
  }

 private:
  // Of the section, or of a mesh.
  template <class Description>
  void check_tooth_form(const Description& of, std::string_view what) {
    context_.number(of.module, kAboveZeroLength, fmt::format("'module' of {}", what));
    context_.number(of.pressure_angle, kPressureAngle, fmt::format("'pressure_angle' of {}", what));
    context_.number(of.normal_pressure_angle,
                    kPressureAngle,
                    fmt::format("'normal_pressure_angle' of {}", what));
    context_.number(of.helix_angle, kHelixAngle, fmt::format("'helix_angle' of {}", what));
  }

  void check_axis(const GearAxisDescription& axis) {
    const std::string what = fmt::format("axis '{}'", axis.name.text);
    for (const Name& body : axis.bodies) {
      if (!context_.names.bodies.check(body, what + " is of", context_.found)) {
        continue;
      }
      if (body.text == context_.description.ground.text) {
        context_.found.error(
            "E0314",
            body.where,
            fmt::format("{} has the ground '{}' among its bodies", what, body.text),
            "name what turns about it");
      }
      const auto [known, is_new] = axis_of_body_.emplace(body.text, &axis);
      if (!is_new) {
        auto& problem = context_.found.error("E0314",
                                             body.where,
                                             fmt::format("body '{}' is in 'axes' twice", body.text),
                                             "a body turns about one axis: write it once");
        problem.notes.push_back({known->second->name.where, "first here"});
      }
    }
    context_.number(axis.centre_distance, kAboveZeroLength, "'centre_distance' of " + what);
  }

  void check_member(const GearMember& member) {
    const std::string what = fmt::format("gear member '{}'", member.name.text);
    context_.names.bodies.check(member.body, what + " is fixed to", context_.found);
    teeth_.push_back(context_.number(member.teeth, kToothCount, "'teeth' of " + what));
    const auto count = context_.number(member.count, kPlanetCount, "'count' of " + what);
    const auto sharing =
        context_.number(member.load_sharing, kLoadSharing, "'load_sharing' of " + what);
    if (count && sharing && *sharing > *count) {
      context_.found.error(
          "E0314",
          member.load_sharing->where,
          fmt::format("'load_sharing' of {} is {:.6g}, and of {:.0f} planets one cannot bear more "
                      "than {:.0f} times the mean",
                      what,
                      *sharing,
                      *count,
                      *count),
          "write the load of the most loaded planet over the mean of all, for example 1.15");
    }
    context_.number(member.centre_distance, kAboveZeroLength, "'centre_distance' of " + what);
  }

  void check_mesh(const MeshDescription& mesh) {
    const std::string what = fmt::format("mesh '{}'", mesh.name.text);
    check_tooth_form(mesh, what);
    context_.number(mesh.at, kAnyLength, fmt::format("'at' of {}", what));
    if (mesh.at && context_.description.space == Space::planar) {
      context_.found.error("E0314",
                           mesh.at->where,
                           fmt::format("'at' of {} leaves the plane, along the axis", what),
                           "remove 'at', or write 'space: spatial' at the top of the file");
    }
    if (mesh.carrier) {
      context_.names.bodies.check(
          *mesh.carrier, fmt::format("the carrier of {} is", what), context_.found);
    }
    const int first = find_member(mesh.first, what);
    const int second = find_member(mesh.second, what);
    if (first == second && first >= 0) {
      context_.found.error(
          "E0314",
          mesh.second.where,
          fmt::format("{} joins gear member '{}' to itself", what, mesh.second.text),
          "name two different members");
    } else if (first >= 0 && second >= 0) {
      check_pair(mesh, static_cast<std::size_t>(first), static_cast<std::size_t>(second));
    }
  }

  // The index of a member, or -1 after an error.
  int find_member(const Name& name, const std::string& what) {
    if (!context_.names.members.check(name, what + " joins", context_.found)) {
      return -1;
    }
    const int index = context_.names.members.find(name.text);
    is_used_[static_cast<std::size_t>(index)] = true;
    return index;
  }

  void check_pair(const MeshDescription& mesh, std::size_t first, std::size_t second) {
    const GearMember& a = gears_.members[first];
    const GearMember& b = gears_.members[second];
    if (a.body.text == b.body.text) {
      refuse(mesh,
             fmt::format("joins two members of the same body '{}'", a.body.text),
             "two gears of one body never turn against each other; name members of two bodies");
    }
    if (a.internal && b.internal) {
      refuse(mesh,
             fmt::format("joins two rings, '{}' and '{}'", a.name.text, b.name.text),
             "a ring meshes with a gear inside it; remove 'internal: true' from one of the two");
    } else if (a.internal || b.internal) {
      check_ring(mesh, a.internal ? first : second, a.internal ? second : first);
    }
    check_carrier(mesh, a, b);
  }

  void check_ring(const MeshDescription& mesh, std::size_t ring, std::size_t gear) {
    if (teeth_[ring] && teeth_[gear] && *teeth_[ring] <= *teeth_[gear]) {
      refuse(mesh,
             fmt::format("needs a ring with more teeth than its gear: '{}' has {}, '{}' has {}",
                         gears_.members[ring].name.text,
                         *teeth_[ring],
                         gears_.members[gear].name.text,
                         *teeth_[gear]),
             "correct the teeth, or remove 'internal: true'");
    }
  }

  // The centres stand still on the carrier, so it turns with neither of the two.
  void check_carrier(const MeshDescription& mesh, const GearMember& a, const GearMember& b) {
    const std::string& carrier =
        mesh.carrier ? mesh.carrier->text : context_.description.ground.text;
    for (const GearMember* member : {&a, &b}) {
      if (member->body.text != carrier) {
        continue;
      }
      if (mesh.carrier) {
        context_.found.error("E0314",
                             mesh.carrier->where,
                             fmt::format("the carrier of mesh '{}' is the body of its member '{}'",
                                         mesh.name.text,
                                         member->name.text),
                             "name the body that holds the centres of the two gears apart");
      } else {
        context_.found.error(
            "E0303",
            mesh.name.where,
            fmt::format("mesh '{}' needs a carrier: its member '{}' is fixed to the ground",
                        mesh.name.text,
                        member->name.text),
            "add 'carrier: NAME', the body that holds the centres of the two gears apart");
      }
    }
  }

  void refuse(const MeshDescription& mesh, const std::string& message, std::string hint) {
    context_.found.error("E0314",
                         mesh.first.where,
                         fmt::format("mesh '{}' {}", mesh.name.text, message),
                         std::move(hint));
  }

  // Sizes follow from the module, or from distances that are given.
  void check_module() {
    const auto is_given = [](const auto& one) { return one.centre_distance.has_value(); };
    const bool has_distance =
        std::ranges::any_of(gears_.members, is_given) || std::ranges::any_of(gears_.axes, is_given);
    const bool has_own = std::ranges::all_of(
        gears_.meshes, [](const MeshDescription& one) { return one.module.has_value(); });
    if (!gears_.module && !has_distance && !has_own) {
      context_.found.error("E0303",
                           gears_.where,
                           "'gears' lacks the key 'module'",
                           "add for example 'module: 2 mm', the pitch diameter per tooth; ratios "
                           "do not depend on it, forces do");
    }
  }

  void warn_of_unused() {
    for (std::size_t i = 0; i < gears_.members.size(); ++i) {
      if (!is_used_[i]) {
        const Name& name = gears_.members[i].name;
        context_.found.warning("W0301",
                               name.where,
                               fmt::format("gear member '{}' is in no mesh", name.text),
                               "add a mesh that names it, or remove it");
      }
    }
  }

  const SectionContext& context_;
  const GearsDescription& gears_;
  std::map<std::string, const GearAxisDescription*> axis_of_body_;
  std::vector<std::optional<double>> teeth_;
  std::vector<bool> is_used_;
};

}  // namespace

bool check_gears(const SectionContext& context) {
  const int errors_before = context.found.error_count();
  if (context.description.gears) {
    GearCheck(context, *context.description.gears).run();
    if (context.found.error_count() == errors_before && has_all_meshes(context.description)) {
      check_gear_train(context);
    }
  }
  return context.found.error_count() == errors_before;
}

}  // namespace kinestat
