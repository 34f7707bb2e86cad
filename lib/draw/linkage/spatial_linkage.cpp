#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/axis_name.hpp"
#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "draw/linkage/linkage_drawer.hpp"
#include "draw/linkage/linkage_frames.hpp"
#include "draw/linkage/spatial_symbols.hpp"
#include "draw/symbols.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

constexpr double kHalfRod = 4.0;  // [px]
constexpr double kDegree = std::numbers::pi / 180;

// Azimuth and elevation of the eye [degrees], the usual one first.
struct Eye {
  double azimuth = 0.0;
  double elevation = 0.0;
};

LinkageView view_from(Eye eye) {
  const double a = eye.azimuth * kDegree;
  const double e = eye.elevation * kDegree;
  const Vec3 out(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
  LinkageView view;
  view.right = Vec3(-std::sin(a), std::cos(a), 0.0);
  view.up = out.cross(view.right);
  return view;
}

// How far apart the two couplings are that come closest to each other on the picture, of those
// that are apart in space.
double least_distance(const LinkageView& view, const std::vector<Vec3>& places, double length) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((places[i] - places[j]).norm() > kDrawnTogether * length) {
        const PixelPoint between = view.at(places[i]) - view.at(places[j]);
        least = std::min(least, length_of(between));
      }
    }
  }
  return least;
}

class SpatialDrawing : private LinkageDrawer {
 public:
  using LinkageDrawer::LinkageDrawer;

  void draw() {
    canvas_.draw_paths();
    if (!options_.cycle) {
      canvas_.open_layer("still");
      draw_mechanism();
      svg_.close_group();
    }
    draw_linkage_frames(analysis_, options_, canvas_, draw_spatial_bodies);
    if (options_.shows_names) {
      add_names();
    }
    canvas_.draw_arrows();
    canvas_.draw_names();
    canvas_.draw_legend();
    draw_axes();
  }

  void draw_mechanism() {
    place_cables();
    separate_sliders();
    canvas_.open_body(BodyId{0});
    draw_ground();
    svg_.close_group();
    for (const BodyId body : bodies_from_behind()) {
      canvas_.open_body(body);
      draw_body(body);
      draw_traced(body);
      svg_.close_group();
    }
    draw_cables();
    draw_springs();
    draw_spirals();
    for (const CouplingId id : couplings_from_behind()) {
      draw_coupling(id);
    }
  }

 private:
  void add_names() {
    canvas_.name_couplings();
    name_springs();
    for (int b = 0; b < topology_.body_count(); ++b) {
      name_body(BodyId{b});
    }
  }

  Vec3 out() const { return canvas_.view().right.cross(canvas_.view().up); }

  const Vec3& place(CouplingId id) const { return canvas_.place(id); }

