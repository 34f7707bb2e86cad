#include "studies/synthesis/picture/best_linkages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/spelling.hpp"
#include "core/text.hpp"
#include "draw/name_placer.hpp"
#include "draw/picture_title.hpp"
#include "draw/symbols.hpp"
#include "draw/text_styles.hpp"
#include "studies/synthesis/linkages/linkage_motion.hpp"
#include "studies/synthesis/report/linkage_text.hpp"
#include "studies/synthesis/report/plane_text.hpp"

namespace kinestat {

namespace {

constexpr double kPanel = 168.0;  // of its longer side [px]
constexpr double kGap = 26.0;
constexpr double kWords = 67.0;  // four lines below it
constexpr std::size_t kColumns = 5;

// Where the plane is joined to a dyad.
Point joint_of(const Dyad& dyad, const Pose& pose) {
  return dyad.kind == DyadKind::inverted_slider ? dyad.centre_point : pose.place(dyad.circle_point);
}

// One linkage within a square.
class Panel {
 public:
  Panel(const SynthesisTask& task, const LinkageCandidate& linkage, PixelPoint corner)
      : linkage_(linkage), corner_(corner) {
    svg_.keep_lines();
    for (const PositionJets& position : task.positions_of(linkage)) {
      poses_.push_back(pose_of(position));
    }
    find_window();
  }

  Svg draw() {
    svg_.rectangle({.left = corner_.x,
                    .top = corner_.y,
                    .right = corner_.x + kPanel,
                    .bottom = corner_.y + kPanel},
                   {.stroke = Ink::grid, .width = 1.0});
    draw_path();
    for (const Dyad* dyad : {&linkage_.linkage.one, &linkage_.linkage.other}) {
      draw_ground(*dyad);
    }
    for (std::size_t i = poses_.size(); i-- > 0;) {
      draw_position(poses_[i], i == 0);
    }
    draw_marks();
    return std::move(svg_);
  }

 private:
  static constexpr double kRim = 22.0;  // as far as supports reach

  Point shown(const Pose& pose) const { return pose.place(linkage_.tracer()); }

  struct Window {
    Point low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point high = -low;

    void add(const Point& p) {
      low = {std::min(low.real(), p.real()), std::min(low.imag(), p.imag())};
      high = {std::max(high.real(), p.real()), std::max(high.imag(), p.imag())};
    }

    double longer() const {
      const Point size = high - low;
      return std::max(size.real(), size.imag());
    }
  };

  // Positions, joints and fixed pivots; and the path, if that leaves them large enough to be seen.
  void find_window() {
    constexpr int kSteps = 240;
    constexpr double kMostGrowth = 1.6;
    Window window;
    for (const Dyad* dyad : {&linkage_.linkage.one, &linkage_.linkage.other}) {
      for (const Pose& pose : poses_) {
        window.add(shown(pose));
        window.add(joint_of(*dyad, pose));
      }
      if (dyad->kind == DyadKind::crank) {
        window.add(dyad->centre_point);
      }
    }
    const LinkageMotion motion = trace_circuit(linkage_.linkage,
                                               linkage_.best_drive,
                                               poses_.front(),
                                               kSteps,
                                               kMostGrowth * window.longer());
    path_ = coupler_curve(motion, linkage_.tracer());
    if (motion.is_closed && !path_.empty()) {
      path_.push_back(path_.front());
    }
    Window with_path = window;
    for (const Point& p : path_) {
      with_path.add(p);
    }
    if (with_path.longer() <= kMostGrowth * window.longer()) {
      window = with_path;
    }
    scale_ = window.longer() > 0.0 ? (kPanel - 2.0 * kRim) / window.longer() : 1.0;
    middle_ = 0.5 * (window.low + window.high);
  }

  PixelPoint at(const Point& p) const {
    const Point from = scale_ * (p - middle_);
    return {.x = corner_.x + 0.5 * kPanel + from.real(),
            .y = corner_.y + 0.5 * kPanel - from.imag()};
  }

  static PixelPoint along(const Point& direction) {
    return {.x = direction.real(), .y = -direction.imag()};
  }

