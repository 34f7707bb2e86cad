#include "draw/linkage/linkage_drawer.hpp"

#include <algorithm>
#include <array>

#include "draw/linkage/spring_symbols.hpp"
#include "draw/symbols.hpp"

namespace kinestat {

std::vector<BodyId> LinkageDrawer::moving_bodies() const {
  std::vector<BodyId> bodies;
  for (int b = 1; b < topology_.body_count(); ++b) {
    if (!is_virtual(BodyId{b})) {
      bodies.push_back(BodyId{b});
    }
  }
  return bodies;
}

void LinkageDrawer::place_cables() {
  for (const CableLine& span : parts_.spans) {
    canvas_.set_place(span.coupling, (span.from + span.to) / 2);
  }
}

void LinkageDrawer::draw_springs() {
  for (const SpringLine& line : parts_.springs) {
    const Spring& spring = analysis_.mechanism.springs[line.spring];
    const std::array<Attribute, 1> marks = {{{"data-spring", spring.name}}};
    svg_.open_group(spring.name, marks);
    const PixelPoint from = canvas_.view().at(line.from);
    const PixelPoint to = canvas_.view().at(line.to);
    const double scale = canvas_.view().scale;
    draw_spring(
        svg_, spring, {.from = from, .to = to, .drawn = scale * line.drawn, .scale = scale});
    svg_.close_group();
  }
}

void LinkageDrawer::draw_spirals() {
  for (const Spring& spring : analysis_.mechanism.springs) {
    if (const std::optional<CouplingId> hinge = hinge_of(spring)) {
      canvas_.open_body(carrier(topology_.coupling(*hinge)));
      draw_spiral(svg_, canvas_.view().at(canvas_.place(*hinge)));
      svg_.close_group();
    }
  }
}

void LinkageDrawer::name_springs() {
  for (const SpringLine& line : parts_.springs) {
    const Vec3 middle = (line.from + line.to) / 2;
    canvas_.name(analysis_.mechanism.springs[line.spring].name,
                 canvas_.view().at(middle),
                 kSpringHalf + 4.0,
                 Ink::ink);
  }
  for (const Spring& spring : analysis_.mechanism.springs) {
    if (const std::optional<CouplingId> hinge = hinge_of(spring)) {
      canvas_.name(
          spring.name, canvas_.view().at(canvas_.place(*hinge)), kSpiralRadius + 3.0, Ink::ink);
    }
  }
}

std::optional<CouplingId> LinkageDrawer::hinge_of(const Spring& spring) const {
  if (!spring.is_of_freedom()) {
    return std::nullopt;
  }
  const FreedomLabel& freedom = topology_.freedoms[static_cast<std::size_t>(spring.freedom)];
  return freedom.is_rotation ? std::optional(freedom.coupling) : std::nullopt;
}

void LinkageDrawer::add_place(PixelPoint place, std::vector<PixelPoint>& places) {
  constexpr double kSame = 0.5;  // [px]
  if (std::ranges::none_of(places, [&](PixelPoint q) { return length_of(place - q) < kSame; })) {
    places.push_back(place);
  }
}

void LinkageDrawer::add_feet(PixelPoint place, std::vector<PixelPoint>& places) {
  constexpr double kBelow = 26.0;  // the symbol of the ground [px]
  constexpr double kBeside = 17.0;
  for (const double x : {0.0, -kBeside, kBeside}) {
    add_place(place + PixelPoint{.x = x, .y = x == 0.0 ? kBelow : kBeside}, places);
  }
}

void LinkageDrawer::add_traced(BodyId body, std::vector<PixelPoint>& places) const {
  for (const TracedPath& path : options_.paths) {
    if (path.body == body) {
      add_place(canvas_.view().at(path.drawn), places);
    }
  }
}

void LinkageDrawer::draw_traced(BodyId body) {
  for (std::size_t i = 0; i < options_.paths.size(); ++i) {
    const TracedPath& path = options_.paths[i];
    if (path.body == body) {
      svg_.circle(canvas_.view().at(path.drawn),
                  3.2,
                  {.stroke = Ink::paper, .fill = path_ink(i), .width = 0.8});
    }
  }
}

}  // namespace kinestat
