#include <array>

#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfRevolute = std::to_array<std::string_view>(
    {"pin", "hinge", "pivot", "revolution", "rotation", "rotational", "r"});

constexpr auto kKeysOfRevolute = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis},
});

}  // namespace

constinit const CouplingKind kRevolute = {
    .type = CouplingType::revolute,
    .word = "revolute",
    .meaning = "turns about an axis: 1 freedom; needs at, and in space axis",
    .example = "{type: revolute, bodies: [frame, crank], at: [0, 0]}",
    .others = kNamesOfRevolute,
    .keys = kKeysOfRevolute,
    .friction = FrictionKind::journal,
    .has_friction_law = true,
};

}  // namespace kinestat
