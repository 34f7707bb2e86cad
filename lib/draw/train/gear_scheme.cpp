#include "draw/train/gear_scheme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "draw/name_placer.hpp"
#include "draw/picture_title.hpp"
#include "draw/symbols.hpp"
#include "draw/text_styles.hpp"
#include "draw/train/gear_sections.hpp"
#include "draw/train/scheme_layout.hpp"

namespace kinestat {

namespace {

constexpr double kMeshGap = 2.2;  // half the gap between wheels in mesh [px]
constexpr double kThick = 3.0;    // strokes of wheels
constexpr double kShaft = 2.2;
constexpr double kPlate = 9.0;  // half the length of the plate of an element
constexpr double kHub = 7.0;    // half the length of the bearing of an idler

class SchemeWriter {
 public:
  SchemeWriter(const Analysis& analysis,
               const GearSchemeOptions& options,
               const SchemeTrain& train,
               const SchemeLayout& layout)
      : analysis_(analysis), options_(options), train_(train), layout_(layout) {}

  Svg write() {
    svg_.keep_lines();
    if (layout_.axes.empty()) {
      draw_axis({.left = layout_.box.left - 30, .right = layout_.box.right + 30, .height = 0});
    }
    for (const DrawnAxis& axis : layout_.axes) {
      draw_axis(axis);
    }
    for (const DrawnShaft& shaft : layout_.shafts) {
      const double width = shaft.body == 0 ? 1.6 : kShaft;
      svg_.line(shaft.from, shaft.to, {.stroke = Ink::ink, .width = width, .round_ends = true});
    }
    for (const DrawnPin& pin : layout_.pins) {
      draw_pin_line(pin);
    }
    for (const DrawnLink& link : layout_.links) {
      draw_link(link);
    }
    for (const DrawnWheel& wheel : layout_.wheels) {
      draw_wheel(wheel);
    }
    for (const DrawnElement& element : layout_.elements) {
      draw_element(element);
    }
    placer_.keep_off(svg_.lines());
    placer_.price_crossings();
    for (const DrawnElement& element : layout_.elements) {
      name_element(element);
    }
    name_wheels();
    name_bodies();
    draw_legend();
    return std::move(svg_);
  }

 private:
  static PixelPoint at(double x, double height) { return {.x = x, .y = -height}; }

  const SchemeWheel& wheel(const DrawnWheel& drawn) const {
    return train_.wheels[static_cast<std::size_t>(drawn.wheel)];
  }

  Ink ink(int planet) const { return planet < 0 ? Ink::ink : Ink::blue; }

  void stroke(PixelPoint from, PixelPoint to, Ink ink, double width) {
    svg_.line(from, to, {.stroke = ink, .width = width});
  }

  void draw_axis(const DrawnAxis& axis) {
    const PixelPoint from = at(axis.left, axis.height);
    const PixelPoint to = at(axis.right, axis.height);
    svg_.line(from, to, {.stroke = Ink::soft, .width = 0.9, .dash = "14 3 3 3"});
  }

  // Gears in mesh that stand apart.
  void draw_link(const DrawnLink& link) {
    svg_.polyline(link.points, {.stroke = Ink::soft, .width = 1.3, .dash = "4 3"});
  }

  // The pin, on which the planet turns.
  void draw_pin_line(const DrawnPin& pin) {
    stroke(at(pin.left, pin.height), at(pin.right, pin.height), Ink::ink, 1.4);
  }

  void draw_wheel(const DrawnWheel& drawn) {
    const SchemeWheel& of = wheel(drawn);
    svg_.open_group(of.name);
    if (of.planet >= 0) {
      draw_planet(drawn);
    } else if (drawn.is_whole) {
      draw_whole(drawn);
    } else {
      const double height = drawn.high + (of.is_ring ? kMeshGap : -kMeshGap);
      stroke(at(drawn.left, height), at(drawn.right, height), Ink::ink, kThick);
      // From where the shaft begins.
      for (const double x : drawn.discs) {
        svg_.line(at(x, drawn.high), at(x, height), {.stroke = Ink::ink, .width = kShaft});
      }
    }
    svg_.close_group();
  }