  bool holds(PixelPoint p) const {
    return p.x >= corner_.x && p.x <= corner_.x + kPanel && p.y >= corner_.y &&
           p.y <= corner_.y + kPanel;
  }

  void draw_path() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<PixelPoint> points;
    for (const Point& p : path_) {
      const PixelPoint place = at(p);
      points.push_back(holds(place) ? place : PixelPoint{.x = kNone, .y = kNone});
    }
    svg_.polyline(points, {.stroke = Ink::blue, .width = 1.1, .dash = "5 3"});
  }

  void draw_ground(const Dyad& dyad) {
    if (dyad.kind != DyadKind::slider) {
      draw_support(svg_, at(dyad.centre_point));
      return;
    }
    std::vector<double> ways;
    const Point from = joint_of(dyad, poses_.front());
    for (const Pose& pose : poses_) {
      ways.push_back(dot(joint_of(dyad, pose) - from, dyad.direction));
    }
    const auto [low, high] = std::ranges::minmax(ways);
    svg_.line(at(from + low * dyad.direction),
              at(from + high * dyad.direction),
              {.stroke = Ink::soft, .width = 1.0, .dash = "9 3"});
  }

  void draw_position(const Pose& pose, bool is_first) {
    const std::array<const Dyad*, 2> dyads = {&linkage_.linkage.one, &linkage_.linkage.other};
    std::vector<PixelPoint> plane = {at(shown(pose))};
    for (const Dyad* dyad : dyads) {
      plane.push_back(at(joint_of(*dyad, pose)));
    }
    const Paint faint = {.stroke = Ink::soft, .width = 0.7};
    svg_.polygon(
        plane,
        is_first ? Paint{.stroke = Ink::brown, .fill = Ink::brown, .width = 1.4, .opacity = 0.16}
                 : faint);
    for (const Dyad* dyad : dyads) {
      const PixelPoint joint = at(joint_of(*dyad, pose));
      if (dyad->kind == DyadKind::crank) {
        svg_.line(
            at(dyad->centre_point),
            joint,
            is_first ? Paint{.stroke = Ink::vermilion, .width = 3.0, .round_ends = true} : faint);
      } else if (is_first) {
        const Point direction = dyad->kind == DyadKind::slider
                                    ? dyad->direction
                                    : unit_vector(pose.angle) * dyad->direction;
        draw_block(svg_, joint, along(direction), {.stroke = Ink::vermilion, .fill = Ink::paper});
      }
      if (is_first) {
        draw_pin(svg_, joint, 2.6);
        if (dyad->kind == DyadKind::crank) {
          draw_pin(svg_, at(dyad->centre_point), 2.6);
        }
      }
    }
  }

  // As they were asked for: the watched point, the x axis of the frame if this was asked for too,
  // and which it is.
  void draw_marks() {
    TextStyle style = kSmall;
    style.has_halo = true;
    style.ink = Ink::ink;
    for (const Pose& pose : poses_) {
      const PixelPoint from = at(shown(pose));
      const PixelPoint to = from + 17.0 * along(unit_vector(pose.angle));
      if (linkage_.positions.empty()) {
        svg_.arrow(from, to, {.stroke = Ink::ink}, 5.0);
      }
      svg_.circle(from, 2.2, {.stroke = Ink::none, .fill = Ink::ink});
    }
    PixelBox area;
    area.add(corner_);
    area.add(corner_ + PixelPoint{.x = kPanel, .y = kPanel});
    NamePlacer placer(area.grown(-1.0));
    placer.keep_off(svg_.lines());
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const std::string text = std::to_string(i + 1);
      write_label(svg_, placer.place(at(shown(poses_[i])), text, style, 4.0), text, style);
    }
  }

  const LinkageCandidate& linkage_;
  PixelPoint corner_;
  Svg svg_;
  std::vector<Pose> poses_;
  std::vector<Point> path_;  // of the watched point
  double scale_ = 1.0;       // [px/m]
  Point middle_;
};

