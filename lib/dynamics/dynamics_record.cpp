#include "dynamics/dynamics_record.hpp"

#include "core/index.hpp"
#include "screw/screw_record.hpp"

namespace kinestat {

namespace {

struct BodyDynamicsView {
  const BodyDynamics& body;
  const LocalOrigin& origin;
};

const Record<BodyDynamicsView>& body_record() {
  static const Record<BodyDynamicsView> record(
      "The inertia of one body.", [](Record<BodyDynamicsView>& keys) {
        using enum QuantityKind;
        keys.vector("angular_acceleration",
                    QuantityKind::angular_acceleration,
                    "Angular acceleration.",
                    [](const BodyDynamicsView& v) { return v.body.angular_acceleration; });
        keys.vector("centre_acceleration",
                    acceleration,
                    "Acceleration of the centre of mass.",
                    [](const BodyDynamicsView& v) { return v.body.centre_acceleration; });
        keys.vector("at", length, "The centre of mass.", [](const BodyDynamicsView& v) {
          return v.origin.in_world(v.body.centre);
        });
        keys.sixfold("inertial_wrench",
                     moment,
                     force,
                     "D'Alembert couple about the origin and force: what the body exerts because "
                     "it accelerates. For planets, all of them together.",
                     [](const BodyDynamicsView& v) {
                       return sixfold_of(about_world(v.body.inertial, v.origin));
                     });
        keys.quantity("kinetic_energy", energy, "Kinetic energy.", [](const BodyDynamicsView& v) {
          return v.body.kinetic_energy;
        });
      });
  return record;
}

// A drive of the reduced equation.
struct ReducedView {
  const Topology& topology;
  const ReducedEquation& equation;
  Eigen::Index drive = 0;

  bool turns() const {
    return topology.freedoms[at(equation.drives[static_cast<std::size_t>(drive)])].is_rotation;
  }
};

void emit_shared(const ReducedView& v, const EachNumber& each) {
  for (std::size_t k = 0; k < v.equation.drives.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    if (column != v.drive) {
      each(v.topology.freedom_name(v.equation.drives[k]),
           v.equation.inertia(v.drive, column),
           QuantityKind::dimensionless);
    }
  }
}

const Record<ReducedView>& reduced_record() {
  static const Record<ReducedView> record(
      "The inertia that the drive must accelerate: its row of M q'' + h = "
      "Q.",
      [](Record<ReducedView>& keys) {
        using enum QuantityKind;
        const auto turns = [](const ReducedView& v) { return v.turns(); };
        const auto slides = [](const ReducedView& v) { return !v.turns(); };
        const auto own = [](const ReducedView& v) { return v.equation.inertia(v.drive, v.drive); };
        const auto bias = [](const ReducedView& v) { return v.equation.bias[v.drive]; };
        const auto derivative = [](const ReducedView& v) { return v.equation.derivative; };
        const auto speeds_up = [](const ReducedView& v) {
          return v.equation.accelerations[static_cast<std::size_t>(v.drive)];
        };
        keys.quantity("angular_acceleration",
                      angular_acceleration,
                      "Angular acceleration of a rotating drive.",
                      speeds_up)
            .only_if(turns);
        keys.quantity("acceleration", acceleration, "Acceleration of a sliding drive.", speeds_up)
            .only_if(slides);
        keys.quantity("inertia",
                      inertia,
                      "The equivalent moment of inertia of the whole mechanism at a drive that "
                      "turns.",
                      own)
            .only_if(turns);
        keys.quantity("mass",
                      mass,
                      "The equivalent mass of the whole mechanism at a drive that slides.",
                      own)
            .only_if(slides);
        keys.quantity("bias_moment",
                      moment,
                      "The action that inertia forces require of a rotating drive at constant "
                      "speed.",
                      bias)
            .only_if(turns);
        keys.quantity("bias_force",
                      force,
                      "The action that inertia forces require of a sliding drive at constant "
                      "speed.",
                      bias)
            .only_if(slides);
        keys.number("derivative",
                    Bare::number,
                    "How the equivalent inertia or mass changes with the position of the drive, "
                    "kg*m^2 per rad or kg per m; null at rest and with several drives.",
                    derivative);
        keys.numbers("shared",
                     Bare::number,
                     "Of several drives, the entries of M with the others, in SI units; no key of "
                     "one drive.",
                     emit_shared)
            .only_if([](const ReducedView& v) { return v.equation.drives.size() > 1; });
      });
  return record;
}

void emit_bodies(const DynamicsView& v, const Each<BodyDynamicsView>& each) {
  for (const BodyDynamics& body : v.dynamics.bodies) {
    each(v.mechanism.topology.body(body.body).name,
         {.body = body, .origin = v.mechanism.geometry.origin});
  }
}

void emit_reduced(const DynamicsView& v, const Each<ReducedView>& each) {
  if (!v.dynamics.reduced) {
    return;
  }
  const ReducedEquation& equation = *v.dynamics.reduced;
  for (std::size_t d = 0; d < equation.drives.size(); ++d) {
    each(v.mechanism.topology.freedom_name(equation.drives[d]),
         {.topology = v.mechanism.topology,
          .equation = equation,
          .drive = static_cast<Eigen::Index>(d)});
  }
}

std::optional<Sixfold> in_world(const DynamicsView& v, const std::optional<Wrench>& wrench) {
  return wrench ? std::optional(sixfold_of(about_world(*wrench, v.mechanism.geometry.origin)))
                : std::nullopt;
}

}  // namespace

const Record<DynamicsView>& dynamics_record() {
  static const Record<DynamicsView> record(
      "The effects of inertia; only in cases with 'acceleration'.", [](Record<DynamicsView>& keys) {
        using enum QuantityKind;
        keys.quantity("kinetic_energy", energy, "Of all bodies.", [](const DynamicsView& v) {
          return v.dynamics.kinetic_energy;
        });
        keys.quantity(
            "kinetic_energy_rate", power, "How fast it grows.", [](const DynamicsView& v) {
              return v.dynamics.kinetic_energy_rate;
            });
        keys.map("bodies", body_record(), "Every body with mass or inertia.", emit_bodies)
            .in_tables_as("body");
        keys.sixfold(
            "shaking",
            moment,
            force,
            "Shaking wrench, the sum of all inertia forces: couple about the origin and "
            "force, of planets with a count at the places of all; null where the axis about "
            "which these stand turns over.",
            [](const DynamicsView& v) { return in_world(v, v.dynamics.shaking); });
        keys.sixfold("ground",
                     moment,
                     force,
                     "What all couplings and springs exert on the ground: couple about the origin "
                     "and force; likewise, and null where a load acts on planets with a count.",
                     [](const DynamicsView& v) { return in_world(v, v.dynamics.ground); });
        keys.map("reduced", reduced_record(), "By the freedoms that the case drives.", emit_reduced)
            .in_tables_as("reduced");
        keys.number("two_ways",
                    Bare::number,
                    "By how much equilibrium and virtual power differ, relative to the largest "
                    "term; null where some action is open.",
                    [](const DynamicsView& v) { return v.dynamics.two_ways; })
            .at_least(0)
            .not_in_tables()
            .not_compared();
      });
  return record;
}

}  // namespace kinestat