  // A stroke above and below and a disc between; what is fixed has a cross on its shaft, an idler a
  // bearing.
  void draw_whole(const DrawnWheel& drawn) {
    const double x = drawn.discs.front();
    for (const double side : {-1.0, 1.0}) {
      const double rim = drawn.axis + side * (drawn.high - drawn.axis - kMeshGap);
      const double hub = drawn.axis + side * drawn.hub;
      stroke(at(drawn.left, rim), at(drawn.right, rim), Ink::ink, kThick);
      stroke(at(x, hub), at(x, rim), Ink::ink, kShaft);
      if (drawn.is_fixed && (side > 0 || drawn.hub > 0.0)) {
        constexpr double kCross = 3.5;
        for (const double slope : {-kCross, kCross}) {
          svg_.line(at(x - kCross, hub - slope),
                    at(x + kCross, hub + slope),
                    {.stroke = Ink::ink, .width = 1.4});
        }
      } else if (!drawn.is_fixed) {
        stroke(at(x - kHub, hub), at(x + kHub, hub), Ink::ink, 1.6);
      }
    }
  }

  // A stroke where it meshes above and below, and a disc with a bearing on the pin.
  void draw_planet(const DrawnWheel& drawn) {
    const double low = drawn.low + kMeshGap;
    const double high = drawn.high - kMeshGap;
    const double middle = (drawn.low + drawn.high) / 2;
    for (const double height : {low, high}) {
      stroke(at(drawn.left, height), at(drawn.right, height), Ink::blue, kThick);
    }
    const double x = (drawn.left + drawn.right) / 2;
    const double bearing = 3.2;
    stroke(at(x, low), at(x, middle - bearing), Ink::blue, kShaft);
    stroke(at(x, middle + bearing), at(x, high), Ink::blue, kShaft);
    for (const double side : {-bearing, bearing}) {
      stroke(at(x - 7, middle + side), at(x + 7, middle + side), Ink::blue, 1.6);
    }
    join_steps(drawn, middle);
  }

  // Wheels of one planet are one body: their hubs are joined.
  void join_steps(const DrawnWheel& drawn, double middle) {
    for (const DrawnWheel& other : layout_.wheels) {
      const bool is_next = wheel(other).planet == wheel(drawn).planet && other.left > drawn.right;
      const bool has_between = std::ranges::any_of(layout_.wheels, [&](const DrawnWheel& third) {
        return wheel(third).planet == wheel(drawn).planet && third.left > drawn.right &&
               third.right < other.left;
      });
      if (is_next && !has_between) {
        const double from = (drawn.left + drawn.right) / 2 + 7;
        const double to = (other.left + other.right) / 2 - 7;
        for (const double side : {-3.2, 3.2}) {
          stroke(at(from, middle + side), at(to, middle + side), Ink::blue, 1.6);
        }
      }
    }
  }

  Paint plate(bool is_engaged) const {
    return {.stroke = is_engaged ? Ink::vermilion : Ink::ink,
            .fill = is_engaged ? Ink::vermilion : Ink::paper,
            .width = 1.4};
  }

  bool is_engaged(const DrawnElement& drawn) const {
    return drawn.element >= 0 &&
           train_.elements[static_cast<std::size_t>(drawn.element)].is_engaged;
  }

  void draw_element(const DrawnElement& drawn) {
    const bool is_fixed = drawn.element < 0;
    const SchemeElementKind kind =
        is_fixed ? SchemeElementKind::brake
                 : train_.elements[static_cast<std::size_t>(drawn.element)].kind;
    switch (kind) {
      case SchemeElementKind::clutch:
        draw_clutch(drawn);
        break;
      case SchemeElementKind::brake:
        draw_housing(drawn, is_fixed);
        break;
      case SchemeElementKind::input:
      case SchemeElementKind::output:
        draw_port(drawn, kind);
        break;
    }
  }

