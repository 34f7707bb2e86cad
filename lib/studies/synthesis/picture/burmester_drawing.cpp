#include "studies/synthesis/picture/burmester_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/spelling.hpp"
#include "draw/axes.hpp"
#include "draw/name_placer.hpp"
#include "draw/picture_title.hpp"
#include "draw/symbols.hpp"
#include "draw/text_styles.hpp"
#include "draw/text_width.hpp"
#include "studies/synthesis/curves/cubic_branches.hpp"
#include "studies/synthesis/picture/burmester_plane.hpp"

namespace kinestat {

namespace {

constexpr int kCurvePoints = 700;
constexpr TextStyle kName = {
    .ink = Ink::ink, .size = 12.5, .weight = Weight::bold, .has_halo = true};

// Neighbouring points of a curve that share a reason.
struct Stretch {
  std::string reason;
  std::vector<PixelPoint> points;
};

class BurmesterWriter {
 public:
  BurmesterWriter(const SynthesisAnalysis& analysis, const SynthesisTask& task, double size)
      : analysis_(analysis), task_(task), plane_(find_plane(task)), size_(size) {
    const Point whole = plane_.window.high - plane_.window.low;
    scale_ = size / std::max(whole.real(), whole.imag());
  }

  Svg write() {
    svg_.keep_lines();
    draw_frame();
    draw_circle();
    for (std::size_t i = 0; i < plane_.curves.size(); ++i) {
      draw_curves(plane_.curves[i], i == 0);
    }
    for (const DrawnDyad& dyad : plane_.dyads) {
      draw_dyad(dyad);
    }
    draw_coupler();
    draw_positions();
    draw_poles();
    write_names();
    draw_legend();
    return std::move(svg_);
  }

 private:
  PixelPoint at(const Point& p) const {
    const Point from = p - plane_.window.low;
    return {.x = scale_ * from.real(), .y = -scale_ * from.imag()};
  }

  PixelPoint along(const Point& direction) const {
    return {.x = direction.real(), .y = -direction.imag()};
  }

  void name(std::string text, const Point& p) { names_.emplace_back(std::move(text), at(p)); }

  // With ticks in the unit of the file.
  void draw_frame() {
    const FileUnits& units = analysis_.description.units;
    const PixelPoint corner = at(plane_.window.high);
    svg_.rectangle({.left = 0.0, .top = corner.y, .right = corner.x, .bottom = 0.0},
                   {.stroke = Ink::soft, .width = 1.0});
    const auto unit = [&units](double length) {
      return units.from_si(QuantityKind::length, length);
    };
    const Point low(unit(plane_.window.low.real()), unit(plane_.window.low.imag()));
    const Point high(unit(plane_.window.high.real()), unit(plane_.window.high.imag()));
    const AxisRange across =
        tight_axis({.low = low.real(), .high = high.real(), .tick_count = 6, .in_degrees = false});
    for (const Tick& tick : across.ticks) {
      const double x = corner.x * across.share(tick.value);
      svg_.line({.x = x, .y = 0}, {.x = x, .y = corner.y}, {.stroke = Ink::grid, .width = 0.7});
      TextStyle style = kSmall;
      style.anchor = Anchor::middle;
      svg_.text({.x = x, .y = 15}, tick.label, style);
    }
    const AxisRange up =
        tight_axis({.low = low.imag(), .high = high.imag(), .tick_count = 6, .in_degrees = false});
    for (const Tick& tick : up.ticks) {
      const double y = corner.y * up.share(tick.value);
      svg_.line({.x = 0, .y = y}, {.x = corner.x, .y = y}, {.stroke = Ink::grid, .width = 0.7});
      TextStyle style = kSmall;
      style.anchor = Anchor::end;
      svg_.text({.x = -6, .y = y + 4}, tick.label, style);
    }
    const auto power = [](int exponent) {
      return exponent == 0 ? std::string() : power_of_ten(exponent) + " ";
    };
    const std::string& text = units.text(QuantityKind::length);
    TextStyle at_end = kSmall;
    at_end.anchor = Anchor::end;
    svg_.text(
        {.x = corner.x, .y = 30}, fmt::format("x [{}{}]", power(across.exponent), text), at_end);
    svg_.text(
        {.x = 0, .y = corner.y - 8}, fmt::format("y [{}{}]", power(up.exponent), text), kSmall);
  }

