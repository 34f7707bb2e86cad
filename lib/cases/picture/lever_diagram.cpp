#include "cases/picture/lever_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/rounding.hpp"
#include "core/text.hpp"
#include "draw/axes.hpp"
#include "draw/name_placer.hpp"
#include "draw/picture_title.hpp"
#include "draw/text_styles.hpp"
#include "draw/text_width.hpp"
#include "kinematics/bounded_motion.hpp"
#include "report/in_units.hpp"

namespace kinestat {

namespace {

constexpr double kPanelWidth = 240.0;   // from the first node of a lever to the last
constexpr double kPanelHeight = 130.0;  // of the scale of speeds
constexpr double kPanelGap = 90.0;
constexpr double kLabelReach = 55.0;  // of the labels of nodes beyond the first and the last
constexpr double kCaseSize = 13.0;
constexpr double kMostOfCase = 160.0;  // of the label of a case
constexpr double kRowGap = 46.0;
constexpr double kCaseRow = 24.0;  // of the label of a case above the panel
constexpr double kNameSize = 11.0;
constexpr double kNodeRadius = 4.5;

const TextStyle kZeroStyle = {.ink = Ink::soft, .size = kNameSize, .anchor = Anchor::end};

// An actuator or shift element that acts on a body.
struct NodeTag {
  std::string text;
  bool is_brake = false;  // holds the body to the ground
};

struct DiagramNode {
  std::string name;
  BodyId body;
  double share = 0.0;  // of the panel's width
};

struct DiagramLever {
  Vec3 axis = Vec3::UnitZ();
  std::vector<DiagramNode> nodes;
};

bool is_shown(const CaseAnalysis& one) {
  return one.motion && one.motion->status == SolveStatus::solved;
}

DiagramLever diagram_of(const Lever& lever, const Topology& topology) {
  DiagramLever result = {.axis = lever.axis, .nodes = {}};
  const double first = lever.nodes.front().place;
  const double length = lever.nodes.back().place - first;
  for (const LeverNode& node : lever.nodes) {
    result.nodes.push_back({.name = topology.body(node.body).name,
                            .body = node.body,
                            .share = length > 0.0 ? (node.place - first) / length : 0.0});
  }
  return result;
}

class LeverDrawing {
 public:
  LeverDrawing(const Analysis& analysis, const std::vector<Lever>& levers, bool is_part)
      : analysis_(analysis), is_part_(is_part) {
    for (const Lever& lever : levers) {
      levers_.push_back(diagram_of(lever, analysis.mechanism.topology));
    }
    for (const CaseAnalysis& one : analysis.cases) {
      if (is_shown(one)) {
        cases_.push_back(&one);
      }
    }
    margin_ = is_part ? kLabelReach : kPanelGap;
    for (std::size_t i = 0; !is_part && i < cases_.size(); ++i) {
      const CaseAnalysis* const one = cases_[i];
      const double width = text_width(one->which.label, kCaseSize, Weight::bold);
      margin_ = std::max(margin_, std::min(width, kMostOfCase) + kLabelReach + 10.0);
    }
    find_scale();
  }

  Picture run(const std::string& what) {
    svg_.keep_lines();
    draw_names();
    for (const CaseAnalysis* one : cases_) {
      draw_case(*one);
    }
    const std::string words =
        fmt::format("speeds in {}; a node under the ground line turns backwards",
                    analysis_.description.units.text(QuantityKind::angular_velocity));
    const double width = left_of(levers_.size() - 1) + kPanelWidth + kLabelReach;
    for (const std::string& line : wrapped_text(words, kTextSize, width)) {
      svg_.text({.x = 0.0, .y = y_}, line, {.ink = Ink::soft, .size = kTextSize});
      y_ += 16.0;
    }
    return make_picture("lever",
                        picture_title_of_cases(what, analysis_),
                        "Each planetary set as a lever: its central bodies at places given by the "
                        "numbers of teeth, their angular velocities as distances from the ground "
                        "line, for each case.",
                        svg_);
  }

 private:
  const Topology& topology() const { return analysis_.mechanism.topology; }

  double speed(const CaseAnalysis& one, const DiagramLever& lever, BodyId body) const {
    const BoundedVector axis = rounded_vector(lever.axis, kDataRounding);
    const double rate = dot(bounded_body(*one.motion, body).angular, axis).zeroed();
    return InUnits(analysis_.description.units).angular(rate);
  }

  void find_scale() {
    for (const CaseAnalysis* one : cases_) {
      for (const DiagramLever& lever : levers_) {
        for (const DiagramNode& node : lever.nodes) {
          const double value = speed(*one, lever, node.body);
          low_ = std::min(low_, value);
          high_ = std::max(high_, value);
        }
      }
    }
    if (high_ == low_) {
      high_ = low_ + 1.0;
    }
  }

