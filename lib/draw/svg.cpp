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

// Points of lines and areas have one decimal: by as much lines are thinned.
std::string point_text(double value) {
  return format_coordinate(std::round(10.0 * value) / 10.0);
}

std::string pair_text(PixelPoint point) {
  return point_text(point.x) + "," + point_text(point.y);
}

// In the data of a path, where a sign parts numbers as well as a comma does.
std::string data_text(PixelPoint point) {
  const std::string y = point_text(point.y);
  return point_text(point.x) + (y.starts_with('-') ? "" : ",") + y;
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

std::string text_attribute(std::string_view name, std::string_view value) {
  std::string text;
  return text.append(" ").append(name).append("=\"").append(value).append("\"");
}

// Text needs more contrast than lines: three inks of the series have too little on paper.
Ink text_ink(Ink ink) {
  return ink == Ink::vermilion || ink == Ink::pink || ink == Ink::sky ? Ink::ink : ink;
}

// "ks-f-paper ks-s-blue ks-r"; empty if nothing is painted.
std::string ink_classes(Ink stroke, Ink fill, bool round_ends = false) {
  std::string text;
  if (fill != Ink::none) {
    text += fmt::format("ks-f-{}", ink_name(fill));
  }
  if (stroke != Ink::none) {
    text += fmt::format("{}ks-s-{}", text.empty() ? "" : " ", ink_name(stroke));
    text += round_ends ? " ks-r" : "";
  }
  return text.empty() ? text : " class=\"" + text + "\"";
}

double stroke_margin(const Paint& paint) {
  return paint.stroke == Ink::none ? 0.0 : paint.width / 2;
}

std::string number_attribute(std::string_view name, double value) {
  return text_attribute(name, format_coordinate(value));
}

// Behind what is drawn: colours, width, dashes.
std::string paint_attributes(const Paint& paint) {
  std::string text = ink_classes(paint.stroke, paint.fill, paint.round_ends) +
                     text_attribute("fill", light_value(paint.fill));
  if (paint.fill != Ink::none && paint.opacity < 1.0) {
    text += number_attribute("fill-opacity", paint.opacity);
  }
  if (paint.stroke != Ink::none) {
    text += text_attribute("stroke", light_value(paint.stroke));
    if (paint.width != 1.0) {
      text += number_attribute("stroke-width", paint.width);
    }
    if (!paint.dash.empty()) {
      text += fmt::format(" stroke-dasharray=\"{}\"", paint.dash);
    }
    if (paint.round_ends) {
      text += " stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    }
  }
  return text;
}

// Of a text, but its place.
std::string text_attributes(const TextStyle& style) {
  std::string text = number_attribute("font-size", style.size);
  if (style.anchor != Anchor::start) {
    text += fmt::format(" text-anchor=\"{}\"", anchor_word(style.anchor));
  }
  if (style.weight == Weight::bold) {
    text += " font-weight=\"bold\"";
  }
  if (style.is_italic) {
    text += " font-style=\"italic\"";
  }
  text += ink_classes(style.has_halo ? Ink::paper : Ink::none, text_ink(style.ink)) +
          text_attribute("fill", light_value(text_ink(style.ink)));
  if (style.has_halo) {
    text += text_attribute("stroke", light_value(Ink::paper)) +
            " stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
  }
  return text;
}

// "M24,-22.35V-239"
std::string line_data(PixelPoint from, PixelPoint to) {
  const std::string x = point_text(to.x);
  const std::string y = point_text(to.y);
  const bool is_upright = x == point_text(from.x);
  const bool is_level = y == point_text(from.y);
  return "M" + data_text(from) + (is_upright ? "V" + y : is_level ? "H" + x : "L" + data_text(to));
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
  elements_ += paint_attributes(paint) + "/>\n";
}

// An element that stands alone, or what it adds to those of its kind and style before it.
void Svg::join(ElementRun::Kind kind,
               std::string style,
               std::string part,
               const std::string& alone) {
  const bool is_text = kind == ElementRun::Kind::texts;
  const std::string tail = is_text ? "</g>\n" : "\"" + style + "/>\n";
  if (run_.kind != kind || run_.end != elements_.size() || run_.style != style) {
    run_ = {.kind = kind,
            .style = std::move(style),
            .first = std::move(part),
            .begin = elements_.size(),
            .end = 0,
            .is_whole = false};
    elements_ += alone;
  } else if (run_.is_whole) {
    elements_.insert(elements_.size() - tail.size(), part);
  } else {
    elements_.resize(run_.begin);
    elements_ += (is_text ? "<g" + style + ">\n" : "<path d=\"") + run_.first + part + tail;
    run_.is_whole = true;
  }
  run_.end = elements_.size();
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
  const std::string style = paint_attributes(paint);
  join(ElementRun::Kind::lines,
       style,
       line_data(from, to),
       "<line" + number_attribute("x1", from.x) + number_attribute("y1", from.y) +
           number_attribute("x2", to.x) + number_attribute("y2", to.y) + style + "/>\n");
  include(from, stroke_margin(paint));
  include(to, stroke_margin(paint));
  keep(std::array{from, to}, false, paint);
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
    const std::vector<PixelPoint> piece = thinned_line(points.subspan(begin, end - begin));
    for (const PixelPoint& point : piece) {
      data += std::exchange(command, "L") + data_text(point);
    }
    keep(piece, false, paint);
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
  const std::string style = paint_attributes(round);
  join(ElementRun::Kind::lines, style, data, "<path d=\"" + data + "\"" + style + "/>\n");
}

void Svg::polygon(std::span<const PixelPoint> corners, const Paint& paint) {
  std::string points;
  for (const PixelPoint& corner : corners) {
    include(corner, stroke_margin(paint));
  }
  const std::vector<PixelPoint> rim = thinned_line(corners);
  for (const PixelPoint& corner : rim) {
    points += (points.empty() ? "" : " ") + pair_text(corner);
  }
  keep(rim, true, paint);
  open_element("polygon");
  attribute("points", points);
  close_element(paint);
}

void Svg::rectangle(const PixelBox& box, const Paint& paint, double corner_radius) {
  KINESTAT_EXPECTS(!box.is_empty());
  include(box.grown(stroke_margin(paint)));
  keep(std::array{PixelPoint{.x = box.left, .y = box.top},
                  PixelPoint{.x = box.right, .y = box.top},
                  PixelPoint{.x = box.right, .y = box.bottom},
                  PixelPoint{.x = box.left, .y = box.bottom}},
       true,
       paint);
  const std::string style = paint_attributes(paint);
  std::string alone = "<rect" + number_attribute("x", box.left) + number_attribute("y", box.top) +
                      number_attribute("width", box.width()) +
                      number_attribute("height", box.height());
  if (corner_radius > 0.0) {
    alone += number_attribute("rx", corner_radius);
  }
  alone += style + "/>\n";
  if (corner_radius > 0.0 || paint.stroke != Ink::none || paint.opacity < 1.0) {
    elements_ += alone;
    return;
  }
  join(ElementRun::Kind::areas,
       style,
       fmt::format("M{}h{}v{}h{}z",
                   data_text({.x = box.left, .y = box.top}),
                   format_coordinate(box.width()),
                   format_coordinate(box.height()),
                   format_coordinate(-box.width())),
       alone);
}

void Svg::circle(PixelPoint centre, double radius, const Paint& paint) {
  KINESTAT_EXPECTS(radius >= 0.0);
  open_element("circle");
  attribute("cx", centre.x);
  attribute("cy", centre.y);
  attribute("r", radius);
  close_element(paint);
  include(centre, radius + stroke_margin(paint));
  keep_rim(centre, radius, paint);
}

void Svg::path(std::string_view data, const PixelBox& bounds, const Paint& paint) {
  open_element("path");
  attribute("d", data);
  close_element(paint);
  include(bounds.grown(stroke_margin(paint)));
}

void Svg::strokes(std::span<const PixelLine> lines, const Paint& paint) {
  if (lines.empty()) {
    return;
  }
  std::string data;
  for (const PixelLine& one : lines) {
    data += line_data(one.from, one.to);
    include(one.from, stroke_margin(paint));
    include(one.to, stroke_margin(paint));
    keep(std::array{one.from, one.to}, false, paint);
  }
  const std::string style = paint_attributes(paint);
  join(ElementRun::Kind::lines, style, data, "<path d=\"" + data + "\"" + style + "/>\n");
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
  // It turns the same way as rectangles: where areas overlap nothing is cut out.
  const Paint paint = {.stroke = Ink::none, .fill = ink};
  const std::string style = paint_attributes(paint);
  std::string points;
  std::string data;
  for (const PixelPoint& corner : corners) {
    include(corner, 0.0);
    points += (points.empty() ? "" : " ") + pair_text(corner);
    data += (data.empty() ? "M" : "L") + data_text(corner);
  }
  keep(corners, true, paint);
  join(ElementRun::Kind::areas,
       style,
       data + "z",
       "<polygon points=\"" + points + "\"" + style + "/>\n");
}

void Svg::hatch(const PixelBox& box, Ink ink, double distance) {
  KINESTAT_EXPECTS(distance > 0.0);
  // Lines x + y = s, from the lower left to the upper right of where they cross the box.
  std::string data;
  for (double s = box.left + box.top + distance; s < box.right + box.bottom; s += distance) {
    const double low = std::min(box.bottom, s - box.left);
    const double high = std::max(box.top, s - box.right);
    data += "M" + data_text({.x = s - low, .y = low}) + "l" +
            data_text({.x = low - high, .y = high - low});
    keep(std::array{PixelPoint{.x = s - low, .y = low}, PixelPoint{.x = s - high, .y = high}},
         false,
         {.stroke = ink});
  }
  if (!data.empty()) {
    const std::string style = paint_attributes({.stroke = ink, .width = 1.0});
    join(ElementRun::Kind::lines, style, data, "<path d=\"" + data + "\"" + style + "/>\n");
    include(box);
  }
}

void Svg::text(PixelPoint place, std::string_view text, const TextStyle& style) {
  if (text.empty()) {
    return;
  }
  const std::string common = text_attributes(style);
  const std::string begin =
      "<text" + number_attribute("x", place.x) + number_attribute("y", place.y);
  std::string rest;
  if (style.turn != 0.0) {
    rest = fmt::format(" transform=\"rotate({} {} {})\"",
                       format_coordinate(style.turn),
                       format_coordinate(place.x),
                       format_coordinate(place.y));
  }
  rest += ">" + escape_markup(text) + "</text>\n";
  join(ElementRun::Kind::texts, common, begin + rest, begin + common + rest);
  include(text_box(place, text, style));
}

void Svg::column(double x,
                 std::span<const std::pair<double, std::string>> texts,
                 const TextStyle& style) {
  KINESTAT_EXPECTS(style.turn == 0.0);
  if (texts.empty()) {
    return;
  }
  elements_ += fmt::format(
      "<g transform=\"translate({})\"{}>\n", format_coordinate(x), text_attributes(style));
  for (const auto& [y, text] : texts) {
    elements_ += "<text" + number_attribute("y", y) + ">" + escape_markup(text) + "</text>\n";
    include(text_box({.x = x, .y = y}, text, style));
  }
  elements_ += "</g>\n";
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
  if (hidden_from_ == 0 &&
      std::ranges::find(attributes, "display", &Attribute::first) != attributes.end()) {
    hidden_from_ = open_groups_;
  }
}

void Svg::close_group() {
  KINESTAT_EXPECTS(open_groups_ > 0);
  elements_ += "</g>\n";
  if (moving_ && moving_->depth == open_groups_) {
    include_moved(*std::exchange(moving_, std::nullopt));
  }
  hidden_from_ = hidden_from_ == open_groups_ ? 0 : hidden_from_;
  --open_groups_;
}

void Svg::add(const Svg& other) {
  elements_ += other.elements();
  include(other.bounds());
  if (keeps_lines_ && hidden_from_ == 0) {
    lines_.insert(lines_.end(), other.lines_.begin(), other.lines_.end());
  }
}

void Svg::use(const std::string& id, PixelPoint by, const PixelBox& bounds) {
  elements_ += "<use href=\"#" + id + "\"" + number_attribute("x", by.x) +
               number_attribute("y", by.y) + "/>\n";
  include(bounds);
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
