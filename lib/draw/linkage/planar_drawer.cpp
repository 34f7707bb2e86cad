#include "draw/linkage/planar_drawer.hpp"

#include <algorithm>
#include <array>

#include "couplings/kinds.hpp"
#include "draw/symbols.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

class PlanarCouplings : private PlanarDrawer {
 public:
  using PlanarDrawer::PlanarDrawer;

  // Pins on top of blocks.
  void draw() {
    for (const bool is_block : {true, false}) {
      for (int e = 0; e < topology_.coupling_count(); ++e) {
        if ((topology_.coupling(CouplingId{e}).type == prismatic) == is_block) {
          draw_coupling(CouplingId{e});
        }
      }
    }
  }

 private:
  void draw_coupling(CouplingId id) {
    const CouplingTopology& coupling = topology_.coupling(id);
    if (is_hidden(coupling) || coupling.type == cable || joins_wheels(coupling.type)) {
      return;
    }
    canvas_.open_body(carrier(coupling));
    draw_symbol(id, coupling);
    svg_.close_group();
  }

  void draw_symbol(CouplingId id, const CouplingTopology& coupling) {
    const PixelPoint p = at(id);
    switch (kind_of(coupling.type).planar_symbol) {
      case PlanarSymbol::block: {
        const BodyId moving = carrier(coupling);
        if (has_rack(moving)) {
          break;
        }
        draw_block(
            svg_,
            p,
            sliding_direction(coupling),
            {.stroke = body_ink(moving), .fill = body_ink(moving), .width = 1.5, .opacity = 0.3});
        break;
      }
      case PlanarSymbol::slot:
        draw_slot(p, sliding_direction(coupling), coupling.tail);
        break;
      case PlanarSymbol::contact:
        draw_contact(svg_, p, normal(coupling));
        break;
      case PlanarSymbol::rack:
        draw_rack(p, coupling);
        break;
      case PlanarSymbol::bars:
        draw_bars(p, coupling);
        break;
      case PlanarSymbol::square:
        svg_.rectangle(box_of_circle(p, 4.0), {.stroke = Ink::ink, .fill = Ink::ink});
        break;
      case PlanarSymbol::pin:
        draw_pin(svg_, p);
        break;
    }
  }

  // Constraints given as lines are bars of which the file tells but the direction, towards the tail
  // where they pull.
  void draw_bars(PixelPoint p, const CouplingTopology& coupling) {
    constexpr double kLength = 46.0;
    for (int a = 0; a < coupling.action_count; ++a) {
      const Vec3& force =
          geometry_.actions[static_cast<std::size_t>(coupling.first_action + a)].force;
      const PixelPoint along = canvas_.view().along(force);
      if (length_of(along) > 0.0) {
        const PixelPoint end = p + kLength * unit_of(along);
        svg_.line(p, end, {.stroke = Ink::brown, .width = 2.0, .dash = "5 2"});
      }
    }
    draw_pin(svg_, p);
  }

  // The slot moves with the body of the group, its pin with the other.
  void draw_slot(PixelPoint p, PixelPoint along, BodyId pin_body) {
    const std::array<Round, 2> rounds = {{{.centre = p - (kSlotHalf - 4) * along, .radius = 4.5},
                                          {.centre = p + (kSlotHalf - 4) * along, .radius = 4.5}}};
    svg_.polygon(rounded_hull(rounds), {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.2});
    svg_.close_group();
    canvas_.open_body(pin_body);
    draw_pin(svg_, p, 3.6);
  }

  // A bar with strokes for its teeth, along the tangent of its pinion.
  void draw_rack(PixelPoint p, const CouplingTopology& coupling) {
    PixelPoint away = {.x = 0.0, .y = 1.0};
    BodyId rack_body = coupling.head;
    for (const Wheel& wheel : parts_.wheels) {
      if (wheel.body == coupling.tail || wheel.body == coupling.head) {
        away = unit_of(p - canvas_.view().at(wheel.centre));
        rack_body = wheel.body == coupling.tail ? coupling.head : coupling.tail;
      }
    }
    svg_.close_group();
    canvas_.open_body(rack_body);
    draw_rack_bar(svg_, p, away, body_ink(rack_body));
  }
};

}  // namespace

PixelPoint PlanarDrawer::sliding_direction(const CouplingTopology& coupling) const {
  for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
    const auto i = static_cast<std::size_t>(f);
    if (!topology_.freedoms[i].is_rotation) {
      return unit_of(canvas_.view().along(geometry_.motions[i].linear));
    }
  }
  return {.x = 1.0, .y = 0.0};
}

PixelPoint PlanarDrawer::normal(const CouplingTopology& coupling) const {
  return coupling.action_count == 0
             ? PixelPoint{.x = 0.0, .y = -1.0}
             : unit_of(canvas_.view().along(
                   geometry_.actions[static_cast<std::size_t>(coupling.first_action)].force));
}

bool PlanarDrawer::has_rack(BodyId body) const {
  const auto slides = [&](CouplingType type) {
    return std::ranges::any_of(topology_.couplings, [&](const CouplingTopology& coupling) {
      return coupling.type == type && (coupling.tail == body || coupling.head == body);
    });
  };
  return body.value != 0 && slides(rack) && slides(prismatic);
}

void draw_planar_couplings(const Analysis& analysis,
                           const LinkageOptions& options,
                           const LinkageParts& parts,
                           LinkageCanvas& canvas) {
  PlanarCouplings(analysis, options, parts, canvas).draw();
}

}  // namespace kinestat
