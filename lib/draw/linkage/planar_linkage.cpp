#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "couplings/kinds.hpp"
#include "draw/linkage/file_numbers.hpp"
#include "draw/linkage/linkage_drawer.hpp"
#include "draw/linkage/linkage_frames.hpp"
#include "draw/linkage/planar_drawer.hpp"
#include "draw/symbols.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

constexpr double kHalfBar = 6.0;     // half the width of a link [px]
constexpr double kGuideHalf = 46.0;  // half the length of a guide [px]
constexpr double kGuideDepth = 9.5;  // from the middle of a block to its guide [px]
constexpr double kRingDepth = 9.0;

void draw_stretched_at(const Analysis& analysis,
                       const LinkageOptions& options,
                       const LinkageParts& parts,
                       LinkageCanvas& canvas);

std::size_t index(BodyId body) {
  return static_cast<std::size_t>(body.value);
}

class PlanarDrawing : private PlanarDrawer {
 public:
  using PlanarDrawer::PlanarDrawer;

  /// What no matrix moves.
  void draw_stretched() {
    draw_cables();
    draw_springs();
  }

  void draw_cables() {
    for (const CableLine& span : parts_.spans) {
      const std::array<Attribute, 1> marks = {
          {{"data-cable", topology_.coupling(span.coupling).name}}};
      svg_.open_group(topology_.coupling(span.coupling).name, marks);
      const PixelPoint from = canvas_.view().at(span.from);
      const PixelPoint to = canvas_.view().at(span.to);
      svg_.line(from, to, {.stroke = Ink::brown, .width = 2.2});
      svg_.close_group();
    }
    for (const CableArc& arc : parts_.arcs) {
      const std::array<Attribute, 1> marks = {{{"data-wrap", body_mark(topology_, arc.body)}}};
      svg_.open_group({}, marks);
      draw_wrap(arc);
      svg_.close_group();
    }
  }

  void draw_bodies() {
    for (const BodyId body : bodies_from_behind()) {
      canvas_.open_body(body);
      draw_wheels(body);
      draw_link(body);
      draw_traced(body);
      svg_.close_group();
    }
    draw_spirals();
  }

  void draw() {
    place_cables();
    draw_ground();
    draw_bodies();
    if (!options_.cycle) {
      draw_stretched();
    }
    draw_linkage_frames(analysis_, options_, canvas_, draw_stretched_at);
    canvas_.draw_paths();
    draw_planar_couplings(analysis_, options_, parts_, canvas_);
    if (options_.shows_names) {
      add_names();
    }
    canvas_.draw_arrows();
    canvas_.draw_names();
    canvas_.draw_legend();
  }

 private:
  void add_names() {
    canvas_.name_couplings();
    name_springs();
    for (const BodyId body : bodies_from_behind()) {
      name_body(body);
    }
    name_ground();
  }

  // Moving bodies that are drawn, those with the largest wheels first.
  std::vector<BodyId> bodies_from_behind() const {
    std::vector<BodyId> bodies = moving_bodies();
    std::ranges::stable_sort(
        bodies, [this](BodyId a, BodyId b) { return largest_wheel(a) > largest_wheel(b); });
    return bodies;
  }

  double largest_wheel(BodyId body) const {
    double radius = 0.0;
    for (const Wheel& wheel : parts_.wheels) {
      if (wheel.body == body) {
        radius = std::max(radius, wheel.radius);
      }
    }
    return radius;
  }

  // Pins that stand in the ground have one support a place.
  void draw_ground() {
    canvas_.open_body(BodyId{0});
    std::vector<PixelPoint> supports;
    for (const BodyPoint& point : points(BodyId{0})) {
      const PixelPoint pin = canvas_.view().at(point.at);
      const bool is_new = std::ranges::none_of(
          supports, [&](PixelPoint other) { return length_of(other - pin) < 3.0; });
      if (point.coupling && is_new && stands_in_support(*point.coupling)) {
        supports.push_back(pin);
        draw_support(svg_, pin);
      }
    }
    draw_wheels(BodyId{0});
    draw_outline(BodyId{0});
    for (const SpringLine& line : parts_.springs) {
      const Spring& spring = analysis_.mechanism.springs[line.spring];
      const PixelPoint from = canvas_.view().at(line.from);
      const PixelPoint to = canvas_.view().at(line.to);
      if (spring.tail.value == 0) {
        draw_anchor(from, to);
      }
      if (spring.head.value == 0) {
        draw_anchor(to, from);
      }
    }
    for (const CouplingTopology& coupling : topology_.couplings) {
      if (coupling.type == prismatic && guide_body(coupling).value == 0) {
        draw_guide(coupling);
      }
    }
    svg_.close_group();
  }

  // A piece of the ground across the spring that ends there.
  void draw_anchor(PixelPoint at, PixelPoint other_end) {
    constexpr double kHalf = 11.0;
    const PixelPoint along = unit_of(other_end - at);
    const PixelPoint across = {.x = -along.y, .y = along.x};
    draw_fixed_line(svg_, at - kHalf * across, at + kHalf * across);
  }

