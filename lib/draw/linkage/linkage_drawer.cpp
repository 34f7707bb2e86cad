#include "draw/linkage/linkage_drawer.hpp"

#include <algorithm>

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

void LinkageDrawer::add_place(PixelPoint place, std::vector<PixelPoint>& places) {
  constexpr double kSame = 0.5;  // [px]
  if (std::ranges::none_of(places, [&](PixelPoint q) { return length_of(place - q) < kSame; })) {
    places.push_back(place);
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

void LinkageDrawer::keep_off_bar(const std::vector<PixelPoint>& places, double half) {
  for (std::size_t i = 1; i < places.size(); ++i) {
    const PixelPoint side = half * left_of(unit_of(places[i] - places[i - 1]));
    canvas_.placer().keep_off(places[i - 1] + side, places[i] + side);
    canvas_.placer().keep_off(places[i - 1] - side, places[i] - side);
  }
}

}  // namespace kinestat
