#include "studies/synthesis/positions/position_record.hpp"

#include <optional>

#include "studies/synthesis/positions/path_curvature.hpp"
#include "studies/synthesis/positions/plane_record.hpp"

namespace kinestat {

namespace {

struct DerivativeView {
  const PositionJets& position;
  int order = 1;
};

const Record<DerivativeView>& derivative_record() {
  using View = DerivativeView;
  static const Record<View> record(
      "One derivative by the parameter, which is the angle in radians unless the file gives "
      "another.",
      [](Record<View>& keys) {
        add_point(keys, "at", QuantityKind::length, "Of the origin.", [](const View& v) {
          return origin(v.position, v.order);
        });
        keys.number("angle", Bare::number, "Of the angle in radians.", [](const View& v) {
          return v.position.angle[static_cast<std::size_t>(v.order)];
        });
      });
  return record;
}

struct FrameView {
  SpecialFrame frame;
  const FileUnits& units;
};

void add_stationary_curvature(Record<FrameView>& keys) {
  using View = FrameView;
  keys.converted("inverse_m",
                 ByContext::per_length,
                 "1/M of the cubic of stationary curvature.",
                 [](const View& v) {
                   const auto cubic = find_stationary_curvature(v.frame);
                   return per_length(cubic ? std::optional(cubic->inverse_m) : std::nullopt,
                                     v.units);
                 });
  keys.converted("inverse_n", ByContext::per_length, "1/N of it.", [](const View& v) {
    const auto cubic = find_stationary_curvature(v.frame);
    return per_length(cubic ? std::optional(cubic->inverse_n) : std::nullopt, v.units);
  });
  add_point(keys,
            "ball_point",
            QuantityKind::length,
            "The point with the straightest path.",
            [](const View& v) { return find_ball_point(v.frame); });
}

const Record<FrameView>& special_frame_record() {
  using View = FrameView;
  static const Record<View> record(
      "The instant seen from its pole: the origin is the pole, the y axis the pole normal; null "
      "below order 3.",
      [](Record<View>& keys) {
        keys.quantity(
            "diameter", QuantityKind::length, "Of the inflection circle.", [](const View& v) {
              return std::optional(v.frame.diameter);
            });
        keys.quantity("angle",
                      QuantityKind::angle,
                      "Of the pole tangent from the x axis.",
                      [](const View& v) { return v.frame.angle; });
        add_points(keys,
                   "derivatives",
                   "a_k and b_k of the point in the pole, by the angle, in this frame; order 0 "
                   "first.",
                   [](const View& v) -> const std::vector<Point>& { return v.frame.derivatives; });
        keys.part("inflection_circle",
                  circle_record(),
                  "Points whose paths have an inflection.",
                  [](const View& v) { return inflection_circle(v.frame); });
        keys.part("cuspidal_circle",
                  circle_record(),
                  "Its reflection at the pole tangent.",
                  [](const View& v) { return cuspidal_circle(v.frame); });
        add_stationary_curvature(keys);
      });
  return record;
}

// Of the path of the origin.
void write_curvature(const PositionView& v, Archive& to) {
  const PathCurvature curvature = find_path_curvature(v.position, {0.0, 0.0});
  to.begin_list();
  for (const auto& si : {curvature.k, curvature.k_prime, curvature.k_second}) {
    const auto [value, unit] = per_length(si, v.units);
    to.number(value, unit);
  }
  to.end_list();
}

}  // namespace

const Record<PositionView>& position_record() {
  using View = PositionView;
  static const Record<View> record("A group of coincident positions.", [](Record<View>& keys) {
    add_point(keys, "at", QuantityKind::length, "Origin of the moving frame.", [](const View& v) {
      return origin(v.position);
    });
    keys.quantity("angle", QuantityKind::angle, "Angle of the moving frame.", [](const View& v) {
      return v.position.angle[0];
    });
    keys.list("derivatives",
              derivative_record(),
              "The first derivative first.",
              [](const View& v, const Each<DerivativeView>& each) {
                for (int k = 1; k < v.position.order(); ++k) {
                  each({.position = v.position, .order = k});
                }
              });
    add_point(keys,
              "pole",
              QuantityKind::length,
              "About which the plane turns there; null if it is not prescribed or the plane does "
              "not turn.",
              [](const View& v) { return find_pole(v.position); });
    keys.custom("path_curvature",
                tuple_shape(number_shape(ByContext::per_length, true), 3, false),
                "K of the path of the origin, and K' and K'', its derivatives by the parameter of "
                "the position: the angle in radians, unless 'derivatives' of the file have an "
                "angle of their own.",
                write_curvature);
    keys.part("special_frame", special_frame_record(), [](const View& v) {
      auto frame = find_special_frame(v.position);
      return frame ? std::optional(FrameView{.frame = *std::move(frame), .units = v.units})
                   : std::nullopt;
    });
  });
  return record;
}

}  // namespace kinestat
