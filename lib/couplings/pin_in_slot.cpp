#include <array>

#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfPinInSlot = std::to_array<std::string_view>({"pin_slot"});

constexpr auto kKeysOfPinInSlot = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::slot},
});

}  // namespace

constinit const CouplingKind kPinInSlot = {
    .type = CouplingType::pin_in_slot,
    .word = "pin_in_slot",
    .meaning = "a pin in a straight slot, in the plane: 2 freedoms; needs at, slot",
    .example = "{type: pin_in_slot, bodies: [crank, link], at: [0, 0], slot: x}",
    .others = kNamesOfPinInSlot,
    .keys = kKeysOfPinInSlot,
    .friction = FrictionKind::sliding,
    .has_friction_law = true,
    .is_in_space = false,
};

}  // namespace kinestat
