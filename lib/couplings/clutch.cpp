#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfClutches = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis},
    {CouplingKey::one_way},
});

constinit const KindMechanics kMechanicsOfClutch = {
    .screws = screws_by([](const auto& g, auto& row) { row.turn_along(g.axis, g.at); }),
    .law = [](LawWriter& law) { law.hinge(); },
};

}  // namespace

constinit const CouplingKind kClutch = {
    .type = CouplingType::clutch,
    .word = "clutch",
    .meaning =
        "joins two turning bodies when engaged: 1 freedom; an actuator of its own name; needs at, "
        "in space axis",
    .example = "{type: clutch, bodies: [shaft, drum], at: [0, 0]}",
    .keys = kKeysOfClutches,
    .mechanics = &kMechanicsOfClutch,
    .friction = FrictionKind::drag,
    .is_hinge = true,
    .space_symbol = SpaceSymbol::hinge,
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
    .mechanics = &kMechanicsOfClutch,
    .friction = FrictionKind::drag,
    .is_hinge = true,
    .space_symbol = SpaceSymbol::hinge,
    .engages = true,
};

}  // namespace kinestat
