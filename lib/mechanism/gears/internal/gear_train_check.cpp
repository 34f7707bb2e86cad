#include "mechanism/gears/internal/gear_train_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"

namespace kinestat {

namespace {

class GearTrainCheck {
 public:
  GearTrainCheck(const SectionContext& context, const GearTrain& train, const GearNumbers& numbers)
      : context_(context), gears_(*context.description.gears), train_(train), numbers_(numbers) {}

  // Whether a layout can be found.
  bool check_places() {
    const int errors_before = context_.found.error_count();
    check_declared_axes(context_, train_);
    for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
      check_axes(m);
    }
    check_planet_members(context_, train_, numbers_);
    for (const CouplingDescription& coupling : context_.description.couplings) {
      check_axis(coupling);
    }
    return context_.found.error_count() == errors_before;
  }

  void check_layout(const GearLayout& layout) {
    for (std::size_t p = 0; p < train_.axes.size(); ++p) {
      compare_meshes(layout, p);
    }
    for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
      compare_mesh(layout, m);
    }
    for (const CouplingDescription& coupling : context_.description.couplings) {
      check_bearing(layout, coupling);
      check_clutch(layout, coupling);
    }
  }

 private:
  const GearMember& member(int index) const {
    return gears_.members[static_cast<std::size_t>(index)];
  }

  int axis_of(int member) const { return train_.axis_of[static_cast<std::size_t>(member)]; }

  void check_axes(std::size_t m) {
    const int axis = axis_of(train_.first[m]);
    if (axis != axis_of(train_.second[m])) {
      return;
    }
    const MeshDescription& mesh = gears_.meshes[m];
    context_.found.error(
        "E0314",
        mesh.first.where,
        fmt::format("mesh '{}' joins two gears on {}, '{}' and '{}'",
                    mesh.name.text,
                    axis < 0 ? "the main axis" : "one axis",
                    mesh.first.text,
                    mesh.second.text),
        axis < 0 ? "a planet turns on its carrier alone; 'count', 'centre_distance' or 'axes' "
                   "say of a gear that it does not turn on the main axis"
                 : "what clutches, carriers or 'axes' join turns about one axis: correct these, "
                   "or the mesh");
  }

  std::string length(double metres) const {
    const FileUnits& units = context_.description.units;
    return fmt::format(
        "{:.6g} {}", units.from_si(QuantityKind::length, metres), units.text(QuantityKind::length));
  }

  // "'sp' (30 + 23 teeth)"
  std::string mesh_in_teeth(int mesh) const {
    const auto m = static_cast<std::size_t>(mesh);
    double a = numbers_.teeth[static_cast<std::size_t>(train_.first[m])];
    double b = numbers_.teeth[static_cast<std::size_t>(train_.second[m])];
    if (a < b) {
      std::swap(a, b);
    }
    return b < 0.0 ? fmt::format("'{}' ({} - {} teeth)", gears_.meshes[m].name.text, -b, a)
                   : fmt::format("'{}' ({} + {} teeth)", gears_.meshes[m].name.text, a, b);
  }

  // What the meshes of a planet with gears on the main axis ask for.
  void compare_meshes(const GearLayout& layout, std::size_t p) {
    const GearAxis& planet = train_.axes[p];
    if (numbers_.distance[p]) {
      return;
    }
    int nearest = -1;
    int farthest = -1;
    const auto asked = [&](int m) { return *layout.meshes[static_cast<std::size_t>(m)].asked; };
    for (const int m : planet.on_centre) {
      if (!layout.meshes[static_cast<std::size_t>(m)].asked) {
        continue;
      }
      nearest = nearest < 0 || asked(m) < asked(nearest) ? m : nearest;
      farthest = farthest < 0 || asked(m) > asked(farthest) ? m : farthest;
    }
    if (nearest < 0 || asked(farthest) - asked(nearest) <= kReportsAgree * asked(farthest)) {
      return;
    }
    const GearMember& first = member(planet.members.front());
    context_.found.warning(
        "W0305",
        first.name.where,
        fmt::format(
            "the centre distance of {0} from {2} is {1} by mesh {3}, but {4} by mesh {5}; it "
            "is placed at {6}",
            planet.bodies.size() == 1
                ? fmt::format("{} '{}'", word_of(planet, context_), first.name.text)
                : name_of_axis(train_, static_cast<int>(p)),
            length(asked(nearest)),
            name_of_axis(train_, planet.about),
            mesh_in_teeth(nearest),
            length(asked(farthest)),
            mesh_in_teeth(farthest),
            length(distance_of(layout, p))),
        hint_on_distances(farthest, asked(farthest) - asked(nearest), planet));
  }

  double distance_of(const GearLayout& layout, std::size_t p) const {
    const int about = train_.axes[p].about;
    return (layout.centres[p] - (about < 0 ? Vec3(Vec3::Zero()) : layout.centres[at(about)]))
        .norm();
  }

