#include <array>

#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfPrismatic = std::to_array<std::string_view>(
    {"slider", "slide", "translation", "translational", "sliding", "p"});

constexpr auto kKeysOfPrismatic = std::to_array<KindKey>({
    {CouplingKey::at, kPointForDrawings},
    {CouplingKey::sliding_axis},
});

}  // namespace

constinit const CouplingKind kPrismatic = {
    .type = CouplingType::prismatic,
    .word = "prismatic",
    .meaning = "slides along an axis: 1 freedom; needs axis",
    .example = "{type: prismatic, bodies: [frame, slider], at: [0, 0], axis: x}",
    .others = kNamesOfPrismatic,
    .keys = kKeysOfPrismatic,
    .friction = FrictionKind::guide,
    .has_friction_law = true,
    .needs_place = false,
};

}  // namespace kinestat
