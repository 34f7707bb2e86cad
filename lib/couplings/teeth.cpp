#include <array>

#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfTeeth = std::to_array<KindKey>({
    {CouplingKey::at, kPointOfContact},
    {CouplingKey::turning_axis},
    {CouplingKey::line_of_action},
    {CouplingKey::screw},
});

constexpr auto kNamesOfBevelGear = std::to_array<std::string_view>({"bevel"});

constexpr auto kNamesOfWorm = std::to_array<std::string_view>({"worm_gear"});

}  // namespace

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
    .friction = FrictionKind::sliding,
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
    .friction = FrictionKind::sliding,
    .has_friction_law = true,
    .is_in_plane = false,
    .teeth = Teeth::of_any,
};

constinit const CouplingKind kRack = {
    .type = CouplingType::rack,
    .word = "rack",
    .meaning = "rack and pinion: 1 freedom; needs at, line_of_action, and in space axis or screw",
    .example = "{type: rack, bodies: [pinion, rack], at: [0, 0], line_of_action: x}",
    .keys = kKeysOfTeeth,
    .friction = FrictionKind::sliding,
    .teeth = Teeth::of_any,
};

}  // namespace kinestat
