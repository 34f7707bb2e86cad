#include "draw/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "draw/markup.hpp"
#include "draw/picture.hpp"
#include "draw/thinned_line.hpp"

namespace kinestat {

namespace {

// Of letters above and below the base line, as shares of the size.
constexpr double kAscent = 0.76;
constexpr double kDescent = 0.24;

// The half width of an arrow head as a share of its length.
constexpr double kHeadShare = 0.36;

bool is_finite(PixelPoint point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

std::string pair_text(PixelPoint point) {
  return format_coordinate(point.x) + "," + format_coordinate(point.y);
}

std::string_view anchor_word(Anchor anchor) {
  switch (anchor) {
    case Anchor::start:
      return "start";
    case Anchor::middle:
      return "middle";
    case Anchor::end:
      return "end";
  }
  return {};
}

std::string ink_attributes(std::string_view property, Ink ink) {
  return fmt::format(" {}=\"{}\"", property, light_value(ink));
}

// Text needs more contrast than lines: three inks of the series have too little on paper.
Ink text_ink(Ink ink) {
  return ink == Ink::vermilion || ink == Ink::pink || ink == Ink::sky ? Ink::ink : ink;
}

// "ks-s-blue ks-f-paper"; empty if nothing is painted.
std::string ink_classes(Ink stroke, Ink fill) {
  std::string text;
  if (fill != Ink::none) {
    text += fmt::format("ks-f-{}", ink_name(fill));
  }
  if (stroke != Ink::none) {
    text += fmt::format("{}ks-s-{}", text.empty() ? "" : " ", ink_name(stroke));
  }
  return text.empty() ? text : " class=\"" + text + "\"";
}

double stroke_margin(const Paint& paint) {
  return paint.stroke == Ink::none ? 0.0 : paint.width / 2;
}

}  // namespace

void Svg::open_element(std::string_view name) {
  elements_ += fmt::format("<{}", name);
}

void Svg::attribute(std::string_view name, std::string_view value) {
  elements_ += fmt::format(" {}=\"{}\"", name, value);
}

void Svg::attribute(std::string_view name, double value) {
  attribute(name, format_coordinate(value));
}

void Svg::close_element(const Paint& paint) {
  elements_ += ink_classes(paint.stroke, paint.fill) + ink_attributes("fill", paint.fill);
  if (paint.fill != Ink::none && paint.opacity < 1.0) {
    attribute("fill-opacity", paint.opacity);
  }
  if (paint.stroke != Ink::none) {
    elements_ += ink_attributes("stroke", paint.stroke);
    if (paint.width != 1.0) {
      attribute("stroke-width", paint.width);
    }
    if (!paint.dash.empty()) {
      attribute("stroke-dasharray", paint.dash);
    }
    if (paint.round_ends) {
      elements_ += " stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    }
  }
  elements_ += "/>\n";
}

void Svg::include(const PixelBox& box) {
  if (!moving_) {
    bounds_.add(box);
    return;
  }
  if (box.is_empty()) {
    return;
  }
  for (const double x : {box.left, box.right}) {
    for (const double y : {box.top, box.bottom}) {
      include(PixelPoint{.x = x, .y = y}, 0.0);
    }
  }
}

void Svg::include(PixelPoint point, double margin) {
  if (moving_) {
    moving_->reach.emplace_back(point, margin);
    return;
  }
  bounds_.add(
      PixelBox{.left = point.x, .top = point.y, .right = point.x, .bottom = point.y}.grown(margin));
}

void Svg::line(PixelPoint from, PixelPoint to, const Paint& paint) {
  open_element("line");
  attribute("x1", from.x);
  attribute("y1", from.y);
  attribute("x2", to.x);
  attribute("y2", to.y);
  close_element(paint);
  include(from, stroke_margin(paint));
  include(to, stroke_margin(paint));
}

void Svg::polyline(std::span<const PixelPoint> points, const Paint& paint) {
  std::string data;
  const auto end_of_piece = [&](std::size_t begin) {
    while (begin < points.size() && is_finite(points[begin])) {
      ++begin;
    }
    return begin;
  };
  for (std::size_t begin = 0; begin < points.size();) {
    const std::size_t end = end_of_piece(begin);
    const char* command = "M";
    for (const PixelPoint& point : thinned_line(points.subspan(begin, end - begin))) {
      data += std::exchange(command, "L") + pair_text(point);
    }
    if (end == begin + 1) {
      data += "h0.01";
    }
    for (std::size_t i = begin; i < end; ++i) {
      include(points[i], stroke_margin(paint));
    }
    begin = end + 1;
  }
  if (data.empty()) {
    return;
  }
  Paint round = paint;
  round.round_ends = paint.dash.empty();
  open_element("path");
  attribute("d", data);
  close_element(round);
}

void Svg::polygon(std::span<const PixelPoint> corners, const Paint& paint) {
  std::string points;
  for (const PixelPoint& corner : corners) {
    include(corner, stroke_margin(paint));
  }
  for (const PixelPoint& corner : thinned_line(corners)) {
    points += (points.empty() ? "" : " ") + pair_text(corner);
  }
  open_element("polygon");
  attribute("points", points);
  close_element(paint);
}

void Svg::rectangle(const PixelBox& box, const Paint& paint, double corner_radius) {
  KINESTAT_EXPECTS(!box.is_empty());
  open_element("rect");
  attribute("x", box.left);
  attribute("y", box.top);
  attribute("width", box.width());
  attribute("height", box.height());
  if (corner_radius > 0.0) {
    attribute("rx", corner_radius);
  }
  close_element(paint);
  include(box.grown(stroke_margin(paint)));
}

void Svg::circle(PixelPoint centre, double radius, const Paint& paint) {
  KINESTAT_EXPECTS(radius >= 0.0);
  open_element("circle");
  attribute("cx", centre.x);
  attribute("cy", centre.y);
  attribute("r", radius);
  close_element(paint);
  include(centre, radius + stroke_margin(paint));
}

void Svg::path(std::string_view data, const PixelBox& bounds, const Paint& paint) {
  open_element("path");
  attribute("d", data);
  close_element(paint);
  include(bounds.grown(stroke_margin(paint)));
}

void Svg::arrow(PixelPoint from, PixelPoint to, const Paint& paint, double head) {
  const PixelPoint along = {.x = to.x - from.x, .y = to.y - from.y};
  const double length = std::hypot(along.x, along.y);
  if (length > head) {
    // The line ends inside the head, so that it does not show beside the tip.
    const double share = (length - head / 2) / length;
    line(from, {.x = from.x + share * along.x, .y = from.y + share * along.y}, paint);
  }
  arrow_head(to, along, paint.stroke, head);
}

void Svg::arrow_head(PixelPoint tip, PixelPoint direction, Ink ink, double length) {
  const double size = std::hypot(direction.x, direction.y);
  if (size == 0.0) {
    return;
  }
  const PixelPoint unit = {.x = direction.x / size, .y = direction.y / size};
  const PixelPoint base = {.x = tip.x - length * unit.x, .y = tip.y - length * unit.y};
  const double half = kHeadShare * length;
  const std::array<PixelPoint, 3> corners = {{
      tip,
      {.x = base.x - half * unit.y, .y = base.y + half * unit.x},
      {.x = base.x + half * unit.y, .y = base.y - half * unit.x},
  }};
  polygon(corners, {.stroke = Ink::none, .fill = ink});
}

void Svg::hatch(const PixelBox& box, Ink ink, double distance) {
  KINESTAT_EXPECTS(distance > 0.0);
  // Lines x + y = s, from the lower left to the upper right of where they cross the box.
  std::string data;
  for (double s = box.left + box.top + distance; s < box.right + box.bottom; s += distance) {
    const double low = std::min(box.bottom, s - box.left);
    const double high = std::max(box.top, s - box.right);
    data += "M" + pair_text({.x = s - low, .y = low}) + "L" + pair_text({.x = s - high, .y = high});
  }
  if (!data.empty()) {
    path(data, box.grown(-0.5), {.stroke = ink, .width = 1.0});
  }
}

void Svg::text(PixelPoint place, std::string_view text, const TextStyle& style) {
  if (text.empty()) {
    return;
  }
  open_element("text");
  attribute("x", place.x);
  attribute("y", place.y);
  attribute("font-size", style.size);
  if (style.anchor != Anchor::start) {
    attribute("text-anchor", anchor_word(style.anchor));
  }
  if (style.weight == Weight::bold) {
    attribute("font-weight", "bold");
  }
  if (style.is_italic) {
    attribute("font-style", "italic");
  }
  if (style.turn != 0.0) {
    attribute("transform",
              fmt::format("rotate({} {} {})",
                          format_coordinate(style.turn),
                          format_coordinate(place.x),
                          format_coordinate(place.y)));
  }
  elements_ += ink_classes(style.has_halo ? Ink::paper : Ink::none, text_ink(style.ink));
  elements_ += ink_attributes("fill", text_ink(style.ink));
  if (style.has_halo) {
    elements_ += ink_attributes("stroke", Ink::paper) +
                 " stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
  }
  elements_ += ">" + escape_markup(text) + "</text>\n";
  include(text_box(place, text, style));
}

void Svg::open_group(std::string_view title, std::span<const Attribute> attributes) {
  open_element("g");
  for (const auto& [name, value] : attributes) {
    // The mark of `id` is replaced where the picture is embedded and must survive the escaping.
    const bool has_id = name == "id" || name == "href";
    const std::size_t mark = has_id ? value.find(kIdMark) : std::string::npos;
    const std::size_t rest = mark == std::string::npos ? 0 : mark + kIdMark.size();
    attribute(name, value.substr(0, rest) + escape_markup(std::string_view(value).substr(rest)));
  }
  elements_ += ">";
  if (!title.empty()) {
    elements_ += "<title>" + escape_markup(title) + "</title>";
  }
  elements_ += "\n";
  ++open_groups_;
}

void Svg::close_group() {
  KINESTAT_EXPECTS(open_groups_ > 0);
  elements_ += "</g>\n";
  if (moving_ && moving_->depth == open_groups_) {
    include_moved(*std::exchange(moving_, std::nullopt));
  }
  --open_groups_;
}

void Svg::add(const Svg& other) {
  elements_ += other.elements();
  include(other.bounds());
}

std::string Svg::id(std::string_view name) {
  return std::string(kIdMark) + std::string(name);
}

const std::string& Svg::elements() const {
  KINESTAT_EXPECTS(open_groups_ == 0);
  return elements_;
}

PixelBox text_box(PixelPoint place, std::string_view text, const TextStyle& style) {
  const double width = text_width(text, style.size, style.weight);
  const double shift = style.anchor == Anchor::start    ? 0.0
                       : style.anchor == Anchor::middle ? -width / 2
                                                        : -width;
  const double angle = style.turn * std::numbers::pi / 180;
  PixelBox box;
  for (const double x : {shift, shift + width}) {
    for (const double y : {-kAscent * style.size, kDescent * style.size}) {
      box.add(PixelPoint{.x = place.x + x * std::cos(angle) - y * std::sin(angle),
                         .y = place.y + x * std::sin(angle) + y * std::cos(angle)});
    }
  }
  return box;
}

}  // namespace kinestat