  void draw_circle() {
    if (!plane_.circle) {
      return;
    }
    const double radius = scale_ * plane_.circle->radius;
    std::vector<PixelPoint> points;
    for (PixelPoint p : arc_points(
             at(plane_.circle->centre), std::min(radius, 100 * size_), 0.0, 2 * std::numbers::pi)) {
      points.push_back(within(p) ? p : gap());
    }
    svg_.polyline(points, {.stroke = Ink::pink, .width = 1.3, .dash = "10 3 2 3"});
    if (plane_.ball && plane_.window.holds(*plane_.ball)) {
      svg_.circle(at(*plane_.ball), 3.5, {.stroke = Ink::none, .fill = Ink::pink});
      name("Ball", *plane_.ball);
    }
  }

  static PixelPoint gap() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {.x = kNone, .y = kNone};
  }

  bool within(PixelPoint p) const {
    const PixelPoint corner = at(plane_.window.high);
    return p.x >= 0.0 && p.x <= corner.x && p.y <= 0.0 && p.y >= corner.y;
  }

  std::vector<CurveBranch> branches(const PlaneCubic& cubic) const {
    const Point half = (plane_.window.high - plane_.window.low) / 2.0;
    std::vector<CurveBranch> result =
        sample(cubic, plane_.window.middle(), 1.05 * std::abs(half), kCurvePoints);
    for (CurveBranch& branch : result) {
      if (branch.is_closed && !branch.points.empty()) {
        branch.points.push_back(branch.points.front());
      }
    }
    return result;
  }

  // Where a curve leaves the window it is cut at the point before.
  std::vector<PixelPoint> visible(const CurveBranch& branch) const {
    std::vector<PixelPoint> points;
    for (const Point& p : branch.points) {
      points.push_back(plane_.window.holds(p) ? at(p) : gap());
    }
    return points;
  }

  void draw_curves(const DrawnCurves& drawn, bool is_first) {
    const double width = is_first ? 1.9 : 1.0;
    for (const CurveBranch& branch : branches(drawn.curves.centre_points)) {
      svg_.polyline(visible(branch), {.stroke = Ink::green, .width = width, .dash = "6 3"});
    }
    // Of five positions the curve of four on which the best linkage stands.
    const bool is_judged = is_first && (task_.curves.has_value() || partner());
    for (const CurveBranch& branch : branches(drawn.curves.circle_points)) {
      if (is_judged) {
        draw_judged(branch, drawn.positions);
      } else {
        svg_.polyline(visible(branch), {.stroke = Ink::blue, .width = width});
      }
    }
    if (const auto focus = drawn.curves.circle_points.focus();
        is_first && focus && plane_.window.holds(*focus)) {
      svg_.circle(at(*focus), 2.2, {.stroke = Ink::blue});
    }
  }

  std::optional<Dyad> partner() const {
    return task_.linkages.empty() ? std::nullopt
                                  : std::optional(task_.linkages.front().linkage.one);
  }

  // Stretches with a defect are grey and dashed, and bear its word where there is room.
  void draw_judged(const CurveBranch& branch, const std::vector<PositionJets>& positions) {
    std::vector<Stretch> stretches;
    for (const Point& p : branch.points) {
      if (!plane_.window.holds(p)) {
        stretches.emplace_back();
        continue;
      }
      const std::string reason =
          in_words(find_rejection(positions, analysis_.limits, partner(), p));
      if (stretches.empty() || stretches.back().points.empty() ||
          stretches.back().reason != reason) {
        Stretch next{.reason = reason, .points = {}};
        if (!stretches.empty() && !stretches.back().points.empty()) {
          next.points.push_back(stretches.back().points.back());
        }
        stretches.push_back(std::move(next));
      }
      stretches.back().points.push_back(at(p));
    }
    for (const Stretch& stretch : stretches) {
      draw_stretch(stretch);
    }
  }

  void draw_stretch(const Stretch& stretch) {
    if (stretch.points.size() < 2) {
      return;
    }
    if (stretch.reason.empty()) {
      svg_.polyline(stretch.points, {.stroke = Ink::blue, .width = 2.4});
      return;
    }
    rejected_[stretch.reason] += static_cast<int>(stretch.points.size());
    svg_.open_group(stretch.reason);
    svg_.polyline(stretch.points, {.stroke = Ink::soft, .width = 1.6, .dash = "3 3"});
    svg_.close_group();
    constexpr std::size_t kWorthAWord = 18;
    if (stretch.points.size() >= kWorthAWord) {
      reasons_.emplace_back(stretch.reason, stretch.points[stretch.points.size() / 2]);
    }
  }

