#include "draw/linkage/linkage_canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/text.hpp"
#include "draw/symbols.hpp"
#include "draw/text_styles.hpp"

namespace kinestat {

namespace {

constexpr double kLongestArrow = 96.0;
constexpr double kShortestArrow = 20.0;
constexpr double kTurningRadius = 19.0;

Ink ink_of(ArrowKind kind) {
  switch (kind) {
    case ArrowKind::reaction:
    case ArrowKind::load:
    case ArrowKind::actuator:
      return Ink::vermilion;
    case ArrowKind::drive:
      return Ink::blue;
    case ArrowKind::velocity:
      return Ink::green;
  }
  return Ink::ink;
}

bool is_force(const DrawnArrow& arrow) {
  return !arrow.is_axial && arrow.kind != ArrowKind::drive && arrow.kind != ArrowKind::velocity;
}

}  // namespace

std::string body_mark(const Topology& topology, BodyId body) {
  return fmt::format("{}-{}", topology.body(body).name, body.value);
}

Ink body_ink(BodyId body) {
  // That of forces is left to them.
  constexpr std::array<Ink, 5> kInksOfBodies = {
      Ink::sky, Ink::green, Ink::pink, Ink::brown, Ink::blue};
  return body.value == 0
             ? Ink::ink
             : kInksOfBodies[static_cast<std::size_t>(body.value - 1) % kInksOfBodies.size()];
}

Ink path_ink(std::size_t path) {
  return series_ink(static_cast<int>(path) + 1);  // the first is that of drives
}

LinkageCanvas::LinkageCanvas(const Analysis& analysis,
                             const LinkageOptions& options,
                             const LinkageView& view)
    : analysis_(analysis),
      options_(options),
      view_(view),
      arrows_(find_arrows(analysis, options)),
      places_(analysis.mechanism.geometry.points) {
  svg_.keep_lines();
  for (const DrawnArrow& arrow : arrows_) {
    if (is_force(arrow)) {
      largest_force_ = std::max(largest_force_, arrow.vector.norm());
    }
  }
}

void LinkageCanvas::open_body(BodyId body) {
  const Topology& topology = analysis_.mechanism.topology;
  const std::array<Attribute, 1> marks = {{{"data-body", body_mark(topology, body)}}};
  const std::string& name = topology.body(body).name;
  if (const BodyTrack* const track = track_of(body)) {
    svg_.open_moving_group(name, marks, on_picture(*track), options_.cycle->pace);
  } else {
    svg_.open_group(name, marks);
  }
}

const BodyTrack* LinkageCanvas::track_of(BodyId body) const {
  return options_.cycle && !options_.cycle->tracks.empty()
             ? &options_.cycle->tracks[static_cast<std::size_t>(body.value)]
             : nullptr;
}

// Of a view along -z, on which y points down, so that what turns about +z turns anticlockwise.
GroupMotion LinkageCanvas::on_picture(const BodyTrack& track) const {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  GroupMotion motion;
  motion.pivot = view_.at(track.point);
  for (const Vec3& place : track.places) {
    motion.shifts.push_back(view_.along(place - track.point));
  }
  for (const double turn : track.turns) {
    motion.turns.push_back(-kDegrees * turn);
  }
  return motion;
}

void LinkageCanvas::open_layer(const std::string& name) {
  const std::array<Attribute, 1> marks = {{{"data-layer", name}}};
  svg_.open_group({}, marks);
}

void LinkageCanvas::name(std::string text, PixelPoint anchor, double distance, Ink ink) {
  name(std::move(text), std::vector{anchor}, distance, ink);
}

void LinkageCanvas::name(std::string text,
                         std::vector<PixelPoint> anchors,
                         double distance,
                         Ink ink) {
  names_.push_back({.text = std::move(text),
                    .anchors = std::move(anchors),
                    .distance = distance,
                    .style = {.ink = ink, .size = 13.0, .weight = Weight::bold, .has_halo = true}});
}

// Of couplings that share a place, as all those on the axis of a gear train do, the first few are
// named; all of them in the title.
void LinkageCanvas::name_couplings() {
  constexpr double kNear = 5.0;
  constexpr std::size_t kMostNamed = 4;

  struct Place {
    PixelPoint at;
    std::vector<std::string> couplings;
  };

  std::vector<Place> found;
  for (int e = 0; e < analysis_.mechanism.topology.coupling_count(); ++e) {
    const auto& written = analysis_.description.couplings[static_cast<std::size_t>(e)];
    if (written.part != nullptr && written.part->segment == 0) {
      continue;  // of a virtual link
    }
    const PixelPoint at = view_.at(place(CouplingId{e}));
    auto same = std::ranges::find_if(
        found, [&](const Place& other) { return length_of(other.at - at) < kNear; });
    if (same == found.end()) {
      same = found.insert(same, {.at = at, .couplings = {}});
    }
    same->couplings.push_back(analysis_.mechanism.topology.coupling(CouplingId{e}).name);
  }
  for (const Place& one : found) {
    names_.push_back(
        {.text = plain_list(one.couplings, kMostNamed),
         .title = one.couplings.size() > kMostNamed
                      ? plain_list(one.couplings, one.couplings.size())
                      : std::string(),
         .anchors = {one.at},
         .distance = 8.0,
         .style = {.ink = Ink::ink, .size = 12.0, .has_halo = true, .is_italic = true}});
  }
}

void LinkageCanvas::draw_paths() {
  open_layer("paths");
  for (std::size_t i = 0; i < options_.paths.size(); ++i) {
    const TracedPath& path = options_.paths[i];
    std::vector<PixelPoint> points;
    for (const Vec3& p : path.points) {
      points.push_back(view_.at(p));
    }
    const int series = static_cast<int>(i) + 1;
    svg_.open_group(path.name);
    svg_.polyline(points,
                  {.stroke = path_ink(i), .width = 1.6, .dash = std::string(series_dash(series))});
    svg_.close_group();
    if (!points.empty()) {
      name(path.name, points.front(), 7.0, path_ink(i));
    }
  }
  svg_.close_group();
}

void LinkageCanvas::draw_arrow(const DrawnArrow& arrow, double factor) {
  const PixelPoint at = view_.at(arrow.at);
  const PixelPoint seen = view_.along(arrow.vector);
  const double share =
      arrow.vector.norm() > 0.0 ? length_of(seen) / (view_.scale * arrow.vector.norm()) : 0.0;
  const double length = std::max(kShortestArrow, factor * arrow.vector.norm()) * share;
  if (length < 2.0) {
    return;  // it points at the reader
  }
  const PixelPoint unit = unit_of(seen);
  const bool pushes = arrow.kind == ArrowKind::load;
  const double away = arrow.kind == ArrowKind::drive ? 20.0 : 0.0;
  const PixelPoint side = away * left_of(unit);
  const PixelPoint from = (pushes ? at - (length + 5.0) * unit : at) + side;
  const PixelPoint to = (pushes ? at - 5.0 * unit : at + length * unit) + side;
  svg_.arrow(from, to, {.stroke = ink_of(arrow.kind), .width = pushes ? 2.8 : 2.2}, 11.0);
  names_.push_back({.text = arrow.text,
                    .anchors = {pushes ? from : to},
                    .distance = 4.0,
                    .style = {.ink = ink_of(arrow.kind), .size = 11.0, .has_halo = true}});
}

void LinkageCanvas::draw_axial(const DrawnArrow& arrow) {
  const PixelPoint at = view_.at(arrow.at);
  const Vec3 out = view_.right.cross(view_.up);
  const double towards = out.dot(arrow.vector) / arrow.vector.norm();
  const Paint paint = {.stroke = ink_of(arrow.kind), .width = 1.8};
  if (std::abs(towards) > 0.3) {
    const auto others = std::ranges::count_if(
        turnings_, [&](PixelPoint other) { return length_of(other - at) < 4.0; });
    const double radius = kTurningRadius + 9.0 * static_cast<double>(others);
    turnings_.push_back(at);
    draw_turning_arrow(svg_, at, radius, towards > 0.0, paint);
    names_.push_back({.text = arrow.text,
                      .anchors = {at},
                      .distance = radius + 4.0,
                      .style = {.ink = paint.stroke, .size = 11.0, .has_halo = true}});
    return;
  }
  // Seen from the side it is an arrow with two heads along its axis.
  const PixelPoint unit = unit_of(view_.along(arrow.vector));
  const PixelPoint to = at + 44.0 * unit;
  svg_.arrow(at, to, paint, 9.0);
  svg_.arrow_head(to - 7.0 * unit, unit, paint.stroke, 9.0);
  names_.push_back({.text = arrow.text,
                    .anchors = {to},
                    .distance = 4.0,
                    .style = {.ink = paint.stroke, .size = 11.0, .has_halo = true}});
}

void LinkageCanvas::draw_arrows() {
  double fastest = 0.0;
  for (const DrawnArrow& arrow : arrows_) {
    if (!arrow.is_axial && arrow.kind == ArrowKind::velocity) {
      fastest = std::max(fastest, arrow.vector.norm());
    }
  }

  struct Layer {
    std::string name;
    bool (*holds)(const DrawnArrow&);
    double largest = 0.0;
  };

  const std::array<Layer, 3> layers = {{
      {"drives", [](const DrawnArrow& a) { return a.kind == ArrowKind::drive; }, 0.0},
      {"velocities", [](const DrawnArrow& a) { return a.kind == ArrowKind::velocity; }, fastest},
      {"forces",
       [](const DrawnArrow& a) { return a.is_axial ? a.kind != ArrowKind::drive : is_force(a); },
       largest_force_},
  }};
  for (const Layer& layer : layers) {
    open_layer(layer.name);
    for (const DrawnArrow& arrow : arrows_) {
      if (layer.holds(arrow) && arrow.is_axial) {
        draw_axial(arrow);
      } else if (layer.holds(arrow)) {
        const bool is_drive = arrow.kind == ArrowKind::drive;
        draw_arrow(arrow, is_drive ? 40.0 / arrow.vector.norm() : kLongestArrow / layer.largest);
      }
    }
    svg_.close_group();
  }
}

void LinkageCanvas::draw_names() {
  constexpr std::size_t kMostNames = 500;  // nobody reads more, and they take long
  if (names_.size() > kMostNames) {
    names_.clear();
  }
  open_layer("names");
  NamePlacer placer;
  placer.keep_off(svg_.lines());
  for (const WaitingName& name : names_) {
    const PlacedName label = placer.place(name.anchors, name.text, name.style, name.distance);
    if (!name.title.empty()) {
      svg_.open_group(name.title);
    }
    write_label(svg_, label, name.text, name.style);
    if (!name.title.empty()) {
      svg_.close_group();
    }
  }
  svg_.close_group();
}

PixelBox LinkageCanvas::bounds() const {
  constexpr double kSymbol = 24.0;  // what stands around a place
  PixelBox box = svg_.bounds();
  for (const Vec3& p : options_.reach) {
    PixelBox place;
    place.add(view_.at(p));
    box.add(place.grown(kSymbol));
  }
  return box;
}

double LinkageCanvas::draw_scale(PixelPoint from) {
  const FileUnits& units = analysis_.description.units;
  if (has_free_parameters(analysis_.description)) {
    const std::string text = "places of free parameters are examples: no scale";
    svg_.text({.x = from.x, .y = from.y + 4}, text, kSmall);
    return from.x + text_width(text, kSmall.size);
  }
  const double per_unit = view_.scale * units.factor(QuantityKind::length);
  const double length = round_length(110.0 / per_unit);
  const double end = from.x + length * per_unit;
  svg_.line(from, {.x = end, .y = from.y}, {.stroke = Ink::ink, .width = 1.4});
  for (const double tick : {from.x, end}) {
    svg_.line({.x = tick, .y = from.y - 4}, {.x = tick, .y = from.y + 4}, {.stroke = Ink::ink});
  }
  const std::string text =
      fmt::format("{} {}", short_number(length), units.text(QuantityKind::length));
  svg_.text({.x = end + 8, .y = from.y + 4}, text, kSmall);
  return end + 8 + text_width(text, kSmall.size);
}

void LinkageCanvas::draw_legend() {
  const FileUnits& units = analysis_.description.units;
  const PixelBox drawn = bounds();
  const double y = drawn.bottom + 26.0;
  double x = drawn.left;
  x = draw_scale({.x = x, .y = y}) + 26;
  std::vector<std::string> lines;
  if (largest_force_ > 0.0) {
    const double force = round_length(units.from_si(QuantityKind::force, largest_force_));
    const double arrow = kLongestArrow * units.to_si(QuantityKind::force, force) / largest_force_;
    svg_.arrow(
        {.x = x, .y = y}, {.x = x + arrow, .y = y}, {.stroke = Ink::vermilion, .width = 1.8}, 9.0);
    const std::string words =
        fmt::format("{} {}", short_number(force), units.text(QuantityKind::force));
    svg_.text({.x = x + arrow + 8, .y = y + 4}, words, kSmall);
    lines.emplace_back("in couplings the first body acts on the second");
  }
  if (!options_.remark.empty()) {
    lines.push_back(options_.remark);
  }
  if (options_.which && *options_.which < analysis_.cases.size()) {
    lines.push_back("case: " + analysis_.cases[*options_.which].which.label);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    svg_.text({.x = drawn.left, .y = y + 22 + 18 * static_cast<double>(i)}, lines[i], kSmall);
  }
}

}  // namespace kinestat