  // A ring that is not called one asks for much more than any profile shift can give.
  std::string hint_on_distances(int farthest, double difference, const GearAxis& axis) const {
    const auto m = static_cast<std::size_t>(farthest);
    const int a = train_.first[m];
    const int on_centre = axis_of(a) == axis.about ? a : train_.second[m];
    const bool is_on_ground = axis.carrier == context_.description.ground.text;
    if (difference > *numbers_.module[m] && is_on_ground) {
      return fmt::format(
          "if '{}' does not turn on the main axis, write its 'centre_distance', or its body on an "
          "axis of its own in 'axes'; otherwise correct the teeth",
          member(on_centre).name.text);
    }
    if (difference > *numbers_.module[m] && !member(on_centre).internal) {
      return fmt::format("if '{}' is a ring, add 'internal: true'; otherwise correct the teeth",
                         member(on_centre).name.text);
    }
    if (is_on_ground) {
      return "with profile shift, give its 'centre_distance' from the drawing; otherwise correct "
             "the teeth or the modules";
    }
    return "with profile shift, give 'centre_distance' of the planet from the drawing; otherwise "
           "correct the teeth: a set without profile shift needs ring = sun + 2*planet";
  }

  bool has_member(const Name& body) const {
    return std::ranges::any_of(gears_.members,
                               [&](const GearMember& one) { return one.body.text == body.text; });
  }

  bool holds_gears(const Name& body) const {
    return body.text == context_.description.ground.text ||
           std::ranges::any_of(gears_.meshes, [&](const MeshDescription& mesh) {
             return mesh.carrier && mesh.carrier->text == body.text;
           });
  }

  bool is_part(const Name& body) const { return has_member(body) || holds_gears(body); }

  bool is_bearing(const CouplingDescription& coupling) const {
    return coupling.type == CouplingType::revolute && is_part(coupling.tail) &&
           is_part(coupling.head);
  }

  void check_axis(const CouplingDescription& coupling) {
    const bool is_in_space = context_.description.space == Space::spatial;
    const auto axis = is_in_space && is_bearing(coupling) && coupling.axis
                          ? context_.evaluator.axis(*coupling.axis)
                          : std::nullopt;
    if (axis && axis->direction.head<2>().norm() > kParallelAxes) {
      context_.found.error(
          "E0314",
          coupling.axis->where,
          fmt::format("revolute '{}' bears gears of 'gears', which turn about z",
                      coupling.name.text),
          "write axis: z; meshes of gears on other axes are couplings: 'kinestat help couplings'");
    }
  }

  // A bearing whose whole point is given stands where its gear does.
  void check_bearing(const GearLayout& layout, const CouplingDescription& coupling) {
    const bool has_point = is_bearing(coupling) && coupling.at && coupling.at->point;
    const auto point = has_point ? context_.evaluator.point(*coupling.at->point) : std::nullopt;
    const Vec3 axis = layout.axis_of(coupling.tail.text, coupling.head.text);
    if (!point || (point->head<2>() - axis.head<2>()).norm() <= kReportsAgree * point->norm() ||
        (point->norm() == 0.0 && axis.norm() == 0.0)) {
      return;
    }
    const bool is_planar = context_.description.space == Space::planar;
    context_.found.warning(
        "W0305",
        coupling.at->where,
        fmt::format("revolute '{}' is {} from the axis on which its gears turn",
                    coupling.name.text,
                    length((point->head<2>() - axis.head<2>()).norm())),
        is_planar ? "remove its 'at': 'gears' finds the axis"
                  : "write its position along the axis alone, for example at: 0: 'gears' finds the "
                    "axis");
  }

  bool bears(const Name& a, const Name& b) const {
    return std::ranges::any_of(
        context_.description.couplings, [&](const CouplingDescription& coupling) {
          return coupling.type == CouplingType::revolute &&
                 ((coupling.tail.text == a.text && coupling.head.text == b.text) ||
                  (coupling.tail.text == b.text && coupling.head.text == a.text));
        });
  }