  // Two plates across the axis; filled, and without a gap, where they hold each other.
  void draw_clutch(const DrawnElement& drawn) {
    draw_clutch(drawn, drawn.at, drawn.beyond, drawn.outwards, drawn.inwards);
    if (drawn.is_mirrored) {
      const auto mirror = [&](PixelPoint point) {
        return PixelPoint{.x = point.x, .y = 2.0 * drawn.axis - point.y};
      };
      draw_clutch(drawn, mirror(drawn.at), mirror(drawn.beyond), drawn.inwards, drawn.outwards);
    }
  }

  void draw_clutch(
      const DrawnElement& drawn, PixelPoint from, PixelPoint to, double above, double below) {
    const PixelPoint along = unit_of(to - from);
    const double length = length_of(to - from);
    const double gap = is_engaged(drawn) ? 0.0 : 2.6;
    const PixelPoint middle = from + 0.5 * length * along;
    if (drawn.element >= 0 && train_.elements[static_cast<std::size_t>(drawn.element)].is_fluid) {
      for (const double side : {-1.0, 1.0}) {
        draw_shell(side < 0 ? from : to, middle, side * along, 0.5 * (above + below));
      }
      return;
    }
    for (const double side : {-1.0, 1.0}) {
      const PixelPoint inner = middle + (side * gap) * along;
      const PixelPoint outer = middle + (side * (gap + 4.0)) * along;
      PixelBox box;
      box.add(inner);
      box.add(outer);
      box.top -= above;
      box.bottom += below;
      svg_.line(side < 0 ? from : to, outer, {.stroke = Ink::ink, .width = kShaft});
      svg_.rectangle(box, plate(is_engaged(drawn)));
    }
  }

  // Pump or turbine of a torque converter: half a lens, its flat side towards the other.
  void draw_shell(PixelPoint shaft, PixelPoint middle, PixelPoint out, double radius) {
    constexpr int kCorners = 12;
    constexpr double kDepth = 7.0;
    const PixelPoint across = left_of(out);
    const PixelPoint flat = middle + 1.2 * out;
    std::vector<PixelPoint> corners;
    for (int i = 0; i <= kCorners; ++i) {
      const double angle = std::numbers::pi * i / kCorners;
      corners.push_back(flat + (radius * std::cos(angle)) * across +
                        (kDepth * std::sin(angle)) * out);
    }
    svg_.line(shaft, flat + kDepth * out, {.stroke = Ink::ink, .width = kShaft});
    svg_.polygon(corners, plate(false));
  }

  // A plate against the hatched housing; what is fixed has none.
  void draw_housing(const DrawnElement& drawn, bool is_fixed) {
    const PixelPoint out = unit_of(drawn.beyond - drawn.at);
    const PixelPoint across = left_of(out);
    const double gap = is_engaged(drawn) ? 0.0 : 3.0;
    const double depth = is_fixed ? 0.0 : 4.0;
    const PixelPoint wall = drawn.at + (gap + depth) * out;
    if (!is_fixed) {
      PixelBox box;
      box.add(drawn.at + kPlate * across);
      box.add(drawn.at - kPlate * across + depth * out);
      svg_.rectangle(box, plate(is_engaged(drawn)));
    }
    // Hatched on the far side of the line.
    draw_fixed_line(svg_, wall - 1.3 * kPlate * across, wall + 1.3 * kPlate * across);
  }

  void draw_port(const DrawnElement& drawn, SchemeElementKind kind) {
    const PixelPoint out = unit_of(drawn.beyond - drawn.at);
    const PixelPoint far = drawn.at + 26.0 * out;
    const Paint paint = {.stroke = is_engaged(drawn) ? Ink::vermilion : Ink::ink, .width = 3.0};
    if (kind == SchemeElementKind::input) {
      svg_.arrow(far, drawn.at, paint, 11.0);
    } else {
      svg_.arrow(drawn.at, far, paint, 11.0);
    }
  }