  bool stands_in_support(CouplingId coupling) const {
    switch (kind_of(topology_.coupling(coupling).type).planar_symbol) {
      case PlanarSymbol::pin:
      case PlanarSymbol::rack:
      case PlanarSymbol::square:
        return true;
      default:
        return false;
    }
  }

  void draw_guide(const CouplingTopology& coupling) {
    const CouplingId id{static_cast<int>(&coupling - topology_.couplings.data())};
    PixelPoint along = sliding_direction(coupling);
    // The fixed line runs so that its hatching is below, or at the right.
    if (along.x < -0.01 || (std::abs(along.x) <= 0.01 && along.y > 0.0)) {
      along = -1.0 * along;
    }
    const double depth =
        has_rack(coupling.tail) || has_rack(coupling.head) ? kRackDepth + 3.0 : kGuideDepth;
    const PixelPoint side = -depth * left_of(along);
    double back = 0.0;
    double ahead = 0.0;
    for (const Vec3& place : travel(id)) {
      const PixelPoint moved = canvas_.view().at(place) - at(id);
      const double share = moved.x * along.x + moved.y * along.y;
      back = std::min(back, share);
      ahead = std::max(ahead, share);
    }
    const PixelPoint from = at(id) + side + (back - kGuideHalf) * along;
    const PixelPoint to = at(id) + side + (ahead + kGuideHalf) * along;
    draw_fixed_line(svg_, from, to);
  }

  // Where the block comes in a motion.
  std::span<const Vec3> travel(CouplingId id) const {
    const auto e = static_cast<std::size_t>(id.value);
    return e < options_.travel.size() ? options_.travel[e] : std::span<const Vec3>();
  }

  void draw_outline(BodyId body) {
    std::vector<PixelPoint> corners;
    for (const Vec3& corner : parts_.outlines[index(body)]) {
      corners.push_back(canvas_.view().at(corner));
    }
    if (corners.size() > 2) {
      svg_.polygon(
          corners,
          {.stroke = body_ink(body), .fill = body_ink(body), .width = 1.4, .opacity = 0.14});
    }
  }

  void draw_wheels(BodyId body) {
    for (const Wheel& wheel : parts_.wheels) {
      if (wheel.body == body) {
        draw_wheel(wheel);
      }
    }
  }

  void draw_wheel(const Wheel& wheel) {
    const Ink ink = body_ink(wheel.body);
    const PixelPoint centre = canvas_.view().at(wheel.centre);
    const double radius = wheel.radius * canvas_.view().scale;
    if (wheel.kind == WheelKind::ring) {
      svg_.circle(centre, radius + kRingDepth, {.stroke = ink, .width = 1.4});
      svg_.circle(centre, radius, {.stroke = ink, .width = 1.2, .dash = "8 2 2 2"});
      draw_teeth(svg_, centre, radius, ink);
      return;
    }
    const bool is_gear = wheel.kind == WheelKind::gear;
    svg_.circle(centre,
                radius,
                {.stroke = ink,
                 .fill = ink,
                 .width = is_gear ? 1.2 : 1.6,
                 .dash = is_gear ? "8 2 2 2" : "",
                 .opacity = 0.1});
    if (is_gear) {
      draw_teeth(svg_, centre, radius, ink);
    } else if (radius > 9.0) {
      svg_.circle(centre, radius - 4.0, {.stroke = ink, .width = 0.8});
    }
    svg_.line(centre, centre + PixelPoint{.x = 0.0, .y = -radius}, {.stroke = ink, .width = 0.8});
  }

  // The places of a body: its couplings, its loads, points that are traced; slots and guides reach
  // further.
  std::vector<PixelPoint> places(BodyId body) const {
    std::vector<PixelPoint> result;
    for (const BodyPoint& point : points(body)) {
      const PixelPoint p = canvas_.view().at(point.at);
      add_place(p, result);
      if (!point.coupling) {
        continue;
      }
      const CouplingTopology& coupling = topology_.coupling(*point.coupling);
      const bool has_slot =
          kind_of(coupling.type).planar_symbol == PlanarSymbol::slot && coupling.head == body;
      const bool has_rod =
          coupling.type == prismatic && coupling.tail == body && guide_body(coupling).value != 0;
      if (has_slot || has_rod) {
        const double half = has_slot ? kSlotHalf : 0.8 * kGuideHalf;
        add_place(p + half * sliding_direction(coupling), result);
        add_place(p - half * sliding_direction(coupling), result);
      }
    }
    add_traced(body, result);
    return result;
  }

  void draw_link(BodyId body) {
    draw_outline(body);
    if (parts_.outlines[index(body)].size() > 2) {
      return;
    }
    const std::vector<PixelPoint> reached = places(body);
    if (reached.size() < 2) {
      return;
    }
    std::vector<Round> rounds;
    for (const PixelPoint& point : reached) {
      rounds.push_back({.centre = point, .radius = kHalfBar});
    }
    add_lobe(body, rounds);
    svg_.polygon(rounded_hull(rounds),
                 {.stroke = body_ink(body), .fill = body_ink(body), .width = 1.5, .opacity = 0.16});
  }

