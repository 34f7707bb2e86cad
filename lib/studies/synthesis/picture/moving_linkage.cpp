#include "studies/synthesis/picture/moving_linkage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include "draw/name_placer.hpp"
#include "draw/picture_title.hpp"
#include "draw/symbols.hpp"
#include "draw/text_styles.hpp"
#include "studies/synthesis/linkages/linkage_motion.hpp"
#include "studies/synthesis/report/linkage_text.hpp"

namespace kinestat {

namespace {

constexpr int kSteps = 180;
constexpr double kLongerSide = 380.0;  // of the longer side of what is drawn [px]

// A dyad as a body of its own: a crank, or the block of a slider or of an inverted one.
struct DyadBody {
  const Dyad& dyad;
  char letter = 'A';

  // Where the plane is joined to it, as the plane stands.
  Point joint(const Pose& pose) const {
    return dyad.kind == DyadKind::inverted_slider ? dyad.centre_point
                                                  : pose.place(dyad.circle_point);
  }

  PlanePose moved(const Pose& from, const Pose& to) const {
    if (dyad.kind == DyadKind::slider) {
      return {.shift = joint(to) - joint(from), .angle = 0.0};
    }
    const Point centre = dyad.centre_point;
    const double angle = dyad.kind == DyadKind::inverted_slider
                             ? to.angle - from.angle
                             : std::arg((joint(to) - centre) / (joint(from) - centre));
    return {.shift = centre - std::polar(1.0, angle) * centre, .angle = angle};
  }

  // Along the path of a slider; of an inverted one along its line, with this pose.
  Point direction(const Pose& pose) const {
    return dyad.kind == DyadKind::slider ? dyad.direction
                                         : dyad.direction * std::polar(1.0, pose.angle);
  }
};

class LinkageMover {
 public:
  LinkageMover(const SynthesisAnalysis& analysis, const SynthesisTask& task)
      : analysis_(analysis),
        best_(task.linkages.front()),
        first_(pose_of(task.positions_of(best_).front())),
        dyads_{{{.dyad = best_.linkage.one, .letter = 'A'},
                {.dyad = best_.linkage.other, .letter = 'B'}}} {
    for (const PositionJets& position : task.positions_of(best_)) {
      asked_.push_back(pose_of(position));
    }
    // What reaches to infinity is cut at some sizes of the task.
    double size = best_.longest;
    for (const Pose& pose : asked_) {
      size = std::max(size, std::abs(shown(pose) - shown(first_)));
    }
    motion_ = trace_circuit(best_.linkage, best_.best_drive, first_, kSteps, 2.0 * size);
    pass_through_positions();
    find_scale();
  }

  MovingLinkage run() {
    const auto first = std::ranges::find(at_position_, 0);
    MovingLinkage result{
        .picture = draw(),
        .bodies = {},
        .steps = {},
        .labels = {},
        .first = first != at_position_.end() ? static_cast<int>(first - at_position_.begin()) : -1,
        .is_closed = motion_.is_closed,
        .input = fmt::format("{0}0{0}", input().letter)};
    result.bodies = {"plane", "dyad-A", "dyad-B"};
    for (std::size_t s = 0; s < motion_.poses.size(); ++s) {
      const Pose& pose = motion_.poses[s];
      const double angle = pose.angle - first_.angle;
      const PlanePose plane{.shift = pose.origin - std::polar(1.0, angle) * first_.origin,
                            .angle = angle};
      result.steps.push_back({plane, dyads_[0].moved(first_, pose), dyads_[1].moved(first_, pose)});
      result.labels.push_back(
          input_text(pose) +
          (at_position_[s] < 0 ? "" : fmt::format(", position {}", at_position_[s] + 1)));
    }
    return result;
  }

 private:
  // The watched point of the coupler.
  Point shown(const Pose& pose) const { return pose.place(best_.tracer()); }

  const DyadBody& input() const { return dyads_[best_.best_drive == Drive::one ? 0 : 1]; }

