#include <array>

#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfClutches = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis},
    {CouplingKey::one_way},
});

}  // namespace

constinit const CouplingKind kClutch = {
    .type = CouplingType::clutch,
    .word = "clutch",
    .meaning =
        "joins two turning bodies when engaged: 1 freedom; an actuator of its own name; needs at, "
        "in space axis",
    .example = "{type: clutch, bodies: [shaft, drum], at: [0, 0]}",
    .keys = kKeysOfClutches,
    .engages = true,
};

constinit const CouplingKind kBrake = {
    .type = CouplingType::brake,
    .word = "brake",
    .meaning =
        "holds a body when engaged: 1 freedom; an actuator of its own name; needs at, in space "
        "axis",
    .example = "{type: brake, bodies: [frame, ring], at: [0, 0]}",
    .keys = kKeysOfClutches,
    .engages = true,
};

}  // namespace kinestat
