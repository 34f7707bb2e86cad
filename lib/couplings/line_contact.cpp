#include <array>

#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfLineContact = std::to_array<KindKey>({
    {CouplingKey::at, kPointOfContact},
    {CouplingKey::normal},
    {CouplingKey::line},
    {CouplingKey::radii},
});

}  // namespace

constinit const CouplingKind kLineContact = {
    .type = CouplingType::line_contact,
    .word = "line_contact",
    .meaning = "two surfaces touch along a line, in space: 4 freedoms; needs at, normal, line",
    .example = "{type: line_contact, bodies: [frame, roller], at: [0, 0, 0], normal: z, line: x}",
    .keys = kKeysOfLineContact,
    .friction = FrictionKind::sliding,
    .has_friction_law = true,
    .is_in_plane = false,
    .only_pushes = true,
};

}  // namespace kinestat