  // Below the top of the panels of a row.
  double place(double value) const { return kPanelHeight * (high_ - value) / (high_ - low_); }

  double left_of(std::size_t lever) const {
    return margin_ + (kPanelWidth + kPanelGap) * static_cast<double>(lever);
  }

  // The names of the nodes, each over its line, in as many rows as they need.
  void draw_names() {
    double bottom = 0.0;
    for (std::size_t l = 0; l < levers_.size(); ++l) {
      std::vector<PixelBox> taken;
      for (const DiagramNode& node : levers_[l].nodes) {
        const TextStyle style = {
            .size = kTextSize, .weight = Weight::bold, .anchor = Anchor::middle};
        const std::string name = fitting_text(node.name, kTextSize, kPanelWidth, Weight::bold);
        PixelPoint at = {.x = left_of(l) + node.share * kPanelWidth, .y = 12.0};
        const auto covers = [&](const PixelBox& box) {
          return box.overlaps(with_word_gap(text_box(at, name, style)));
        };
        while (std::ranges::any_of(taken, covers)) {
          at.y += 16.0;
        }
        taken.push_back(text_box(at, name, style));
        svg_.text(at, name, style);
        bottom = std::max(bottom, at.y);
      }
    }
    y_ = bottom + 24.0;
  }

  void draw_case(const CaseAnalysis& one) {
    svg_.text({.x = 0.0, .y = y_ + 4.0},
              fitting_text(one.which.label,
                           kCaseSize,
                           is_part_ ? kPanelWidth + kLabelReach : kMostOfCase,
                           Weight::bold),
              {.size = kCaseSize, .weight = Weight::bold});
    y_ += is_part_ ? kCaseRow : 0.0;
    for (std::size_t l = 0; l < levers_.size(); ++l) {
      draw_panel(one, levers_[l], left_of(l));
    }
    y_ += kPanelHeight + kRowGap;
  }

  void draw_panel(const CaseAnalysis& one, const DiagramLever& lever, double left) {
    const std::size_t first_line = svg_.lines().size();
    const double zero = y_ + place(0.0);
    const double right = left + kPanelWidth;
    svg_.line({.x = left - 24.0, .y = zero},
              {.x = right + 24.0, .y = zero},
              {.stroke = Ink::soft, .width = 1.5});
    svg_.text(zero_place(left, zero), "0", kZeroStyle);
    std::vector<PixelPoint> points;
    for (const DiagramNode& node : lever.nodes) {
      const double x = left + node.share * kPanelWidth;
      points.push_back({.x = x, .y = y_ + place(speed(one, lever, node.body))});
      svg_.line(
          {.x = x, .y = y_}, {.x = x, .y = y_ + kPanelHeight}, {.stroke = Ink::grid, .width = 1.0});
      svg_.line(
          {.x = x, .y = zero}, points.back(), {.stroke = Ink::blue, .width = 1.5, .dash = "3 2"});
    }
    svg_.line(points.front(), points.back(), {.stroke = Ink::blue, .width = 3.0});
    draw_nodes(one, lever, points, zero, first_line);
  }

  static PixelPoint zero_place(double left, double zero) {
    return {.x = left - 28.0, .y = zero + 4.0};
  }

  void draw_nodes(const CaseAnalysis& one,
                  const DiagramLever& lever,
                  const std::vector<PixelPoint>& points,
                  double zero,
                  std::size_t first_line) {
    std::vector<std::vector<NodeTag>> tags;
    for (std::size_t i = 0; i < points.size(); ++i) {
      tags.push_back(tags_of(one, lever.nodes[i].body));
      const bool is_held = std::ranges::any_of(tags.back(), &NodeTag::is_brake);
      svg_.circle(
          points[i], kNodeRadius, {.stroke = Ink::ink, .fill = is_held ? Ink::ink : Ink::paper});
      if (is_held) {
        draw_ground({.x = points[i].x, .y = zero});
      }
    }
    NamePlacer placer(PixelBox{.left = points.front().x - kLabelReach,
                               .top = y_ - 18.0,
                               .right = points.back().x + kLabelReach,
                               .bottom = y_ + kPanelHeight + 24.0});
    placer.keep_off(std::span(svg_.lines()).subspan(first_line));
    placer.keep_free(text_box(zero_place(points.front().x, zero), "0", kZeroStyle));
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::string label = label_number(speed(one, lever, lever.nodes[i].body));
      for (const NodeTag& tag : tags[i]) {
        label += " " + tag.text;
      }
      constexpr TextStyle kNode = {.size = kNameSize, .has_halo = true};
      const PlacedName placed = placer.place(points[i], label, kNode, kNodeRadius + 2.0);
      if (placed.is_free) {
        write_label(svg_, placed, label, kNode);
      }
    }
  }

