#include "format/sections/synthesis_limits.hpp"

#include <utility>
#include <vector>

#include "forms/alternatives.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

constexpr const char* kAreaHint =
    "write {from: [x, y], to: [x, y]}, or the corners of a polygon: [[x, y], [x, y], [x, y]]";

struct Rectangle {
  PointDescription from;
  PointDescription to;
};

const Mapping<Rectangle>& rectangle() {
  static const Mapping<Rectangle> mapping("", "", "{from: [-1, -1], to: [1, 1]}", [](auto& m) {
    m.key("from", "One corner of a rectangle parallel to the axes.")
        .needed(&Rectangle::from, point_in_plane());
    m.key("to", "The opposite corner.").needed(&Rectangle::to, point_in_plane());
  });
  return mapping;
}

Form<AreaDescription> area() {
  const auto polygon = converted<AreaDescription>(
      list_of(point_in_plane(), "corner {0} of {1}", kAreaHint, {.least = 3}),
      [](std::vector<PointDescription> corners) {
        return AreaDescription{.corners = std::move(corners), .where = {}};
      },
      [](const AreaDescription& one) { return one.corners; });
  const auto box = converted<AreaDescription>(
      rectangle().form(),
      [](Rectangle one) {
        return AreaDescription{.corners = {std::move(one.from), std::move(one.to)}, .where = {}};
      },
      [](const AreaDescription& one) {
        return Rectangle{.from = one.corners[0], .to = one.corners[1]};
      });
  auto form = by_shape<AreaDescription>({polygon, box}, [](const AreaDescription& one) {
    return one.corners.size() == 2 ? std::size_t{1} : std::size_t{0};
  });
  form.read = [read = form.read](const FileValue& value) {
    auto one = read(value);
    if (one) {
      one->where = value.node.where;
    }
    return one;
  };
  form.shape.definition = "area";
  form.shape.meaning =
      "An area of the plane: a rectangle parallel to the axes, given by two opposite corners, or "
      "the corners of a polygon in order.";
  form.shape.examples = {"{from: [-1, -1], to: [1, 1]}", "[[0, 0], [2, 0], [1, 1.5]]"};
  return form;
}

template <typename Which>
Word word_for(Which which, std::string_view meaning) {
  return {.text = word_of(which), .meaning = meaning};
}

Form<std::vector<GrashofClass>> classes() {
  using enum GrashofClass;
  return one_or_more(
      choice_of<GrashofClass>({word_for(crank_rocker, "the shortest link is a crank"),
                               word_for(double_crank, "the shortest link is the ground"),
                               word_for(double_rocker, "the shortest link is the coupler"),
                               word_for(triple_rocker, "no link turns fully"),
                               word_for(change_point, "all links can lie in one line")}),
      1,
      "write class: crank_rocker, or a list of those that will do");
}

Form<std::vector<LinkageCircuit>> circuits() {
  using enum LinkageCircuit;
  return one_or_more(
      choice_of<LinkageCircuit>(
          {word_for(open,
                    "of a crank that turns fully: a little counterclockwise of the line of "
                    "centres, the links next to the shortest do not cross; of a slider: ahead"),
           word_for(crossed, "the mirror image: they cross there; of a slider: behind"),
           word_for(left, "of a double rocker: left of the line from input to output"),
           word_for(right, "the mirror image"),
           word_for(single, "the linkage has one circuit only")}),
      1,
      "write circuit: open, or a list of those that will do");
}

}  // namespace

const Mapping<SynthesisLimits>& synthesis_limits() {
  static const Mapping<SynthesisLimits> mapping(
      "", "", "{transmission_angle: 30 deg, link_ratio: 12, size: 20}", [](auto& m) {
        m.key("transmission_angle",
              "Least transmission angle from the first to the last position, from 0 to below 90 "
              "deg.")
            .may(&SynthesisLimits::transmission_angle, acute_angle(), "30 deg");
        m.key("full_transmission_angle",
              "Least transmission angle over the whole range of the input: over the full turn of a "
              "crank; 0 for an input that meets a dead point.")
            .may(&SynthesisLimits::full_transmission_angle, acute_angle(), "30 deg");
        m.key("link_ratio", "Largest ratio of the longest link to the shortest, at least 1.")
            .may(&SynthesisLimits::link_ratio, at_least_one(), "12");
        m.key("size", "Largest length of a link or distance of a pivot.")
            .may(&SynthesisLimits::size, size(), "20");
        m.key("class", "Grashof class of a four-bar, or a list of acceptable ones.")
            .may(&SynthesisLimits::classes, classes(), "crank_rocker");
        m.key("circuit", "Circuit in which the linkage is assembled, or a list of acceptable ones.")
            .may(&SynthesisLimits::circuits, circuits(), "open");
        m.key("turns_fully", "true requires an input that turns fully. Default false.")
            .may(&SynthesisLimits::turns_fully, flag(), "true");
        m.key("centre_points", "Where the fixed pivots must lie, in the fixed frame.")
            .may(&SynthesisLimits::centre_points, area(), "{from: [-1, -1], to: [1, 1]}");
        m.key(
             "circle_points",
             "Where the moving pivots must lie, in the moving frame; those of a function generator "
             "in the first position.")
            .may(&SynthesisLimits::circle_points, area(), "[[0, 0], [2, 0], [1, 1.5]]");
      });
  return mapping;
}

}  // namespace kinestat
