#include "screw/screw_record.hpp"

namespace kinestat {

const Record<AxisView>& axis_record() {
  static const Record<AxisView> record("Axis and pitch.", [](Record<AxisView>& keys) {
    keys.vector("direction",
                Bare::direction,
                "Unit vector along the axis; without unit.",
                [](const AxisView& v) { return v.axis.direction; });
    keys.vector("point",
                QuantityKind::length,
                "Point of the axis next to the origin; null for infinite pitch.",
                [](const AxisView& v) {
                  return v.axis.point ? std::optional(v.origin.in_world(*v.axis.point))
                                      : std::nullopt;
                });
    keys.quantity("pitch",
                  QuantityKind::length,
                  "Pitch (per radian, or moment per force); null for infinite pitch.",
                  [](const AxisView& v) { return v.axis.pitch; });
  });
  return record;
}

std::optional<AxisView> view_of(const std::optional<ScrewAxis>& axis, const LocalOrigin& origin) {
  return axis ? std::optional(AxisView{.axis = *axis, .origin = origin}) : std::nullopt;
}

Sixfold sixfold_of(const Twist& twist) {
  return {.first = twist.angular, .second = twist.linear};
}

Sixfold sixfold_of(const Wrench& wrench) {
  return {.first = wrench.moment, .second = wrench.force};
}

}  // namespace kinestat