  // The sign of a fixed support.
  void draw_ground(PixelPoint at) {
    const PixelBox box = {
        .left = at.x - 11.0, .top = at.y + 6.0, .right = at.x + 11.0, .bottom = at.y + 13.0};
    svg_.hatch(box, Ink::ink, 4.0);
    svg_.line({.x = box.left, .y = box.top}, {.x = box.right, .y = box.top}, {.width = 1.5});
  }

  // Inputs and outputs of the case, and what holds the body or couples it to another one.
  std::vector<NodeTag> tags_of(const CaseAnalysis& one, BodyId body) const {
    std::vector<NodeTag> tags;
    for (const int input : one.which.inputs) {
      add_tag(input, body, "▸ ", false, tags);
    }
    for (const int output : one.which.outputs) {
      add_tag(output, body, "◂ ", false, tags);
    }
    for (const Primary& primary : one.which.motions) {
      const int actuator = actuator_of(primary);
      if (actuator >= 0 && primary.value == 0.0) {
        add_tag(actuator, body, "", true, tags);
      }
    }
    for (const int element : engaged(one)) {
      add_tag(element, body, "", true, tags);
    }
    return tags;
  }

  void add_tag(
      int actuator, BodyId body, const char* sign, bool holds, std::vector<NodeTag>& tags) const {
    const ActuatorTopology& one = topology().actuators[static_cast<std::size_t>(actuator)];
    const CouplingTopology& coupling =
        topology().coupling(topology().freedoms[static_cast<std::size_t>(one.freedom)].coupling);
    const std::string text = sign + one.name;
    // On the ground acts what everything acts on.
    const bool is_here = body.value != 0 && (coupling.tail == body || coupling.head == body);
    const auto is_same = [&text](const NodeTag& tag) { return tag.text == text; };
    if (is_here && std::ranges::none_of(tags, is_same)) {
      const bool is_at_ground = coupling.tail.value == 0 || coupling.head.value == 0;
      tags.push_back({.text = text, .is_brake = holds && is_at_ground});
    }
  }

  int actuator_of(const Primary& primary) const {
    const auto at =
        std::ranges::find_if(topology().actuators, [&primary](const ActuatorTopology& one) {
          return one.freedom == primary.index && one.name == primary.given;
        });
    return at == topology().actuators.end() ? -1
                                            : static_cast<int>(at - topology().actuators.begin());
  }

  // Actuators of the elements that a gear engages.
  std::vector<int> engaged(const CaseAnalysis& one) const {
    std::vector<int> result;
    if (!analysis_.shift) {
      return result;
    }
    for (const NamedShiftState& state : analysis_.shift->solution.states) {
      if (state.name == one.which.label) {
        for (const int element : state.holding()) {
          result.push_back(
              analysis_.shift->plan.elements[static_cast<std::size_t>(element)].actuator);
        }
      }
    }
    return result;
  }

  const Analysis& analysis_;
  std::vector<DiagramLever> levers_;
  std::vector<const CaseAnalysis*> cases_;
  double low_ = 0.0;
  double high_ = 0.0;
  bool is_part_;
  double margin_ = kPanelGap;  // before the first panel
  double y_ = 0.0;
  Svg svg_;
};

}  // namespace

Picture draw_lever_diagram(const Analysis& analysis, const std::vector<Lever>& levers) {
  KINESTAT_EXPECTS(!levers.empty() && std::ranges::any_of(analysis.cases, is_shown));
  return LeverDrawing(analysis, levers, false).run("Lever diagram");
}

std::vector<Picture> draw_levers_in_parts(const Analysis& analysis,
                                          const std::vector<Lever>& levers) {
  KINESTAT_EXPECTS(!levers.empty() && std::ranges::any_of(analysis.cases, is_shown));
  std::vector<Picture> parts;
  for (const Lever& lever : levers) {
    std::vector<std::string> names;
    for (const LeverNode& node : lever.nodes) {
      names.push_back(analysis.mechanism.topology.body(node.body).name);
    }
    const std::string what = levers.size() == 1
                                 ? "Lever diagram"
                                 : fmt::format("Lever diagram of {}", plain_list(names));
    parts.push_back(LeverDrawing(analysis, {lever}, true).run(what));
  }
  return parts;
}

}  // namespace kinestat
