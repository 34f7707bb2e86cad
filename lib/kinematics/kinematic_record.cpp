#include "kinematics/kinematic_record.hpp"

#include "kinematics/bounded_motion.hpp"
#include "mechanism/label_kind.hpp"
#include "network/evidence_record.hpp"
#include "screw/screw_record.hpp"

namespace kinestat {

namespace {

// A body in motion relative to the ground.
struct BodyView {
  BoundedTwist twist;  // about the origin of the geometry
  bool knows_all = true;
  bool knows_turn = true;
  bool knows_linear = true;
  const Geometry& geometry;
  Vec3 reference = Vec3::Zero();  // [m], in the world
};

const Record<BodyView>& body_record() {
  static const Record<BodyView> record("Motion of one body.", [](Record<BodyView>& keys) {
    keys.sixfold("twist",
                 QuantityKind::angular_velocity,
                 QuantityKind::velocity,
                 "Angular velocity, then velocity of the point of the body at the origin.",
                 [](const BodyView& v) {
                   return sixfold_of(about_world(v.twist, v.geometry.origin).zeroed());
                 })
        .only_if([](const BodyView& v) { return v.knows_all; });
    keys.vector("angular",
                QuantityKind::angular_velocity,
                "Angular velocity.",
                [](const BodyView& v) { return v.twist.angular.zeroed(); })
        .only_if([](const BodyView& v) { return v.knows_turn; });
    keys.vector("linear",
                QuantityKind::velocity,
                "Velocity of the reference point.",
                [](const BodyView& v) { return velocity_at(v.twist, v.reference).zeroed(); })
        .only_if([](const BodyView& v) { return v.knows_linear; });
    keys.vector("at", QuantityKind::length, "The reference point.", [](const BodyView& v) {
      return v.geometry.origin.in_world(v.reference);
    });
    keys.part("screw",
              axis_record(),
              [](const BodyView& v) {
                return view_of(find_axis(v.twist, v.geometry.length), v.geometry.origin);
              })
        .only_if([](const BodyView& v) { return v.knows_all; });
  });
  return record;
}

bool is_solved(const KinematicView& v) {
  return v.motion.status == SolveStatus::solved;
}

void emit_rates(const KinematicView& v, const EachNumber& each) {
  const Topology& topology = v.mechanism.topology;
  for (std::size_t f = 0; f < topology.freedoms.size(); ++f) {
    each(topology.freedom_name(static_cast<int>(f)),
         is_solved(v) && v.motion.knows_rate(static_cast<int>(f)) ? std::optional(v.motion.rates[f])
                                                                  : std::nullopt,
         kind_of(topology.freedoms[f]));
  }
}

void emit_bodies(const KinematicView& v, const Each<BodyView>& each) {
  const Topology& topology = v.mechanism.topology;
  for (std::size_t b = 0; is_solved(v) && b < topology.bodies.size(); ++b) {
    const BodyId body{static_cast<int>(b)};
    const Geometry& geometry = v.mechanism.geometry;
    const Vec3& reference = geometry.references[b];
    each(topology.bodies[b].name,
         {.twist = bounded_body(v.motion, body),
          .knows_all = v.motion.knows_body(body),
          .knows_turn = v.motion.knows_turn(body, geometry.length),
          .knows_linear = v.motion.knows_velocity(body, reference, geometry.length),
          .geometry = geometry,
          .reference = reference});
  }
}

}  // namespace

const Record<KinematicView>& kinematic_record() {
  static const Record<KinematicView> record(
      "Velocities from the known motions.", [](Record<KinematicView>& keys) {
        keys.word("status",
                  words_up_to(SolveStatus::overflow),
                  "Whether the velocities are determined.",
                  [](const KinematicView& v) { return word_of(v.motion.status); })
            .in_tables_is(TableRole::status);
        keys.count("order",
                   "Order of the screw system in which the motions were solved.",
                   [](const KinematicView& v) { return v.motion.counts.order; })
            .not_in_tables();
        keys.count("net_freedom",
                   "Number of motions that must be known.",
                   [](const KinematicView& v) { return v.motion.counts.net_freedom; })
            .not_in_tables();
        keys.numbers("freedoms",
                     ByContext::rate,
                     "Rate of every freedom (head relative to tail) by coupling.freedom, in the "
                     "unit of angular velocity or of velocity; null where it is not determined.",
                     emit_rates)
            .in_tables_as("velocity");
        keys.map("bodies",
                 body_record(),
                 "Motion of every body relative to the ground; empty unless solved. Of a body that "
                 "can turn or slide without moving others, what that leaves determined.",
                 emit_bodies)
            .in_tables_as("");
        keys.part("evidence",
                  evidence_record(),
                  [](const KinematicView& v) {
                    return EvidenceView{.rank = v.motion.evidence,
                                        .answer = v.motion.answer,
                                        .residual = v.motion.residual,
                                        .is_answered = is_solved(v)};
                  })
            .not_in_tables()
            .not_compared();
      });
  return record;
}

}  // namespace kinestat