  PixelPoint at(const Point& p) const {
    return {.x = x0_ + scale_ * p.real(), .y = y0_ - scale_ * p.imag()};
  }

  static PixelPoint along(const Point& direction) {
    return {.x = direction.real(), .y = -direction.imag()};
  }

  void find_scale() {
    Point low(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
    Point high = -low;
    const auto add = [&](const Point& p) {
      low = {std::min(low.real(), p.real()), std::min(low.imag(), p.imag())};
      high = {std::max(high.real(), p.real()), std::max(high.imag(), p.imag())};
    };
    for (const std::vector<Pose>* poses : {&motion_.poses, &asked_}) {
      for (const Pose& pose : *poses) {
        add(shown(pose));
        add(dyads_[0].joint(pose));
        add(dyads_[1].joint(pose));
      }
    }
    for (const DyadBody& one : dyads_) {
      if (one.dyad.kind == DyadKind::crank) {
        add(one.dyad.centre_point);
      }
    }
    const Point size = high - low;
    const double longer = std::max(size.real(), size.imag());
    scale_ = longer > 0.0 ? kLongerSide / longer : kLongerSide;
    x0_ = -scale_ * low.real();
    y0_ = scale_ * high.imag();
  }

  std::vector<Round> plane_rounds(const Pose& pose) const {
    std::vector<Round> rounds;
    for (const Point& p : {shown(pose), dyads_[0].joint(pose), dyads_[1].joint(pose)}) {
      rounds.push_back({.centre = at(p), .radius = 5.0});
    }
    return rounds;
  }

  Picture draw() {
    const std::array<Attribute, 3> marks = {{{"data-scale", fmt::format("{}", scale_)},
                                             {"data-x0", fmt::format("{}", x0_)},
                                             {"data-y0", fmt::format("{}", y0_)}}};
    svg_.keep_lines();
    svg_.open_group({}, marks);
    draw_paths();
    draw_asked();
    for (const DyadBody& one : dyads_) {
      draw_ground(one);
    }
    draw_plane();
    for (const DyadBody& one : dyads_) {
      draw_dyad(one);
    }
    write_names();
    svg_.close_group();
    return make_picture(
        "synthesis-motion",
        fmt::format("{}: {}",
                    best_.is_usable()
                        ? "The best linkage through its positions"
                        : "The nearest linkage, which is not usable, and the positions",
                    shown_name(analysis_.file, analysis_.description)),
        fmt::format("The linkage in the first of {} positions, and the path of {}.",
                    asked_.size(),
                    traced_text(analysis_)),
        svg_);
  }

  // The plane in each position, faintly, with the x axis of its frame if this was asked for.
  void draw_asked() {
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      const Pose& pose = asked_[i];
      svg_.open_group(fmt::format("position {}", i + 1));
      svg_.polygon(rounded_hull(plane_rounds(pose)),
                   {.stroke = Ink::soft, .width = 0.8, .dash = "3 3"});
      const PixelPoint from = at(shown(pose));
      const PixelPoint to = from + 30.0 * along(std::polar(1.0, pose.angle));
      if (best_.positions.empty()) {
        svg_.arrow(from, to, {.stroke = Ink::ink, .width = 1.8}, 8.0);
      }
      svg_.circle(from, 3.2, {.stroke = Ink::ink, .fill = Ink::ink});
      svg_.close_group();
      names_.emplace_back(fmt::format("{}", i + 1), from);
    }
  }

  // Those of the joints behind, so that the picture is as large as the motion.
  void draw_paths() {
    for (const DyadBody& one : dyads_) {
      draw_path([&](const Pose& pose) { return one.joint(pose); },
                {.stroke = Ink::grid, .width = 1.0});
    }
    draw_path([&](const Pose& pose) { return shown(pose); },
              {.stroke = Ink::blue, .width = 1.4, .dash = "7 3"});
  }

