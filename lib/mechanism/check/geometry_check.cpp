#include "mechanism/check/geometry_check.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

std::string title(const CouplingDescription& coupling) {
  return fmt::format("{} '{}'", word_of(coupling.type), coupling.name.text);
}

class GeometryCheck {
 public:
  GeometryCheck(const CouplingDescription& coupling, Evaluator& evaluator, Diagnostics& found)
      : coupling_(coupling), evaluator_(evaluator), found_(found) {}

  void run(Space space) {
    check_space(space);
    check_helix();
    check_ends();
    check_listed();
    check_radii();
    for (const StiffnessDescription& one : coupling_.stiffness) {
      check_stiffness(one);
    }
  }

 private:
  void refuse(std::string message, std::string hint) {
    found_.error("E0314", coupling_.name.where, std::move(message), std::move(hint));
  }

  void check_space(Space space) {
    const CouplingKind& kind = kind_of(coupling_.type);
    if (space == Space::planar && !kind.is_in_plane) {
      refuse(fmt::format("{} needs a spatial mechanism", title(coupling_)),
             "write 'space: spatial' at the top of the file, or choose a planar type");
    }
    if (space == Space::spatial && !kind.is_in_space) {
      refuse(fmt::format("{} needs a planar mechanism", title(coupling_)),
             "write 'space: planar' at the top of the file; in space a cylindrical or a "
             "sphere_in_tube coupling may serve");
    }
  }

  void check_helix() {
    if (coupling_.type != helical) {
      return;
    }
    if (coupling_.pitch.has_value() == coupling_.lead.has_value()) {
      refuse(coupling_.pitch ? fmt::format("{} has both a pitch and a lead", title(coupling_))
                             : fmt::format("{} lacks its pitch", title(coupling_)),
             "write lead: 5 mm (per turn) or pitch: 0.8 mm (per radian)");
    }
  }

  void check_ends() {
    if (coupling_.type != cable || coupling_.is_segment() || is_counted_only(coupling_)) {
      return;
    }
    if (!coupling_.from || !coupling_.to) {
      refuse(fmt::format("{} lacks the key '{}'", title(coupling_), coupling_.from ? "to" : "from"),
             "write from: its end on the tail, and to: its end on the head");
      return;
    }
    const auto from = evaluator_.point(*coupling_.from);
    const auto to = evaluator_.point(*coupling_.to);
    if (from && to && *from == *to) {
      found_.error("E0314",
                   coupling_.to->where,
                   fmt::format("the ends of {} are the same point", title(coupling_)),
                   "a cable needs a direction: move one of its ends");
    }
  }

  void check_listed() {
    if (coupling_.type == screws && coupling_.freedoms.empty() && coupling_.constraints.empty()) {
      refuse(fmt::format("{} lists neither freedoms nor constraints", title(coupling_)),
             "write for example freedoms: [{rotation: z, at: [0, 0, 0]}]; what you leave out "
             "follows as the reciprocal complement");
    }
  }

  // Where two bodies touch, one of them is round; a negative radius is that of a hollow.
  void check_radii() {
    const auto is_flat = [](const std::optional<Value>& radius) { return !radius; };
    if (coupling_.radii.size() == 2 && std::ranges::all_of(coupling_.radii, is_flat)) {
      refuse(fmt::format("both bodies of {} are flat", title(coupling_)),
             "give the radius of the round one, as in radii: [31, flat]");
    }
    double curvature = 0.0;  // of both together, positive where each bends away from the other
    bool is_complete = coupling_.radii.size() == 2;
    for (const std::optional<Value>& radius : coupling_.radii) {
      const auto number = radius ? evaluator_.number(*radius, QuantityKind::length)
                                 : std::optional(std::numeric_limits<double>::infinity());
      is_complete = is_complete && number && *number != 0.0;
      if (is_complete) {
        curvature += 1.0 / *number;
      }
      if (number && *number == 0.0) {
        found_.error("E0305",
                     radius->where,
                     fmt::format("a radius of {} is zero", title(coupling_)),
                     "write flat for a plane; an edge is round by a small radius");
      }
    }
    const std::optional<Value>& first = is_complete ? coupling_.radii.front() : std::nullopt;
    if (is_complete && !(curvature > 0.0) && (first || coupling_.radii.back())) {
      found_.error(
          "E0305",
          (first ? first : coupling_.radii.back())->where,
          fmt::format(
              "by their radii the bodies of {} do not touch at one point, but overlap or fit",
              title(coupling_)),
          "a hollow, whose radius is negative, takes a body of a smaller radius, as in "
          "radii: [31, -40]; a plane takes a round one, as in radii: [31, flat]");
    }
  }

  // Forces are along translations [N/m], couples along rotations [N·m/rad]: T is a couple.
  void check_stiffness(const StiffnessDescription& one) {
    const bool is_couple = one.action.text.starts_with('T');
    const auto number = evaluator_.number(
        one.value, is_couple ? QuantityKind::angular_stiffness : QuantityKind::stiffness);
    if (number && *number <= 0.0) {
      found_.error(
          "E0305",
          one.value.where,
          fmt::format(
              "the stiffness '{}' of {} is not positive", one.action.text, title(coupling_)),
          "leave a rigid action out; a constraint without stiffness is none");
    }
  }