  // Cranks as bars on their centre, sliders as blocks on their line.
  void draw_dyad(const DrawnDyad& drawn) {
    const double width = drawn.is_chosen ? 5.0 : 1.2;
    const Ink ink = drawn.is_chosen ? Ink::vermilion : Ink::soft;
    const PixelPoint circle = at(drawn.circle_point);
    const bool is_seen = plane_.window.holds(drawn.circle_point);
    svg_.open_group(fmt::format("dyad {}", drawn.letter));
    if (drawn.dyad.kind == DyadKind::crank) {
      const bool is_whole = is_seen && plane_.window.holds(drawn.centre_point);
      if (is_whole) {
        bar(at(drawn.centre_point), circle, ink, width, drawn.is_chosen);
      }
      if (plane_.window.holds(drawn.centre_point)) {
        draw_support(svg_, at(drawn.centre_point));
        draw_pin(svg_, at(drawn.centre_point), 3.2);
        name(fmt::format("{}0", drawn.letter), drawn.centre_point);
      }
    } else if (drawn.dyad.kind == DyadKind::slider && is_seen) {
      draw_guided_block(circle, along(drawn.direction), ink);
    } else if (plane_.window.holds(drawn.centre_point)) {
      // A line of the plane slides through a block that turns on the centre point.
      const PixelPoint centre = at(drawn.centre_point);
      draw_support(svg_, centre);
      draw_guided_block(centre, along(drawn.direction), ink);
      draw_pin(svg_, centre, 3.2);
      name(fmt::format("{}0", drawn.letter), drawn.centre_point);
      svg_.close_group();
      return;
    }
    if (is_seen) {
      draw_pin(svg_, circle, drawn.is_chosen ? 4.0 : 3.0);
      name(std::string(1, drawn.letter), drawn.circle_point);
    }
    svg_.close_group();
  }

  void draw_guided_block(PixelPoint p, PixelPoint direction, Ink ink) {
    const PixelPoint half = 70.0 * direction;
    svg_.line(p - half, p + half, {.stroke = ink, .width = 1.0, .dash = "9 3"});
    draw_block(svg_, p, direction, {.stroke = ink, .fill = Ink::paper});
  }

  void bar(PixelPoint from, PixelPoint to, Ink ink, double width, bool is_wide) {
    if (!is_wide) {
      svg_.line(from, to, {.stroke = ink, .width = width});
      return;
    }
    const std::array<Round, 2> ends = {
        {{.centre = from, .radius = width}, {.centre = to, .radius = width}}};
    svg_.polygon(rounded_hull(ends), {.stroke = ink, .fill = ink, .width = 1.4, .opacity = 0.18});
  }

  // Of the chosen linkage: from circle point to circle point, with the origin of the moving frame.
  void draw_coupler() {
    std::vector<Round> rounds = {{.centre = at(origin(task_.positions.front())), .radius = 5.0}};
    for (const DrawnDyad& dyad : plane_.dyads) {
      const Point& joined =
          dyad.dyad.kind == DyadKind::inverted_slider ? dyad.centre_point : dyad.circle_point;
      if (dyad.is_chosen && plane_.window.holds(joined)) {
        rounds.push_back({.centre = at(joined), .radius = 5.0});
      }
    }
    if (rounds.size() > 2) {
      svg_.polygon(rounded_hull(rounds),
                   {.stroke = Ink::brown, .fill = Ink::brown, .width = 1.3, .opacity = 0.14});
    }
  }

  // A dot in the origin of the moving frame, and an arrow along its x axis.
  void draw_positions() {
    for (std::size_t i = 0; i < task_.positions.size(); ++i) {
      const PositionJets& position = task_.positions[i];
      const PixelPoint from = at(origin(position));
      const PixelPoint to = from + 36.0 * along(unit_vector(position.angle.front()));
      svg_.arrow(from, to, {.stroke = Ink::ink, .width = 2.2}, 9.0);
      svg_.circle(from, 4.0, {.stroke = Ink::ink, .fill = Ink::ink});
      std::string text = fmt::format("{}", i + 1);
      if (position.order() > 1) {
        text += " " + std::string(static_cast<std::size_t>(position.order()), 'P');
      }
      name(std::move(text), origin(position));
    }
  }

  void draw_cross(PixelPoint p) {
    for (const double side : {-1.0, 1.0}) {
      const PixelPoint half = {.x = 4.5, .y = 4.5 * side};
      svg_.line(p - half, p + half, {.stroke = Ink::ink, .width = 1.5});
    }
  }

  void draw_poles() {
    for (const NamedPoint& pole : plane_.poles) {
      if (!plane_.window.holds(pole.at)) {
        continue;
      }
      svg_.open_group(pole.name);
      draw_cross(at(pole.at));
      svg_.close_group();
      name(pole.name, pole.at);
    }
  }

