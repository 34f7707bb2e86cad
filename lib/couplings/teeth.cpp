#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/internal/listed_screw.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfGear = std::to_array<std::string_view>({"spur_gear", "gears", "mesh"});

constexpr auto kKeysOfGear = std::to_array<KindKey>({
    {CouplingKey::at,
     "The pitch point in the drawn position: [x, y] in the plane, [x, y, z] in space. Where "
     "'gears' places both bodies, one number gives its position along the axis."},
    {CouplingKey::turning_axis,
     "The direction of the gears' axes: x, y, z, -x, -y, -z or a vector [ax, ay, az]. In the plane "
     "it is z, which need not be written."},
    {CouplingKey::tangent},
    {CouplingKey::pressure_angle},
    {CouplingKey::helix_angle},
    {CouplingKey::internal},
    {CouplingKey::contact},
    {CouplingKey::line_of_action,
     "The direction of the force of the tail on the head, instead of tangent and pressure angle."},
    {CouplingKey::flank},
});

// Teeth: rolling, or the relative screw that is given; their contact is a point contact.
constexpr auto write_teeth = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                              CatalogueRow<Scalar>& row) {
  if (g.is_contact) {
    row.turn_freely(g.at);
    row.slide_across({.direction = g.line_of_action, .keyword = 0});
  } else if (g.relative) {
    add_freedom<Scalar>(*g.relative, row);
  } else {
    row.turn_along(g.axis, g.at);
  }
  row.bear_force("Rc", g.line_of_action, g.at);
};

constexpr auto kFreedomsOfTeeth = std::to_array<Carried>({kWithCarrier});

constinit const KindMechanics kMechanicsOfTeeth = {
    .screws = screws_by(write_teeth),
    .law = [](LawWriter& law) { law.set_kind(LawKind::rolling); },
    .carried = {.freedoms = kFreedomsOfTeeth,
                .forces = kWithCarrier,
                .couples = kWithCarrier,
                .place = Follows::carrier},
};

constexpr auto kKeysOfTeeth = std::to_array<KindKey>({
    {CouplingKey::at, kPointOfContact},
    {CouplingKey::turning_axis},
    {CouplingKey::line_of_action},
    {CouplingKey::screw},
    {CouplingKey::flank},
});

constexpr auto kNamesOfBevelGear = std::to_array<std::string_view>({"bevel"});

constexpr auto kNamesOfWorm = std::to_array<std::string_view>({"worm_gear"});

}  // namespace

constinit const CouplingKind kGear = {
    .type = CouplingType::gear,
    .word = "gear",
    .meaning =
        "two gears in mesh, rolling about the pitch point: 1 freedom; needs at, in space axis, and "
        "tangent with pressure_angle or line_of_action",
    .example =
        "{type: gear, bodies: [sun, planet], at: [0, 0], tangent: x, pressure_angle: 20 deg}",
    .others = kNamesOfGear,
    .keys = kKeysOfGear,
    .mechanics = &kMechanicsOfTeeth,
    .friction = FrictionKind::sliding,
    .teeth = Teeth::of_wheels,
};

constinit const CouplingKind kBevelGear = {
    .type = CouplingType::bevel_gear,
    .word = "bevel_gear",
    .meaning =
        "two bevel gears in mesh, in space: 1 freedom; needs at, axis or screw, and line_of_action",
    .example =
        "{type: bevel_gear, bodies: [pinion, crown], at: [0, 0, 0], axis: [0, 1, 1], "
        "line_of_action: x}",
    .others = kNamesOfBevelGear,
    .keys = kKeysOfTeeth,
    .mechanics = &kMechanicsOfTeeth,
    .is_in_plane = false,
    .teeth = Teeth::of_wheels,
};

constinit const CouplingKind kWorm = {
    .type = CouplingType::worm,
    .word = "worm",
    .meaning = "worm and wheel, in space: 1 freedom; needs at, axis or screw, and line_of_action",
    .example =
        "{type: worm, bodies: [worm, wheel], at: [0, 0, 0], screw: {rotation: z, at: [0, 0, 0], "
        "pitch: 2 mm}, line_of_action: [0.1, 0.9, 0.4]}",
    .others = kNamesOfWorm,
    .keys = kKeysOfTeeth,
    .mechanics = &kMechanicsOfTeeth,
    .friction = FrictionKind::sliding,
    .is_in_plane = false,
    .teeth = Teeth::of_any,
};

constinit const CouplingKind kRack = {
    .type = CouplingType::rack,
    .word = "rack",
    .meaning = "rack and pinion: 1 freedom; needs at, line_of_action, and in space axis or screw",
    .example = "{type: rack, bodies: [pinion, rack], at: [0, 0], line_of_action: x}",
    .keys = kKeysOfTeeth,
    .mechanics = &kMechanicsOfTeeth,
    .teeth = Teeth::of_any,
    .planar_symbol = PlanarSymbol::rack,
};

}  // namespace kinestat
