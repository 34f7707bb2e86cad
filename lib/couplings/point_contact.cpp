#include <array>

#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfContacts = std::to_array<KindKey>({
    {CouplingKey::at, kPointOfContact},
    {CouplingKey::normal},
    {CouplingKey::radii},
});

}  // namespace

constinit const CouplingKind kPointContact = {
    .type = CouplingType::point_contact,
    .word = "point_contact",
    .meaning = "two surfaces touch in a point: 5 freedoms (2 in the plane); needs at, normal",
    .example = "{type: point_contact, bodies: [frame, ball], at: [0, 0, 0], normal: z}",
    .keys = kKeysOfContacts,
    .friction = FrictionKind::sliding,
    .has_friction_law = true,
    .only_pushes = true,
};

constinit const CouplingKind kCam = {
    .type = CouplingType::cam,
    .word = "cam",
    .meaning =
        "a cam and its follower, a point contact: 5 freedoms (2 in the plane); needs at, normal",
    .example = "{type: cam, bodies: [cam, follower], at: [0, 31], normal: y, radii: [31, flat]}",
    .keys = kKeysOfContacts,
    .friction = FrictionKind::sliding,
    .has_friction_law = true,
    .only_pushes = true,
};

}  // namespace kinestat
