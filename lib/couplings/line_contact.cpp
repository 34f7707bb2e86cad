#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfLineContact = std::to_array<KindKey>({
    {CouplingKey::at, kPointOfContact},
    {CouplingKey::normal},
    {CouplingKey::line},
    {CouplingKey::radii},
});

constexpr auto kFreedomsOfLineContact = std::to_array<Carried>({kWithContact});

// Named along world axes only if both directions are, as numbers and letters would not mix.
constexpr auto write_line_contact = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                                     CatalogueRow<Scalar>& row) {
  const bool is_along_world = g.axis.keyword != 0 && g.second.keyword != 0;
  const auto named = [&](AxisOf<Scalar> axis) {
    axis.keyword = is_along_world ? axis.keyword : '\0';
    return axis;
  };
  const AxisOf<Scalar> normal = named(g.axis);
  const AxisOf<Scalar> line = named(g.second);
  const AxisOf<Scalar> across = third_of<Scalar>(normal, line);
  row.turn_along(line, g.at);
  row.turn_along(normal, g.at);
  row.slide_along(line);
  row.slide_along(across);
  row.bear_force_along(normal, g.at);
  row.bear_couple(name_along('T', across), across.direction);
};

// A cylinder on a plane.
void law_of_line_contact(LawWriter& law) {
  const bool is_flat =
      law.drawn().tail_shape && law.drawn().head_shape &&
      (law.drawn().tail_shape->curvature == 0.0) != (law.drawn().head_shape->curvature == 0.0);
  if (!is_flat) {
    law.set_kind(LawKind::unknown);
    return;
  }
  law.touching();
  const Vec3 line = law.geometry().second.direction;
  const bool is_tail_flat = law.drawn().tail_shape->curvature == 0.0;
  law.keep_angle(is_tail_flat ? law.axis() : line, is_tail_flat ? line : law.axis());
}

std::vector<CouplingUpgrade> upgrades_of_line_contact(std::span<const Twist> freedoms,
                                                      const Vec3& point) {
  return {{.to = CouplingType::point_contact, .added = {unit_rotation(freedoms[3].linear, point)}}};
}

constinit const KindMechanics kMechanicsOfLineContact = {
    .screws = screws_by(write_line_contact),
    .law = law_of_line_contact,
    .carried = {.freedoms = kFreedomsOfLineContact,
                .forces = kWithContact,
                .couples = kWithContact,
                .place = Follows::contact},
    .upgrades = upgrades_of_line_contact,
};

}  // namespace

constinit const CouplingKind kLineContact = {
    .type = CouplingType::line_contact,
    .word = "line_contact",
    .meaning = "two surfaces touch along a line, in space: 4 freedoms; needs at, normal, line",
    .example = "{type: line_contact, bodies: [frame, roller], at: [0, 0, 0], normal: z, line: x}",
    .keys = kKeysOfLineContact,
    .mechanics = &kMechanicsOfLineContact,
    .friction = FrictionKind::sliding,
    .is_in_plane = false,
    .only_pushes = true,
    .space_symbol = SpaceSymbol::touching_plate,
};

}  // namespace kinestat