  template <class PointOf>
  void draw_path(const PointOf& point_of, const Paint& paint) {
    std::vector<PixelPoint> points;
    for (const Pose& pose : motion_.poses) {
      points.push_back(at(point_of(pose)));
    }
    if (motion_.is_closed) {
      points.push_back(points.front());
    }
    svg_.polyline(points, paint);
  }

  void draw_ground(const DyadBody& one) {
    if (one.dyad.kind != DyadKind::slider) {
      const PixelPoint centre = at(one.dyad.centre_point);
      draw_support(svg_, centre);
      names_.emplace_back(fmt::format("{}0", one.letter), centre);
      return;
    }
    double low = 0.0;
    double high = 0.0;
    const Point from = one.joint(first_);
    for (const Pose& pose : motion_.poses) {
      const Point way = (one.joint(pose) - from) * std::conj(one.dyad.direction);
      low = std::min(low, way.real());
      high = std::max(high, way.real());
    }
    const PixelPoint direction = along(one.dyad.direction);
    const PixelPoint side = -9.5 * left_of(direction);
    draw_fixed_line(svg_,
                    at(from + low * one.dyad.direction) - 20.0 * direction + side,
                    at(from + high * one.dyad.direction) + 20.0 * direction + side);
  }

  void open_body(const std::string& name) {
    const std::array<Attribute, 1> mark = {{{"data-body", name}}};
    svg_.open_group({}, mark);
  }

  void draw_plane() {
    open_body("plane");
    svg_.polygon(rounded_hull(plane_rounds(first_)),
                 {.stroke = Ink::brown, .fill = Ink::brown, .width = 1.4, .opacity = 0.16});
    for (const DyadBody& one : dyads_) {
      if (one.dyad.kind == DyadKind::inverted_slider) {
        const PixelPoint middle = at(first_.place(one.dyad.circle_point));
        const PixelPoint half = kLongerSide * along(one.direction(first_));
        svg_.line(middle - half, middle + half, {.stroke = Ink::brown, .width = 1.2});
      }
    }
    svg_.circle(at(shown(first_)), 4.2, {.stroke = Ink::paper, .fill = Ink::blue, .width = 0.8});
    svg_.close_group();
  }

  void draw_dyad(const DyadBody& one) {
    open_body(fmt::format("dyad-{}", one.letter));
    const PixelPoint joint = at(one.joint(first_));
    const Paint paint = {
        .stroke = Ink::vermilion, .fill = Ink::vermilion, .width = 1.4, .opacity = 0.18};
    if (one.dyad.kind == DyadKind::crank) {
      const std::array<Round, 2> ends = {
          {{.centre = at(one.dyad.centre_point), .radius = 5.0}, {.centre = joint, .radius = 5.0}}};
      svg_.polygon(rounded_hull(ends), paint);
      draw_pin(svg_, at(one.dyad.centre_point), 3.2);
    } else {
      draw_block(svg_,
                 joint,
                 along(one.direction(first_)),
                 {.stroke = Ink::vermilion, .fill = Ink::paper});
    }
    draw_pin(svg_, joint, 4.0);
    svg_.close_group();
  }

  // The linkage at the step that a page shows first.
  void keep_off_begin(NamePlacer& placer) const {
    const Pose& begin = std::ranges::count(at_position_, 0) > 0 ? first_ : motion_.poses.front();
    const auto keep_off = [&](std::span<const Round> rounds) {
      const std::vector<PixelPoint> rim = rounded_hull(rounds);
      for (std::size_t i = 0; i < rim.size(); ++i) {
        placer.keep_off(rim[i], rim[(i + 1) % rim.size()]);
      }
    };
    keep_off(plane_rounds(begin));
    for (const DyadBody& one : dyads_) {
      if (one.dyad.kind == DyadKind::crank) {
        keep_off(std::array<Round, 2>{{{.centre = at(one.dyad.centre_point), .radius = 5.0},
                                       {.centre = at(one.joint(begin)), .radius = 5.0}}});
      }
    }
    keep_off(std::array<Round, 1>{{{.centre = at(shown(begin)), .radius = 5.0}}});
  }