  void name_element(const DrawnElement& drawn) {
    if (drawn.element < 0) {
      return;
    }
    const SchemeElement& element = train_.elements[static_cast<std::size_t>(drawn.element)];
    const bool is_port =
        element.kind == SchemeElementKind::input || element.kind == SchemeElementKind::output;
    const PixelPoint out = unit_of(drawn.beyond - drawn.at);
    const PixelPoint anchor = is_port ? drawn.at + 28.0 * out
                              : element.kind == SchemeElementKind::brake
                                  ? drawn.at + 14.0 * out
                                  : 0.5 * (drawn.at + drawn.beyond);
    write(element.name,
          anchor,
          is_port                                    ? 3.0
          : element.kind == SchemeElementKind::brake ? 2.0
                                                     : drawn.outwards + 2.0,
          {.ink = element.is_engaged ? Ink::vermilion : Ink::ink,
           .size = 13.0,
           .weight = Weight::bold,
           .has_halo = true});
  }

  void write(const std::string& text, PixelPoint anchor, double distance, const TextStyle& style) {
    const PlacedName label = placer_.place(anchor, text, style, distance);
    write_label(svg_, label, text, style);
  }

  void name_wheels() {
    for (const DrawnWheel& drawn : layout_.wheels) {
      const SchemeWheel& of = wheel(drawn);
      const TextStyle style = {.ink = ink(of.planet), .size = 11.5, .has_halo = true};
      const double height = drawn.high - (of.planet < 0 ? 0.0 : 9.0);
      const std::array ends = {at(drawn.right, height), at(drawn.left, height)};
      PlacedName label = placer_.place(ends, of.name, style, 4.0);
      if (of.planet >= 0) {  // a line leads to its teeth
        label.anchor.y = at(drawn.right, drawn.high - kMeshGap).y;
        if (label.needs_line) {
          placer_.keep_off(label.anchor, label.line_end);
        }
      }
      write_label(svg_, label, of.name, style);
    }
  }

  // Bodies without a wheel of their name, on their longest line.
  void name_bodies() {
    for (int body = 1; body < analysis_.mechanism.topology.body_count(); ++body) {
      const std::string& name = analysis_.mechanism.topology.body(BodyId{body}).name;
      const bool is_named =
          std::ranges::any_of(train_.wheels,
                              [&](const SchemeWheel& wheel) {
                                return wheel.name == name || wheel.name.starts_with(name + " ");
                              }) ||
          is_idler(body);
      const DrawnShaft* longest = nullptr;
      for (const DrawnShaft& shaft : layout_.shafts) {
        const bool is_longer = longest == nullptr || length_of(shaft.to - shaft.from) >
                                                         length_of(longest->to - longest->from);
        if (shaft.body == body && is_longer) {
          longest = &shaft;
        }
      }
      if (longest != nullptr && !is_named) {
        name_shaft(name, *longest);
      }
    }
  }

  // At the best of some places along it, as symbols stand close there.
  void name_shaft(const std::string& name, const DrawnShaft& shaft) {
    constexpr int kPlaces = 32;                // from the middle outwards
    constexpr double kBeyond[] = {0.0, 22.0};  // the far ones beyond plates
    const TextStyle style = {.ink = Ink::soft, .size = 11.5, .has_halo = true, .is_italic = true};
    const PixelPoint across = left_of(unit_of(shaft.to - shaft.from));
    const double near = 4.5 + std::abs(across.x) * text_width(name, style.size) / 2 +
                        std::abs(across.y) * style.size / 2;
    std::vector<PixelPoint> places;
    for (int i = 0; i < kPlaces; ++i) {
      const double share = 0.5 + (i % 2 == 0 ? 0.5 : -0.5) * (i + 0.5) / kPlaces;
      const PixelPoint place = shaft.from + share * (shaft.to - shaft.from);
      for (const double beyond : kBeyond) {
        places.push_back(place + (near + beyond) * across);
        places.push_back(place - (near + beyond) * across);
      }
    }
    std::vector<PixelPoint> anchors;
    for (const double share : {0.5, 0.3, 0.7, 0.1, 0.9}) {
      anchors.push_back(shaft.from + share * (shaft.to - shaft.from));
    }
    write_label(svg_, placer_.place_at(places, anchors, name, style), name, style);
  }

