#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfContacts = std::to_array<KindKey>({
    {CouplingKey::at, kPointOfContact},
    {CouplingKey::normal},
    {CouplingKey::radii},
});

constexpr auto kFreedomsOfContact = std::to_array<Carried>({kWithContact});

constexpr auto write_point_contact = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                                      CatalogueRow<Scalar>& row) {
  row.turn_freely(g.at);
  row.slide_across(g.axis);
  row.bear_force_along(g.axis, g.at);
};

constinit const KindMechanics kMechanicsOfContact = {
    .screws = screws_by(write_point_contact),
    .law = [](LawWriter& law) { law.touching(); },
    .carried = {.freedoms = kFreedomsOfContact,
                .turns = kAtContact,
                .forces = kWithContact,
                .couples = kWithContact,
                .place = Follows::contact},
};

}  // namespace

constinit const CouplingKind kPointContact = {
    .type = CouplingType::point_contact,
    .word = "point_contact",
    .meaning = "two surfaces touch in a point: 5 freedoms (2 in the plane); needs at, normal",
    .example = "{type: point_contact, bodies: [frame, ball], at: [0, 0, 0], normal: z}",
    .keys = kKeysOfContacts,
    .mechanics = &kMechanicsOfContact,
    .friction = FrictionKind::sliding,
    .frees_more_in_space = true,
    .only_pushes = true,
    .planar_symbol = PlanarSymbol::contact,
    .space_symbol = SpaceSymbol::touching_plate,
};

constinit const CouplingKind kCam = {
    .type = CouplingType::cam,
    .word = "cam",
    .meaning =
        "a cam and its follower, a point contact: 5 freedoms (2 in the plane); needs at, normal",
    .example = "{type: cam, bodies: [cam, follower], at: [0, 31], normal: y, radii: [31, flat]}",
    .keys = kKeysOfContacts,
    .mechanics = &kMechanicsOfContact,
    .friction = FrictionKind::sliding,
    .frees_more_in_space = true,
    .only_pushes = true,
    .planar_symbol = PlanarSymbol::contact,
    .space_symbol = SpaceSymbol::touching_plate,
};

}  // namespace kinestat
