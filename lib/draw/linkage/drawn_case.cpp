#include "draw/linkage/drawn_case.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "draw/symbols.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

class ArrowFinder {
 public:
  ArrowFinder(const MechanismDescription& description,
              const Mechanism& mechanism,
              const CaseAnalysis& one)
      : mechanism_(mechanism), description_(description), units_(description.units), one_(one) {}

  void add_reactions() {
    for (int e = 0; e < mechanism_.topology.coupling_count(); ++e) {
      add_reaction(CouplingId{e});
    }
  }

  void add_loads() {
    for (const Load& load : one_.which.loads) {
      add_load(load);
    }
  }

  void add_actuators() {
    for (std::size_t i = 0; has_actions() && i < mechanism_.topology.actuators.size(); ++i) {
      add_actuator(mechanism_.topology.actuators[i]);
    }
  }

  bool has_actions() const { return one_.action && !one_.action->magnitudes.empty(); }

  void add_drives() {
    if (!has_motion()) {
      return;
    }
    for (const int input : one_.which.inputs) {
      const ActuatorTopology& actuator =
          mechanism_.topology.actuators[static_cast<std::size_t>(input)];
      const auto f = static_cast<std::size_t>(actuator.freedom);
      const FreedomLabel& label = mechanism_.topology.freedoms[f];
      const double rate = one_.motion->rates[f];
      const Twist& unit = mechanism_.geometry.motions[f];
      const QuantityKind kind = kind_of(label);
      add({.kind = ArrowKind::drive,
           .at = point_of(label.coupling),
           .vector = rate * (label.is_rotation ? unit.angular : unit.linear),
           .is_axial = label.is_rotation,
           .name = actuator.name,
           .text = text_of(actuator.name, std::abs(rate), kind)});
    }
  }

  void add_velocities() {
    if (!has_motion()) {
      return;
    }
    for (int e = 0; e < mechanism_.topology.coupling_count(); ++e) {
      const CouplingTopology& coupling = mechanism_.topology.coupling(CouplingId{e});
      const Vec3 at = point_of(CouplingId{e});
      const Twist& twist = one_.motion->bodies[static_cast<std::size_t>(coupling.head.value)];
      const Vec3 velocity = velocity_at<double>(twist, at);
      add({.kind = ArrowKind::velocity,
           .at = at,
           .vector = velocity,
           .is_axial = false,
           .name = {},
           .text = text_of("", velocity.norm(), QuantityKind::velocity)});
    }
  }

  std::vector<DrawnArrow> take_all() { return std::move(arrows_); }

  // Those that are not rounding beside the largest of their kind.
  std::vector<DrawnArrow> take() {
    const auto largest = [this](const DrawnArrow& like) {
      double size = 0.0;
      for (const DrawnArrow& arrow : arrows_) {
        if (arrow.is_axial == like.is_axial &&
            (arrow.kind == like.kind || (is_action(arrow) && is_action(like)))) {
          size = std::max(size, arrow.vector.norm());
        }
      }
      return size;
    };
    std::vector<DrawnArrow> result;
    for (const DrawnArrow& arrow : arrows_) {
      if (arrow.vector.norm() > kReportsAgree * largest(arrow)) {
        result.push_back(arrow);
      }
    }
    return result;
  }

 private:
  static bool is_action(const DrawnArrow& arrow) {
    return arrow.kind == ArrowKind::reaction || arrow.kind == ArrowKind::load ||
           arrow.kind == ArrowKind::actuator;
  }

  bool has_motion() const { return one_.motion && !one_.motion->rates.empty(); }

  Vec3 point_of(CouplingId id) const {
    return mechanism_.geometry.points[static_cast<std::size_t>(id.value)];
  }

  void add(DrawnArrow arrow) { arrows_.push_back(std::move(arrow)); }

  std::string text_of(const std::string& name, double value, QuantityKind kind) const {
    const std::string number =
        fmt::format("{} {}", short_number(units_.from_si(kind, value)), units_.text(kind));
    return name.empty() ? number : fmt::format("{} {}", name, number);
  }