  // Of the tail (0) or the head (1) where they touch [px]; empty if it is flat or not known.
  std::optional<double> contact_radius(CouplingId id, std::size_t side) const {
    const auto& radii = analysis_.description.couplings[static_cast<std::size_t>(id.value)].radii;
    if (radii.size() != 2 || !radii[side]) {
      return std::nullopt;
    }
    const auto radius =
        FileNumbers(analysis_.description).number(*radii[side], QuantityKind::length);
    return radius && *radius > 0.0 ? std::optional(*radius * canvas_.view().scale) : std::nullopt;
  }

  // A cam is round where it touches; without its radius it swells from its axis.
  void add_lobe(BodyId body, std::vector<Round>& rounds) {
    for (const BodyPoint& point : points(body)) {
      const CouplingTopology* coupling =
          point.coupling ? &topology_.coupling(*point.coupling) : nullptr;
      if (coupling == nullptr || coupling->tail != body ||
          kind_of(coupling->type).planar_symbol != PlanarSymbol::contact) {
        continue;
      }
      const PixelPoint touch = canvas_.view().at(point.at);
      std::erase_if(rounds, [&](const Round& r) { return length_of(r.centre - touch) < 0.5; });
      std::optional<double> radius = contact_radius(*point.coupling, 0);
      if (!radius) {
        radius = rounds.empty() ? kHalfBar : 0.45 * length_of(rounds.front().centre - touch);
        for (Round& round : rounds) {
          round.radius = std::max(round.radius, *radius);
        }
      }
      rounds.push_back({.centre = touch - *radius * normal(*coupling), .radius = *radius});
    }
  }

  void draw_wrap(const CableArc& arc) {
    const LinkageView& view = canvas_.view();
    svg_.polyline(arc_between(view.at(arc.centre),
                              view.at(arc.from),
                              view.at(arc.to),
                              arc.is_positive == (arc.axis.z() > 0.0)),
                  {.stroke = Ink::brown, .width = 2.2});
  }

  // Beside the middle of a link, or the rim of a wheel.
  void name_body(BodyId body) {
    const std::vector<PixelPoint> reached = places(body);
    const std::string& name = topology_.body(body).name;
    if (reached.size() < 2) {
      name_wheel_or_slider(body, reached);
      return;
    }
    PixelPoint middle = {.x = 0.0, .y = 0.0};
    for (const PixelPoint& point : reached) {
      middle = middle + (1.0 / static_cast<double>(reached.size())) * point;
    }
    canvas_.name(name, middle, kHalfBar + 4.0, body_ink(body));
  }

  void name_wheel_or_slider(BodyId body, const std::vector<PixelPoint>& points) {
    const std::string& name = topology_.body(body).name;
    for (const Wheel& wheel : parts_.wheels) {
      if (wheel.body == body) {
        const double radius = wheel.radius * canvas_.view().scale;
        const double depth = wheel.kind == WheelKind::ring ? kRingDepth : 0.0;
        std::vector<PixelPoint> rim;
        for (const double eighths : {1.0, 3.0, 5.0, 7.0, 0.0, 4.0, 2.0, 6.0}) {
          const double angle = eighths * std::numbers::pi / 4;
          rim.push_back(canvas_.view().at(wheel.centre) +
                        (radius + depth) * PixelPoint{.x = std::cos(angle), .y = -std::sin(angle)});
        }
        canvas_.name(name, std::move(rim), 5.0, body_ink(body));
        return;
      }
    }
    if (!points.empty()) {
      canvas_.name(name, points.front(), 19.0, body_ink(body));
    }
  }

  // Below a place where anything stands on it, or beside it.
  void name_ground() {
    std::vector<PixelPoint> anchors;
    for (const BodyPoint& point : points(BodyId{0})) {
      if (point.coupling) {
        add_feet(canvas_.view().at(point.at), anchors);
      }
    }
    if (!anchors.empty()) {
      canvas_.name(topology_.body(BodyId{0}).name, std::move(anchors), 3.0, Ink::soft);
    }
  }
};

void draw_stretched_at(const Analysis& analysis,
                       const LinkageOptions& options,
                       const LinkageParts& parts,
                       LinkageCanvas& canvas) {
  PlanarDrawing(analysis, options, parts, canvas).draw_stretched();
}

}  // namespace

void draw_planar(const Analysis& analysis,
                 const LinkageOptions& options,
                 const LinkageParts& parts,
                 LinkageCanvas& canvas) {
  PlanarDrawing(analysis, options, parts, canvas).draw();
}

void draw_planar_bodies(const Analysis& analysis,
                        const LinkageOptions& options,
                        const LinkageParts& parts,
                        LinkageCanvas& canvas) {
  PlanarDrawing drawing(analysis, options, parts, canvas);
  drawing.draw_bodies();
  drawing.draw_stretched();
  draw_planar_couplings(analysis, options, parts, canvas);
}

}  // namespace kinestat