  void write_names() {
    PixelBox area;
    area.add(at(plane_.window.low));
    area.add(at(plane_.window.high));
    NamePlacer placer(area.grown(-3.0));
    placer.keep_off(svg_.lines());
    // What has no room is told under the pointer alone.
    for (const auto& [text, p] : names_) {
      if (const PlacedName label = placer.place(p, text, kName, 7.0); label.is_free) {
        write_label(svg_, label, text, kName);
      }
    }
    TextStyle style = kSmall;
    style.has_halo = true;
    for (const auto& [reason, p] : reasons_) {
      if (const PlacedName label = placer.place(p, reason, style, 5.0); label.is_free) {
        write_label(svg_, label, reason, style);
      }
    }
  }

  void legend_line(const Paint& paint, const std::string& words, double& y) {
    const double x = 0.0;
    svg_.line({.x = x, .y = y}, {.x = x + 28, .y = y}, paint);
    legend_words(words, x + 36, y);
  }

  // In as many lines as the size asks for.
  void legend_words(const std::string& words, double x, double& y) {
    for (const std::string& line : wrapped_text(words, kSmall.size, size_ - x)) {
      svg_.text({.x = x, .y = y + 4}, line, kSmall);
      y += 17.0;
    }
  }

  void draw_legend() {
    double y = std::max(42.0, svg_.bounds().bottom + 20.0);
    if (!plane_.curves.empty()) {
      std::string words = "circle points in the first position";
      if (!plane_.curves.front().without.empty()) {
        words += ", of all but " + plane_.curves.front().without;
      }
      if (plane_.curves.size() > 1) {
        words += "; thin: of all but " + plane_.curves[1].without;
      }
      legend_line({.stroke = Ink::blue, .width = 1.9}, words, y);
      legend_line({.stroke = Ink::green, .width = 1.9, .dash = "6 3"}, "centre points", y);
    }
    if (plane_.circle) {
      legend_line({.stroke = Ink::pink, .width = 1.3, .dash = "10 3 2 3"}, plane_.circle_name, y);
    }
    if (std::ranges::any_of(plane_.poles,
                            [&](const NamedPoint& pole) { return plane_.window.holds(pole.at); })) {
      draw_cross({.x = 14.0, .y = y});
      legend_words("poles of the moving plane", 36.0, y);
    }
    std::string reasons;
    for (const auto& [reason, count] : rejected_) {
      reasons += (reasons.empty() ? "" : ", ") + reason;
    }
    if (!reasons.empty()) {
      const std::string beside =
          partner() ? "rejected together with dyad A: " : "rejected as a crank that drives: ";
      legend_line({.stroke = Ink::soft, .width = 1.6, .dash = "3 3"}, beside + reasons, y);
    }
    draw_verdict(y);
  }

  // "A: dyad 1, B: dyad 3, C: dyad 0", by their numbers in the tables.
  std::string dyads_text() const {
    std::vector<std::string> names;
    for (const DrawnDyad& drawn : plane_.dyads) {
      for (std::size_t i = 0; task_.dyads && i < task_.dyads->dyads.size(); ++i) {
        if (is_same(task_.dyads->dyads[i], drawn.dyad)) {
          names.push_back(fmt::format("{}: dyad {}", drawn.letter, i));
        }
      }
    }
    return fmt::format("{}", fmt::join(names, ", "));
  }

  // What is wrong with the linkage that is drawn, if anything.
  void draw_verdict(double y) {
    const std::string dyads = dyads_text();
    if (!dyads.empty()) {
      legend_words(dyads, 0.0, y);
    }
    if (task_.linkages.empty()) {
      return;
    }
    const LinkageCandidate& best = task_.linkages.front();
    const std::string verdict =
        best.is_usable() ? std::string("usable") : "rejected: " + in_words(word_of(best.defect()));
    legend_words(
        fmt::format("linkage A, B: {}, {}", hyphenated(word_of(best.linkage.type())), verdict),
        0.0,
        y);
  }

  const SynthesisAnalysis& analysis_;
  const SynthesisTask& task_;
  BurmesterPlane plane_;
  double size_;         // of the longer side of the window [px]
  double scale_ = 1.0;  // [px/m]
  Svg svg_;
  std::vector<std::pair<std::string, PixelPoint>> names_;
  std::vector<std::pair<std::string, PixelPoint>> reasons_;
  std::map<std::string, int> rejected_;  // points by reason
};

}  // namespace

Picture draw_burmester(const SynthesisAnalysis& analysis, std::size_t task, double size) {
  KINESTAT_EXPECTS(task < analysis.tasks.size() && !analysis.tasks[task].positions.empty());
  const SynthesisTask& of = analysis.tasks[task];
  return make_picture("burmester",
                      fmt::format("Circle points and centre points: {}",
                                  shown_name(analysis.file, analysis.description)),
                      fmt::format("Positions {}, poles, curves and dyads in the fixed frame.",
                                  form_of(of.positions)),
                      BurmesterWriter(analysis, of, size).write());
}

}  // namespace kinestat