  void add_reaction(CouplingId id) {
    const auto e = static_cast<std::size_t>(id.value);
    const auto& wrench = one_.action->wrenches[e];
    // Of cables and their virtual links the pulleys say enough.
    const bool is_cable = mechanism_.topology.coupling(id).type == CouplingType::cable ||
                          description_.couplings[e].part != nullptr;
    if (wrench && !is_cable) {
      const Vec3 force = wrench->force - force_of_actuators(id);
      add({.kind = ArrowKind::reaction,
           .at = point_of(id),
           .vector = force,
           .is_axial = false,
           .name = {},
           .text = text_of("", force.norm(), QuantityKind::force)});
    }
  }

  // Those have arrows of their own.
  Vec3 force_of_actuators(CouplingId id) const {
    Vec3 sum = Vec3::Zero();
    for (const ActuatorTopology& actuator : mechanism_.topology.actuators) {
      const auto a = static_cast<std::size_t>(actuator.action);
      if (mechanism_.topology.actions[a].coupling == id) {
        sum += one_.action->magnitudes[a].value_or(0.0) * mechanism_.geometry.actions[a].force;
      }
    }
    return sum;
  }

  // A couple has no place of its own: it stands at the reference point of the body, unless that is
  // so far away that the mechanism would vanish beside it; then at the nearest coupling of the
  // body.
  Vec3 place_of_couple(BodyId body) const {
    const Geometry& geometry = mechanism_.geometry;
    const Vec3 reference = geometry.references[static_cast<std::size_t>(body.value)];
    Vec3 nearest = reference;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < geometry.points.size(); ++e) {
      const CouplingTopology& coupling = mechanism_.topology.couplings[e];
      const double distance = (geometry.points[e] - reference).norm();
      if ((coupling.tail == body || coupling.head == body) && distance < least) {
        least = distance;
        nearest = geometry.points[e];
      }
    }
    return least > kFarOrigin * geometry.length ? nearest : reference;
  }

  void add_load(const Load& load) {
    if (load.point) {
      add({.kind = ArrowKind::load,
           .at = *load.point,
           .vector = load.acts.wrench.force,
           .is_axial = false,
           .name = load.name,
           .text = text_of(load.name, load.acts.wrench.force.norm(), QuantityKind::force)});
    }
    const Vec3 couple = couple_of(load);
    add({.kind = ArrowKind::load,
         .at = load.point ? *load.point : place_of_couple(load.acts.body),
         .vector = couple,
         .is_axial = true,
         .name = load.name,
         .text = text_of(load.name, couple.norm(), QuantityKind::moment)});
  }

  void add_actuator(const ActuatorTopology& actuator) {
    const auto a = static_cast<std::size_t>(actuator.action);
    const std::optional<double>& magnitude = one_.action->magnitudes[a];
    if (!magnitude) {
      return;
    }
    const ActionLabel& label = mechanism_.topology.actions[a];
    const Wrench& unit = mechanism_.geometry.actions[a];
    add({.kind = ArrowKind::actuator,
         .at = point_of(label.coupling),
         .vector = *magnitude * (label.is_couple ? unit.moment : unit.force),
         .is_axial = label.is_couple,
         .name = actuator.name,
         .text = text_of(actuator.name, std::abs(*magnitude), kind_of(label))});
  }

  const Mechanism& mechanism_;
  const MechanismDescription& description_;
  const FileUnits& units_;
  const CaseAnalysis& one_;
  std::vector<DrawnArrow> arrows_;
};

}  // namespace

std::vector<DrawnArrow> find_arrows(const Analysis& analysis, const LinkageOptions& options) {
  if (!options.which || *options.which >= analysis.cases.size()) {
    return {};
  }
  ArrowFinder finder(analysis.description, analysis.mechanism, analysis.cases[*options.which]);
  finder.add_drives();
  if (options.shows_forces && finder.has_actions()) {
    finder.add_reactions();
    finder.add_loads();
    finder.add_actuators();
  }
  if (options.shows_velocities) {
    finder.add_velocities();
  }
  return finder.take();
}

std::vector<DrawnArrow> find_outer_actions(const MechanismDescription& description,
                                           const Mechanism& mechanism,
                                           const CaseAnalysis& one) {
  ArrowFinder finder(description, mechanism, one);
  finder.add_loads();
  finder.add_actuators();
  return finder.take_all();
}

}  // namespace kinestat