// As it is called in the tables: by its task where there are several, by its number, or by both.
std::string name_of(const LinkagePlace& place, const SynthesisAnalysis& analysis) {
  const bool has_tasks = analysis.tasks.size() > 1;
  return has_tasks && analysis.selection ? fmt::format("task {}", place.task)
         : has_tasks ? fmt::format("task {}, linkage {}", place.task, place.number)
                     : fmt::format("linkage {}", place.number);
}

std::array<std::string, 4> words_of(const LinkagePlace& place, const SynthesisAnalysis& analysis) {
  const LinkageCandidate& one = analysis.tasks[place.task].linkages[place.number];
  const PlaneText plane(analysis.description.units);
  const std::string kind =
      hyphenated(one.grashof ? word_of(one.grashof->kind) : word_of(one.linkage.type()));
  const FileUnits& units = analysis.description.units;
  const std::string verdict =
      one.is_usable() ? fmt::format("margin {} {}",
                                    short_number(units.from_si(QuantityKind::angle, one.margin())),
                                    units.text(QuantityKind::angle))
                      : std::string(phrase_of(one.defect()));
  return {name_of(place, analysis),
          kind,
          verdict,
          fmt::format("longest link {} {}, {} : 1",
                      short_number(units.from_si(QuantityKind::length, one.longest)),
                      units.text(QuantityKind::length),
                      short_number(one.ratio))};
}

}  // namespace

std::vector<LinkagePlace> find_best_linkages(const SynthesisAnalysis& analysis) {
  std::vector<LinkagePlace> places;
  for (std::size_t task = 0; task < analysis.tasks.size(); ++task) {
    const std::size_t count = analysis.tasks[task].linkages.size();
    for (std::size_t i = 0; i < (analysis.selection ? std::min<std::size_t>(count, 1) : count);
         ++i) {
      places.push_back({.task = task, .number = i});
    }
  }
  const auto linkage = [&](const LinkagePlace& place) -> const LinkageCandidate& {
    return analysis.tasks[place.task].linkages[place.number];
  };
  std::ranges::stable_sort(places, [&](const LinkagePlace& one, const LinkagePlace& other) {
    return linkage(one).standing().is_better_than(linkage(other).standing());
  });
  const auto usable = static_cast<std::size_t>(std::ranges::count_if(
      places, [&](const LinkagePlace& one) { return linkage(one).is_usable(); }));
  places.resize(std::min(
      {places.size(), std::max<std::size_t>(usable, 1), static_cast<std::size_t>(kBestLinkages)}));
  return places;
}

Picture draw_best_linkages(const SynthesisAnalysis& analysis) {
  const std::vector<LinkagePlace> places = find_best_linkages(analysis);
  KINESTAT_EXPECTS(!places.empty());
  const LinkageCandidate& best = analysis.tasks[places[0].task].linkages[places[0].number];
  Svg svg;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto column = static_cast<double>(i % kColumns);
    const auto row = static_cast<double>(i / kColumns);
    const PixelPoint corner = {.x = column * (kPanel + kGap), .y = row * (kPanel + kWords + kGap)};
    const SynthesisTask& task = analysis.tasks[places[i].task];
    const std::array<std::string, 4> words = words_of(places[i], analysis);
    svg.open_group(words[0]);
    svg.add(Panel(task, task.linkages[places[i].number], corner).draw());
    for (std::size_t line = 0; line < words.size(); ++line) {
      TextStyle style = kSmall;
      style.weight = line == 0 ? Weight::bold : Weight::normal;
      style.ink = line == 0 ? Ink::ink : Ink::soft;
      svg.text({.x = corner.x, .y = corner.y + kPanel + 15.0 + 15.0 * static_cast<double>(line)},
               words[line],
               style);
    }
    svg.close_group();
  }
  return make_picture(
      "synthesis",
      fmt::format(
          "{}: {}",
          best.is_usable() ? "The best linkages" : "The nearest linkage, which is not usable",
          shown_name(analysis.file, analysis.description)),
      fmt::format("{} in the first position, with the others faint and the path of {}.",
                  counted(places.size(), "linkage"),
                  traced_text(analysis)),
      svg);
}

}  // namespace kinestat
