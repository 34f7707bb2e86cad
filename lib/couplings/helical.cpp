#include <array>

#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfHelical = std::to_array<std::string_view>({"screw"});

constexpr auto kKeysOfHelical = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis, kAxisOfTurningAndSliding},
    {CouplingKey::pitch},
    {CouplingKey::lead},
});

}  // namespace

constinit const CouplingKind kHelical = {
    .type = CouplingType::helical,
    .word = "helical",
    .meaning = "screw and nut, in space: 1 freedom; needs at, axis, and pitch or lead",
    .example = "{type: helical, bodies: [frame, nut], at: [0, 0, 0], axis: z, lead: 5 mm}",
    .others = kNamesOfHelical,
    .keys = kKeysOfHelical,
    .friction = FrictionKind::thread,
    .has_friction_law = true,
    .is_in_plane = false,
};

}  // namespace kinestat