  void write_names() {
    NamePlacer placer;
    placer.keep_off(svg_.lines());
    keep_off_begin(placer);
    for (const auto& [text, place] : names_) {
      constexpr TextStyle kNameStyle = {
          .ink = Ink::ink, .size = 12.5, .weight = Weight::bold, .has_halo = true};
      write_label(svg_, placer.place(place, text, kNameStyle, 7.0), text, kNameStyle);
    }
  }

  // The input, and of a function the output.
  std::string input_text(const Pose& pose) const {
    const std::string text = place_text(input(), pose);
    return best_.positions.empty() ? text : text + ", " + place_text(dyads_[1], pose);
  }

  // "A0A 123.4 deg": a link by its angle in the fixed frame, or how far it has slid.
  std::string place_text(const DyadBody& one, const Pose& pose) const {
    const FileUnits& units = analysis_.description.units;
    const auto text = [&](QuantityKind kind, double value) {
      return fmt::format("{0}0{0} {1} {2}",
                         one.letter,
                         short_number(units.from_si(kind, value)),
                         units.text(kind));
    };
    switch (one.dyad.kind) {
      case DyadKind::slider: {
        const Point way = (one.joint(pose) - one.joint(first_)) * std::conj(one.dyad.direction);
        return text(QuantityKind::length, way.real());
      }
      case DyadKind::inverted_slider:
        return text(QuantityKind::angle, std::arg(one.direction(pose)));
      case DyadKind::crank:
        break;
    }
    return text(QuantityKind::angle, std::arg(one.joint(pose) - one.dyad.centre_point));
  }

  // Where all that is drawn of it goes from one pose to the other.
  double way_between(const Pose& from, const Pose& to) const {
    return std::abs(shown(to) - shown(from)) +
           std::abs(dyads_[0].joint(to) - dyads_[0].joint(from)) +
           std::abs(dyads_[1].joint(to) - dyads_[1].joint(from));
  }

  // The step nearest to each position is put there, if it comes as near as a step goes.
  void pass_through_positions() {
    at_position_.assign(motion_.poses.size(), -1);
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      const auto nearest = std::ranges::min_element(
          motion_.poses, {}, [&](const Pose& pose) { return way_between(pose, asked_[i]); });
      const auto step = static_cast<std::size_t>(nearest - motion_.poses.begin());
      const Pose& next = motion_.poses[(step + 1) % motion_.poses.size()];
      if (at_position_[step] < 0 &&
          way_between(*nearest, asked_[i]) <= 2.0 * way_between(*nearest, next)) {
        at_position_[step] = static_cast<int>(i);
        const double turns =
            std::round((nearest->angle - asked_[i].angle) / (2 * std::numbers::pi));
        *nearest = asked_[i];
        nearest->angle += 2 * std::numbers::pi * turns;
      }
    }
  }

  const SynthesisAnalysis& analysis_;
  const LinkageCandidate& best_;
  Pose first_;
  std::array<DyadBody, 2> dyads_;
  std::vector<Pose> asked_;
  LinkageMotion motion_;
  std::vector<int> at_position_;  // of each step: which position it is, or -1
  double scale_ = 1.0;            // [px/m]
  double x0_ = 0.0;
  double y0_ = 0.0;
  Svg svg_;
  std::vector<std::pair<std::string, PixelPoint>> names_;
};

}  // namespace

std::optional<MovingLinkage> draw_moving_linkage(const SynthesisAnalysis& analysis,
                                                 std::size_t task) {
  if (task >= analysis.tasks.size() || analysis.tasks[task].linkages.empty()) {
    return std::nullopt;
  }
  MovingLinkage moving = LinkageMover(analysis, analysis.tasks[task]).run();
  return moving.steps.size() > 1 ? std::optional(std::move(moving)) : std::nullopt;
}

}  // namespace kinestat
