#include "mechanism/label_kind.hpp"
#include "screw/screw_record.hpp"
#include "studies/mobility/mobility_counts_record.hpp"

namespace kinestat {

namespace {

struct FreeBodyView {
  Twist twist;  // about the origin of the geometry
  std::optional<ScrewAxis> axis;
  LocalOrigin origin;
};

const Record<FreeBodyView>& free_body_record() {
  using View = FreeBodyView;
  static const Record<View> record("One body.", [](Record<View>& keys) {
    keys.sixfold("twist",
                 QuantityKind::angular_velocity,
                 QuantityKind::velocity,
                 "Angular velocity, then velocity of the point at the world origin.",
                 [](const View& v) { return sixfold_of(about_world(v.twist, v.origin)); });
    keys.part("screw", axis_record(), [](const View& v) { return view_of(v.axis, v.origin); });
  });
  return record;
}

QuantityKind first_kind(const FreeMotionView& v) {
  const auto first = static_cast<std::size_t>(v.motion.first);
  return kind_of(v.mechanism.topology.freedoms[first]);
}

// [rad/s or m/s]: that the first freedom moves by one unit of the file.
double first_rate(const FreeMotionView& v) {
  return v.units.factor(first_kind(v));
}

void emit_rates(const FreeMotionView& v, const EachNumber& each) {
  const Topology& topology = v.mechanism.topology;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    if (v.motion.rates[f] != 0.0) {
      each(topology.freedom_name(f),
           v.motion.rates[f] * first_rate(v),
           kind_of(topology.freedoms[static_cast<std::size_t>(f)]));
    }
  }
}

void emit_bodies(const FreeMotionView& v, const Each<FreeBodyView>& each) {
  const Geometry& geometry = v.mechanism.geometry;
  for (std::size_t b = 1; b < v.mechanism.topology.bodies.size(); ++b) {
    each(v.mechanism.topology.bodies[b].name,
         {.twist = first_rate(v) * v.motion.bodies[b],
          .axis = v.motion.axis_of(b, geometry.length),
          .origin = geometry.origin});
  }
}

}  // namespace

const Record<FreeMotionView>& free_motion_record() {
  using View = FreeMotionView;
  static const Record<View> record(
      "One motion; its first freedom, actuators before others, has the rate 1.",
      [](Record<View>& keys) {
        keys.flag("passive", "Whether it moves no other body and no actuator.", [](const View& v) {
          return v.motion.is_passive();
        });
        keys.text("per",
                  "The unit of the first freedom: the rates are for 1 of it.",
                  [](const View& v) { return v.units.text(first_kind(v)); })
            .reference_unit()
            .not_compared();
        keys.numbers("freedoms",
                     ByContext::rate,
                     "Rates by the name of the freedom, in the units of the file; those at rest "
                     "are left out.",
                     emit_rates);
        keys.map("bodies", free_body_record(), "Moving bodies by name.", emit_bodies);
      });
  return record;
}

}  // namespace kinestat