  // Its wheel says what it is.
  bool is_idler(int body) const {
    return std::ranges::any_of(layout_.wheels, [&](const DrawnWheel& drawn) {
      return drawn.is_whole && !drawn.is_fixed && wheel(drawn).body == body;
    });
  }

  void draw_legend() {
    if (!options_.which || *options_.which >= analysis_.cases.size()) {
      return;
    }
    std::vector<std::string> engaged;
    std::vector<std::string> driven;
    bool has_shift_elements = false;
    for (const SchemeElement& element : train_.elements) {
      const bool engages =
          element.kind == SchemeElementKind::clutch || element.kind == SchemeElementKind::brake;
      has_shift_elements = has_shift_elements || engages;
      if (element.is_engaged && element.kind != SchemeElementKind::output) {
        (engages ? engaged : driven).push_back(element.name);
      }
    }
    std::string text = analysis_.cases[*options_.which].which.label;
    const char* mark = ": ";
    const auto add = [&](const std::string& words) { text += std::exchange(mark, ", ") + words; };
    if (has_shift_elements) {
      add(engaged.empty() ? "nothing engaged"
                          : fmt::format("engaged {}", fmt::join(engaged, ", ")));
    }
    if (!driven.empty()) {
      add(fmt::format("driven by {}", fmt::join(driven, ", ")));
    }
    svg_.text({.x = layout_.box.left, .y = svg_.bounds().bottom + 20}, text, kSmall);
  }

  const Analysis& analysis_;
  const GearSchemeOptions& options_;
  const SchemeTrain& train_;
  const SchemeLayout& layout_;
  Svg svg_;
  NamePlacer placer_;
};

std::optional<GearSection> section_of(const Analysis& analysis, const GearSchemeOptions& options) {
  return options.sections != nullptr ? options.sections->find(analysis, options)
                                     : find_gear_section(analysis, options);
}

}  // namespace

std::optional<Picture> draw_gear_scheme(const Analysis& analysis,
                                        const GearSchemeOptions& options) {
  const std::optional<GearSection> section = section_of(analysis, options);
  if (!section) {
    return std::nullopt;
  }
  const SchemeLayout& layout = section->layout;
  const Svg svg = SchemeWriter(analysis, options, section->train, layout).write();
  return make_picture(
      "gear-scheme",
      options.which && *options.which < analysis.cases.size()
          ? picture_title_of_case("Gear scheme", analysis.cases[*options.which], analysis)
          : picture_title("Gear scheme", analysis),
      fmt::format("{}: {} wheels, {} elements.",
                  layout.axes.empty() ? "Half section along the main axis"
                                      : "Developed section, each axis at a height of its own",
                  section->train.wheels.size(),
                  section->train.elements.size()),
      svg);
}

std::string why_no_gear_scheme(const Analysis& analysis, GearSections* sections) {
  if (std::string reason = why_no_scheme_train(analysis.description); !reason.empty()) {
    return reason + "; 'linkage' shows the gears from the front";
  }
  if (section_of(analysis, {.which = {}, .sections = sections})) {
    return "";
  }
  return find_scheme_train(analysis, {}) ? "in a section its shafts cannot pass each other and the "
                                           "gears; 'linkage' shows the gears from the front"
                                         : "no gears with parallel axes mesh";
}

}  // namespace kinestat
