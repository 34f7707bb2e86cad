#include "draw/linkage/spatial_symbols.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "couplings/kinds.hpp"
#include "draw/symbols.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

class SymbolWriter {
 public:
  SymbolWriter(Svg& svg, const LinkageView& view, const SpatialSymbol& symbol)
      : svg_(svg), view_(view), symbol_(symbol), p_(view.at(symbol.at)) {}

  void write() {
    switch (kind_of(symbol_.type).space_symbol) {
      case SpaceSymbol::hinge:
        draw_axis_line(24.0);
        draw_cylinder(8.0, 5.5);
        break;
      case SpaceSymbol::sleeve:
        draw_axis_line(32.0);
        draw_cylinder(13.0, 5.5);
        break;
      case SpaceSymbol::box:
        draw_axis_line(32.0);
        draw_box(13.0, 6.0);
        break;
      case SpaceSymbol::cross:
        draw_cross();
        break;
      case SpaceSymbol::ball:
        svg_.circle(p_, 7.0, {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.5});
        svg_.circle(p_, 3.2, {.stroke = Ink::ink, .fill = Ink::ink});
        break;
      case SpaceSymbol::plate:
        draw_plate(planar_normal());
        break;
      case SpaceSymbol::touching_plate:
        draw_plate(symbol_.normal);
        svg_.circle(p_, 3.0, {.stroke = Ink::none, .fill = Ink::ink});
        break;
      case SpaceSymbol::square:
        svg_.rectangle(box_of_circle(p_, 4.0),
                       {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.5});
        break;
    }
  }

 private:
  Vec3 axis() const { return symbol_.axes.empty() ? Vec3::UnitZ().eval() : symbol_.axes.front(); }

  // Of the axis that turns among the three of a planar coupling.
  Vec3 planar_normal() const {
    return symbol_.axes.size() > 2 ? symbol_.axes[1].cross(symbol_.axes[2]).normalized() : axis();
  }

  // A vector of that many pixels on paper if it lies in the picture.
  PixelPoint seen(const Vec3& direction, double pixels) const {
    return view_.along((pixels / view_.scale) * direction);
  }

  void draw_axis_line(double half) {
    const PixelPoint along = seen(axis(), half);
    svg_.line(p_ - along, p_ + along, {.stroke = Ink::soft, .width = 0.9, .dash = "7 2 1.5 2"});
  }

  // The end that looks at the reader, as a sign along the axis.
  double near_end() const { return view_.right.cross(view_.up).dot(axis()) >= 0.0 ? 1.0 : -1.0; }

  std::vector<PixelPoint> end_circle(double half, double radius) const {
    return circle_in_space(view_, symbol_.at + (half / view_.scale) * axis(), axis(), radius);
  }

  void draw_cylinder(double half, double radius) {
    std::vector<PixelPoint> points = end_circle(half, radius);
    const std::vector<PixelPoint> other = end_circle(-half, radius);
    points.insert(points.end(), other.begin(), other.end());
    const Paint paint = {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.4};
    svg_.polygon(convex_hull(points), paint);
    svg_.polygon(end_circle(near_end() * half, radius), paint);
    if (symbol_.type == helical) {
      const PixelPoint along = seen(axis(), half);
      const PixelPoint across = radius * left_of(unit_of(along));
      for (const double s : {-0.6, 0.0, 0.6}) {
        svg_.line(p_ + s * along - across, p_ + (s + 0.3) * along + across, {.stroke = Ink::ink});
      }
    }
  }

  void draw_box(double half, double width) {
    const Vec3 one = axis().unitOrthogonal();
    const Vec3 other = axis().cross(one);
    std::vector<PixelPoint> all;
    std::vector<PixelPoint> near;
    for (const double end : {-1.0, 1.0}) {
      for (const auto& [a, b] :
           {std::pair(1, 1), std::pair(-1, 1), std::pair(-1, -1), std::pair(1, -1)}) {
        const PixelPoint corner =
            p_ + seen(axis(), end * half) + seen(one, a * width) + seen(other, b * width);
        all.push_back(corner);
        if (end == near_end()) {
          near.push_back(corner);
        }
      }
    }
    svg_.polygon(convex_hull(all), {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.4});
    svg_.polygon(near, {.stroke = Ink::ink, .fill = symbol_.ink, .width = 1.2, .opacity = 0.3});
  }

  void draw_cross() {
    svg_.circle(p_, 8.0, {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.2});
    for (const Vec3& one : symbol_.axes) {
      const PixelPoint along = seen(one, 15.0);
      svg_.line(p_ - along, p_ + along, {.stroke = Ink::ink, .width = 2.2, .round_ends = true});
    }
  }

  void draw_plate(const Vec3& normal) {
    const Vec3 one = normal.unitOrthogonal();
    const Vec3 other = normal.cross(one);
    std::vector<PixelPoint> corners;
    for (const auto& [a, b] :
         {std::pair(1, 1), std::pair(-1, 1), std::pair(-1, -1), std::pair(1, -1)}) {
      corners.push_back(p_ + seen(one, a * 13.0) + seen(other, b * 13.0));
    }
    svg_.polygon(corners, {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.3, .opacity = 0.8});
    svg_.line(p_, p_ + seen(normal, 18.0), {.stroke = Ink::soft, .width = 1.2});
  }

  Svg& svg_;
  const LinkageView& view_;
  const SpatialSymbol& symbol_;
  PixelPoint p_;
};

}  // namespace

std::vector<PixelPoint> circle_in_space(const LinkageView& view,
                                        const Vec3& centre,
                                        const Vec3& axis,
                                        double radius) {
  constexpr int kSidesOfCircle = 40;
  const Vec3 one = axis.unitOrthogonal();
  const Vec3 other = axis.cross(one);
  std::vector<PixelPoint> points;
  for (int i = 0; i < kSidesOfCircle; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSidesOfCircle;
    const Vec3 arm = std::cos(angle) * one + std::sin(angle) * other;
    points.push_back(view.at(centre + (radius / view.scale) * arm));
  }
  return points;
}

void draw_spatial_coupling(Svg& svg, const LinkageView& view, const SpatialSymbol& symbol) {
  SymbolWriter(svg, view, symbol).write();
}

}  // namespace kinestat