  const CouplingDescription& coupling_;
  Evaluator& evaluator_;
  Diagnostics& found_;
};

}  // namespace

bool is_counted_only(const CouplingDescription& coupling) {
  const bool has_no_ends =
      coupling.type == cable && !coupling.is_segment() && !coupling.from && !coupling.to;
  return has_no_ends || (!coupling.at && !coupling.is_mesh() && kind_of(coupling.type).needs_place);
}

bool check_geometry(const CouplingDescription& coupling,
                    Space space,
                    Evaluator& evaluator,
                    Diagnostics& found) {
  const int errors_before = found.error_count();
  GeometryCheck(coupling, evaluator, found).run(space);
  return found.error_count() == errors_before;
}

namespace {

// Neither of which bears the other.
bool joins_two_axes(const CouplingDescription& coupling, const GearFrame* gears) {
  if (gears == nullptr) {
    return false;
  }
  const GearTrain& train = gears->layout.train;
  const int tail = train.axis_on(coupling.tail.text);
  const int head = train.axis_on(coupling.head.text);
  return tail >= 0 && head >= 0 && tail != head && train.axes[at(tail)].about != head &&
         train.axes[at(head)].about != tail;
}

}  // namespace

bool check_axis_place(const CouplingDescription& coupling,
                      const MechanismDescription& description,
                      const GearFrame* gears,
                      Diagnostics& found) {
  if (!coupling.at || !coupling.at->along_axis) {
    return true;
  }
  const bool is_planar = description.space == Space::planar;
  const std::string_view point = is_planar ? "[x, y]" : "[x, y, z]";
  const auto refuse = [&](std::string hint) {
    found.error("E0314",
                coupling.at->where,
                fmt::format("the point of coupling '{}' is a single number", coupling.name.text),
                std::move(hint));
    return false;
  };
  if (!description.gears) {
    return refuse(
        fmt::format("write {}; a single number is a position along the axis, for the "
                    "couplings of the members of 'gears'",
                    point));
  }
  if (is_planar) {
    return refuse(
        "remove 'at': in the plane the coupling is on the axis of its gear; or write [x, y]");
  }
  return !joins_two_axes(coupling, gears) ||
         refuse("write at: [x, y, z], as it joins bodies that turn about two axes");
}

namespace {

// Whether two turns are about one line; `length` is the size of the mechanism.
bool are_coaxial(const Twist& one, const Twist& other, double length) {
  const double sense = one.angular.dot(other.angular) < 0.0 ? -1.0 : 1.0;
  const Vec3 turn = one.angular - sense * other.angular;
  const Vec3 slide = one.linear - sense * other.linear;
  return turn.norm() <= kParallelAxes && slide.norm() <= kSameValue * length;
}

// Whether the coupling lets a cable slip on a pulley, which is no bar.
bool slips(const Mechanism& mechanism, const CouplingTopology& coupling) {
  return std::ranges::any_of(mechanism.contacts, [&](const CableContact& contact) {
    return contact.slips && &mechanism.topology.coupling(*contact.slips) == &coupling;
  });
}

bool has_place(const MechanismDescription& description, const CouplingTopology& coupling) {
  return std::ranges::none_of(description.couplings, [&](const CouplingDescription& one) {
    return one.name.text == coupling.name && is_counted_only(one);
  });
}

}  // namespace

void warn_of_links_without_length(const MechanismDescription& description,
                                  const Mechanism& mechanism,
                                  Diagnostics& found) {
  const Topology& topology = mechanism.topology;
  std::vector<std::vector<const CouplingTopology*>> joined(topology.bodies.size());
  for (const CouplingTopology& coupling : topology.couplings) {
    joined[static_cast<std::size_t>(coupling.tail.value)].push_back(&coupling);
    joined[static_cast<std::size_t>(coupling.head.value)].push_back(&coupling);
  }
  for (std::size_t b = 1; b < joined.size(); ++b) {
    const bool is_bar =
        joined[b].size() == 2 && std::ranges::all_of(joined[b], [&](const CouplingTopology* one) {
          return one->type == CouplingType::revolute && !slips(mechanism, *one);
        });
    const auto motion = [&](std::size_t i) {
      return mechanism.geometry.motions[static_cast<std::size_t>(joined[b][i]->first_freedom)];
    };
    if (is_bar && are_coaxial(motion(0), motion(1), mechanism.geometry.length) &&
        std::ranges::all_of(
            joined[b], [&](const CouplingTopology* one) { return has_place(description, *one); })) {
      found.warning(
          "W0309",
          topology.bodies[b].where,
          fmt::format("link '{}' has no length: its couplings '{}' and '{}' have one axis",
                      topology.bodies[b].name,
                      joined[b][0]->name,
                      joined[b][1]->name),
          "give the two couplings different points, or join their other bodies directly");
    }
  }
}

}  // namespace kinestat