  // What slides in the point of another coupling moves along its axis, towards the rest of its
  // head, so that both are seen.
  void separate_sliders() {
    constexpr double kAside = 34.0;  // [px]
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingTopology& coupling = topology_.coupling(CouplingId{e});
      const bool slides = coupling.type == prismatic || coupling.type == cylindrical;
      if (!slides || !is_shared_place(CouplingId{e})) {
        continue;
      }
      const Vec3 axis = axes_of(coupling).back();
      double ahead = 0.0;
      for (const BodyPoint& point : points(coupling.head)) {
        ahead += axis.dot(point.at - place(CouplingId{e}));
      }
      const double sense = ahead < 0.0 ? -1.0 : 1.0;
      canvas_.set_place(CouplingId{e},
                        place(CouplingId{e}) + sense * kAside / canvas_.view().scale * axis);
    }
  }

  bool is_shared_place(CouplingId id) const {
    for (int other = 0; other < topology_.coupling_count(); ++other) {
      const double apart = (place(CouplingId{other}) - place(id)).norm();
      if (other != id.value && apart <= kDrawnTogether * geometry_.length) {
        return true;
      }
    }
    return false;
  }

  double depth(BodyId body) const {
    double sum = 0.0;
    for (const BodyPoint& point : points(body)) {
      sum += out().dot(point.at) / static_cast<double>(points(body).size());
    }
    return sum;
  }

  std::vector<BodyId> bodies_from_behind() const {
    std::vector<BodyId> bodies = moving_bodies();
    std::ranges::stable_sort(bodies, [this](BodyId a, BodyId b) { return depth(a) < depth(b); });
    return bodies;
  }

  std::vector<CouplingId> couplings_from_behind() const {
    std::vector<CouplingId> couplings;
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      couplings.push_back(CouplingId{e});
    }
    std::ranges::stable_sort(couplings, [this](CouplingId a, CouplingId b) {
      return out().dot(place(a)) < out().dot(place(b));
    });
    return couplings;
  }

  // Each coupling of the ground stands on a piece of it.
  void draw_ground() {
    for (const BodyPoint& point : points(BodyId{0})) {
      const PixelPoint p = canvas_.view().at(point.at);
      const PixelPoint foot = p + PixelPoint{.x = 0.0, .y = 17.0};
      svg_.line(p, foot, {.stroke = Ink::ink, .width = 1.4});
      const PixelPoint half = {.x = 13.0, .y = 0.0};
      draw_fixed_line(svg_, foot - half, foot + half);
    }
  }

  std::vector<PixelPoint> places(BodyId body) const {
    std::vector<PixelPoint> result;
    for (const BodyPoint& point : points(body)) {
      const bool is_cable = point.coupling && topology_.coupling(*point.coupling).type == cable;
      const Vec3& at = point.coupling && !is_cable ? place(*point.coupling) : point.at;
      add_place(canvas_.view().at(at), result);
    }
    for (const Wheel& wheel : parts_.wheels) {
      if (wheel.body == body) {
        add_place(canvas_.view().at(wheel.centre), result);
      }
    }
    add_traced(body, result);
    return result;
  }

  void draw_body(BodyId body) {
    const Ink ink = body_ink(body);
    for (const Wheel& wheel : parts_.wheels) {
      if (wheel.body == body) {
        const double r = wheel.radius * canvas_.view().scale;
        const std::vector<PixelPoint> rim =
            circle_in_space(canvas_.view(), wheel.centre, wheel.axis, r);
        svg_.polygon(rim, {.stroke = ink, .fill = ink, .width = 1.3, .opacity = 0.1});
      }
    }
    const std::vector<PixelPoint> reached = places(body);
    if (reached.size() < 2) {
      return;
    }
    std::vector<Round> rounds;
    for (const PixelPoint& p : reached) {
      rounds.push_back({.centre = p, .radius = kHalfRod});
    }
    svg_.polygon(rounded_hull(rounds), {.stroke = ink, .fill = ink, .width = 1.4, .opacity = 0.16});
  }

  void draw_cables() {
    for (const CableLine& span : parts_.spans) {
      const PixelPoint from = canvas_.view().at(span.from);
      const PixelPoint to = canvas_.view().at(span.to);
      svg_.line(from, to, {.stroke = Ink::brown, .width = 2.2});
    }
  }

  std::vector<Vec3> axes_of(const CouplingTopology& coupling) const {
    std::vector<Vec3> axes;
    for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
      const auto i = static_cast<std::size_t>(f);
      const Twist& unit = geometry_.motions[i];
      axes.push_back(topology_.freedoms[i].is_rotation ? unit.angular : unit.linear);
    }
    return axes;
  }

  void draw_coupling(CouplingId id) {
    const CouplingTopology& coupling = topology_.coupling(id);
    if (is_hidden(coupling) || coupling.type == cable || coupling.type == gear) {
      return;
    }
    canvas_.open_body(carrier(coupling));
    Vec3 normal = Vec3::UnitZ();
    if (coupling.action_count > 0) {
      normal = geometry_.actions[static_cast<std::size_t>(coupling.first_action)].force;
    }
    draw_spatial_coupling(svg_,
                          canvas_.view(),
                          {.type = coupling.type,
                           .at = place(id),
                           .axes = axes_of(coupling),
                           .normal = normal,
                           .ink = body_ink(carrier(coupling))});
    svg_.close_group();
  }

  void name_body(BodyId body) {
    const std::vector<PixelPoint> reached = places(body);
    if (is_virtual(body) || reached.empty()) {
      return;
    }
    if (body.value == 0) {
      std::vector<PixelPoint> anchors;
      for (const PixelPoint& place : reached) {
        add_feet(place, anchors);
      }
      canvas_.name(topology_.body(body).name, std::move(anchors), 6.0, body_ink(body));
      return;
    }
    PixelPoint anchor = reached.front();
    if (reached.size() > 1) {
      anchor = 0.5 * (reached[0] + reached[1]);
    }
    for (const Wheel& wheel : parts_.wheels) {
      if (wheel.body == body && reached.size() < 2) {
        anchor = circle_in_space(
            canvas_.view(), wheel.centre, wheel.axis, wheel.radius * canvas_.view().scale)[4];
      }
    }
    canvas_.name(topology_.body(body).name, anchor, 8.0, body_ink(body));
  }

  // The world axes, at the right of the legend.
  void draw_axes() {
    const PixelPoint corner = {.x = svg_.bounds().right + 22.0, .y = svg_.bounds().bottom - 8.0};
    const TextStyle style = {.ink = Ink::soft, .size = 11.0, .anchor = Anchor::middle};
    for (int i = 0; i < 3; ++i) {
      const double to_pixels = 30.0 / canvas_.view().scale;
      const PixelPoint along = canvas_.view().along(to_pixels * Vec3::Unit(i));
      if (length_of(along) < 3.0) {
        continue;
      }
      svg_.arrow(corner, corner + along, {.stroke = Ink::soft, .width = 1.2}, 6.0);
      const PixelPoint text = corner + along + 8.0 * unit_of(along);
      svg_.text(
          text + PixelPoint{.x = 0.0, .y = 4.0}, kAxisNames[static_cast<std::size_t>(i)], style);
    }
  }
};

}  // namespace

LinkageView best_view(const Analysis& analysis, const std::vector<Vec3>& points) {
  constexpr Eye kEyes[] = {{-60, 24},
                           {-50, 30},
                           {-70, 20},
                           {-30, 24},
                           {-40, 35},
                           {30, 24},
                           {40, 30},
                           {50, 20},
                           {60, 24},
                           {-15, 24},
                           {-75, 35},
                           {15, 30}};
  // Any further apart than that is as good [px].
  constexpr double kFarEnough = 34.0;
  LinkageView best;
  double most = -1.0;
  for (const Eye& eye : kEyes) {
    const LinkageView view = fit_view(view_from(eye), points);
    const Geometry& geometry = analysis.mechanism.geometry;
    const double least =
        std::min(kFarEnough, least_distance(view, geometry.points, geometry.length));
    if (least > most) {
      most = least;
      best = view;
    }
  }
  return best;
}

void draw_spatial(const Analysis& analysis,
                  const LinkageOptions& options,
                  const LinkageParts& parts,
                  LinkageCanvas& canvas) {
  SpatialDrawing(analysis, options, parts, canvas).draw();
}

void draw_spatial_bodies(const Analysis& analysis,
                         const LinkageOptions& options,
                         const LinkageParts& parts,
                         LinkageCanvas& canvas) {
  SpatialDrawing(analysis, options, parts, canvas).draw_mechanism();
}

}  // namespace kinestat