  // What a clutch joins turns about one axis, unless one of the two bears the other.
  void check_clutch(const GearLayout& layout, const CouplingDescription& coupling) {
    const std::string& ground = context_.description.ground.text;
    if (!joins_one_axis(coupling.type) || coupling.tail.text == ground ||
        coupling.head.text == ground || bears(coupling.tail, coupling.head)) {
      return;
    }
    const int on_tail = train_.axis_on(coupling.tail.text);
    const int on_head = train_.axis_on(coupling.head.text);
    if (on_tail != on_head) {
      const Vec3 tail = layout.axis_of(coupling.tail.text, coupling.tail.text);
      const Vec3 head = layout.axis_of(coupling.head.text, coupling.head.text);
      if ((tail - head).norm() > kReportsAgree * std::max(tail.norm(), head.norm())) {
        refuse_clutch(coupling, -1, tail.norm(), head.norm(), (tail - head).norm());
      }
      return;
    }
    const auto tail = on_tail < 0 ? std::nullopt : own_distance(layout, on_tail, coupling.tail);
    const auto head = on_head < 0 ? std::nullopt : own_distance(layout, on_head, coupling.head);
    if (tail && head && (tail->is_given || head->is_given) &&
        std::abs(tail->length - head->length) >
            kReportsAgree * std::max(tail->length, head->length)) {
      refuse_clutch(coupling,
                    train_.axes[at(on_tail)].about,
                    tail->length,
                    head->length,
                    std::abs(tail->length - head->length));
    }
  }

  struct OwnDistance {
    double length = 0.0;
    bool is_given = false;
  };

  // What a body says of the distance of its axis: by a member, or by its meshes. Empty if the axis
  // itself is given one, which counts for all its bodies.
  std::optional<OwnDistance> own_distance(const GearLayout& layout,
                                          int axis,
                                          const Name& body) const {
    const GearAxis& one = train_.axes[at(axis)];
    if (one.distance != nullptr && one.distance_giver.empty()) {
      return std::nullopt;
    }
    for (const int i : one.members) {
      if (member(i).body.text == body.text && member(i).centre_distance) {
        const auto given =
            context_.evaluator.number(*member(i).centre_distance, QuantityKind::length);
        return OwnDistance{.length = given.value_or(0.0), .is_given = true};
      }
    }
    double sum = 0.0;
    int count = 0;
    for (const int m : one.on_centre) {
      const bool is_of_body = member(train_.first[at(m)]).body.text == body.text ||
                              member(train_.second[at(m)]).body.text == body.text;
      if (is_of_body && layout.meshes[at(m)].asked) {
        sum += *layout.meshes[at(m)].asked;
        ++count;
      }
    }
    return count == 0 ? std::nullopt : std::optional(OwnDistance{.length = sum / count});
  }

  void refuse_clutch(
      const CouplingDescription& coupling, int about, double tail, double head, double between) {
    context_.found.error(
        "E0318",
        coupling.name.where,
        fmt::format("clutch '{}' joins bodies that turn about two axes: '{}' is {} from {}, '{}' "
                    "{}, with {} between them",
                    coupling.name.text,
                    coupling.tail.text,
                    length(tail),
                    name_of_axis(train_, about),
                    coupling.head.text,
                    length(head),
                    length(between)),
        "write the same 'centre_distance' for the gears of both, or one for their axis in 'axes', "
        "or correct the teeth; engaged between two axes it would hold both still");
  }

  // What the mesh asks for against what others or the file have fixed.
  void compare_mesh(const GearLayout& layout, std::size_t m) {
    const MeshLayoutOf<double>& mesh = layout.meshes[m];
    if (!mesh.asked) {
      return;
    }
    const int a = axis_of(train_.first[m]);
    const int b = axis_of(train_.second[m]);
    const bool is_first_off = a >= 0 && train_.axes[at(a)].about == b;
    const bool is_on_centre = is_first_off || (b >= 0 && train_.axes[at(b)].about == a);
    const bool is_given = numbers_.distance[at(is_first_off ? a : b)].has_value();
    // Profile shift moves centres by less than a module.
    const double most = is_on_centre ? *numbers_.module[m] : kReportsAgree * *mesh.asked;
    if ((is_on_centre && !is_given) || std::abs(mesh.distance - *mesh.asked) <= most) {
      return;
    }
    const Name& name = gears_.meshes[m].name;
    context_.found.warning(
        "W0305",
        name.where,
        fmt::format("mesh {} requires a centre distance of {}, but its centres are {} apart",
                    mesh_in_teeth(static_cast<int>(m)),
                    length(*mesh.asked),
                    length(mesh.distance)),
        is_on_centre ? "correct 'centre_distance', the module or the teeth; profile shift moves "
                       "centres by less than a module"
                     : "correct the teeth or the distances of the two axes from the main axis");
  }

  const SectionContext& context_;
  const GearsDescription& gears_;
  const GearTrain& train_;
  const GearNumbers& numbers_;
};

}  // namespace

void check_gear_train(const SectionContext& context) {
  const GearTrain train = find_gear_train(context.description);
  const auto numbers =
      bind_gear_numbers<double>(*context.description.gears, train, context.evaluator);
  if (!numbers) {
    return;
  }
  GearTrainCheck check(context, train, *numbers);
  if (!check.check_places()) {
    return;
  }
  if (const std::optional<GearLayout> layout = find_layout<double>(train, *numbers)) {
    check.check_layout(*layout);
    check_planet_spacing(context, *numbers, *layout);
  }
}

}  // namespace kinestat
