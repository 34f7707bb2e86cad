#include "studies/synthesis/curves/curve_record.hpp"

#include <optional>
#include <vector>

#include <fmt/format.h>

#include "studies/synthesis/dyads/dyad_record.hpp"
#include "studies/synthesis/positions/plane_record.hpp"

namespace kinestat {

namespace {

std::vector<std::optional<Point>> centres_of(const BranchView& v) {
  std::vector<std::optional<Point>> centres;
  for (const Point& one : v.branch.points) {
    const auto dyad = find_dyad(v.positions, one);
    const bool is_crank = dyad && dyad->kind == DyadKind::crank;
    centres.push_back(is_crank ? std::optional(dyad->centre_point) : std::nullopt);
  }
  return centres;
}

// About the origin and in the file's unit of length.
const Record<PlaneCubic>& coefficients_record() {
  using View = PlaneCubic;
  static const Record<View> record(
      "In the file's unit of length, the largest 1.", [](Record<View>& keys) {
        const auto add = [&](const char* key, auto get) {
          keys.number(key, ByContext::relative, fmt::format("Coefficient {}.", key), get);
        };
        add("k1", [](const View& v) { return v.k[0]; });
        add("k2", [](const View& v) { return v.k[1]; });
        add("q11", [](const View& v) { return v.q[0]; });
        add("q12", [](const View& v) { return v.q[1]; });
        add("q22", [](const View& v) { return v.q[2]; });
        add("l1", [](const View& v) { return v.l[0]; });
        add("l2", [](const View& v) { return v.l[1]; });
        add("c", [](const View& v) { return v.c; });
      });
  return record;
}

const Record<PlaneLine>& asymptote_record() {
  static const Record<PlaneLine> record(
      "The real asymptote: normal . (x, y) = offset.", [](Record<PlaneLine>& keys) {
        add_point(keys, "normal", Bare::direction, "Its normal.", [](const PlaneLine& v) {
          return v.normal;
        });
        keys.quantity("offset",
                      QuantityKind::length,
                      "Its distance from the origin.",
                      [](const PlaneLine& v) { return std::optional(v.offset); });
      });
  return record;
}

struct CubicView {
  const PlaneCubic& cubic;
  std::span<const PositionJets> positions;  // of circle points
  const CurveWindow& window;
  const FileUnits& units;
};

void emit_branches(const CubicView& v, const Each<BranchView>& each) {
  for (const CurveBranch& branch :
       sample(v.cubic, v.window.middle, v.window.radius, v.window.count)) {
    each({.branch = branch, .positions = v.positions});
  }
}

const Record<CubicView>& cubic_record() {
  using View = CubicView;
  static const Record<View> record(
      "(x^2+y^2)(k1 x+k2 y)+q11 x^2+q12 xy+q22 y^2+l1 x+l2 y+c=0 in the fixed frame at the first "
      "position.",
      [](Record<View>& keys) {
        // Their common factor hangs on the unit; focus, asymptote and points tell the curve.
        keys.part("coefficients",
                  coefficients_record(),
                  [](const View& v) {
                    return v.cubic.settled_about({0.0, 0.0}, v.units.factor(QuantityKind::length));
                  })
            .not_compared();
        add_point(keys, "focus", QuantityKind::length, "The singular focus.", [](const View& v) {
          return v.cubic.focus();
        });
        keys.part(
            "asymptote", asymptote_record(), [](const View& v) { return v.cubic.asymptote(); });
        keys.list(
            "branches", branch_record(), "Within four times the size of the task.", emit_branches);
      });
  return record;
}

std::optional<CubicView> drawn_cubic(const CurvesView& v,
                                     const PlaneCubic& cubic,
                                     std::span<const PositionJets> positions) {
  return v.curves.status == BurmesterStatus::solved
             ? std::optional(CubicView{
                   .cubic = cubic, .positions = positions, .window = v.window, .units = v.units})
             : std::nullopt;
}

void add_status(Record<CurvesView>& keys) {
  using View = CurvesView;
  keys.word("status",
            words_up_to(BurmesterStatus::no_digits),
            "family: every point, see reason.",
            [](const View& v) { return word_of(v.curves.status); });
  keys.word("reason",
            words_after_none(Degeneracy::shared_conic),
            "Why there is no curve; null where there is one.",
            [](const View& v) { return word_unless_none(v.curves.reason); });
  keys.number("digits",
              Bare::number,
              "Decimal digits that the data leave, estimated.",
              [](const View& v) { return v.curves.digits; })
      .not_compared();
  keys.number("reciprocal_condition",
              Bare::number,
              "Smallest over largest singular value of the conditions.",
              [](const View& v) { return v.curves.reciprocal_condition; })
      .not_compared();
}

}  // namespace

const Record<BranchView>& branch_record() {
  using View = BranchView;
  static const Record<View> record("A curve as points.", [](Record<View>& keys) {
    keys.flag(
        "closed", "Whether the curve is closed.", [](const View& v) { return v.branch.is_closed; });
    add_points(keys, "points", "In order.", [](const View& v) -> const std::vector<Point>& {
      return v.branch.points;
    });
    add_points(keys,
               "centres",
               "Of a curve of circle points: the centre of each of its points, fixed frame; null "
               "where it is at infinity.",
               centres_of)
        .only_if([](const View& v) { return !v.positions.empty(); });
  });
  return record;
}

const Record<CurvesView>& curves_record() {
  using View = CurvesView;
  static const Record<View> record("What four positions leave open.", [](Record<View>& keys) {
    add_status(keys);
    keys.part("circle_points",
              cubic_record(),
              "Points of the moving plane that stay on circles: " + cubic_record().meaning,
              [](const View& v) { return drawn_cubic(v, v.curves.circle_points, v.positions); });
    keys.part("centre_points",
              cubic_record(),
              "Their centres: " + cubic_record().meaning,
              [](const View& v) { return drawn_cubic(v, v.curves.centre_points, {}); });
    keys.part(
        "slider", dyad_record(), "The only slider.", [](const View& v) { return v.curves.slider; });
    keys.part("inverted_slider", dyad_record(), "The only inverted slider.", [](const View& v) {
      return v.curves.inverted_slider;
    });
  });
  return record;
}

}  // namespace kinestat
