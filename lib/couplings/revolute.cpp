#include <array>

#include "couplings/internal/added_freedoms.hpp"
#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfRevolute = std::to_array<std::string_view>(
    {"pin", "hinge", "pivot", "revolution", "rotation", "rotational", "r"});

constexpr auto kKeysOfRevolute = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis},
});

constexpr auto write_revolute = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                                 CatalogueRow<Scalar>& row) {
  row.turn_along(g.axis, g.at);
  row.bear_all_forces(g.at);
  if (!row.is_planar()) {
    row.bear_couples_across(g.axis);
  }
};

std::vector<CouplingUpgrade> upgrades_of_revolute(std::span<const Twist> freedoms,
                                                  const Vec3& point) {
  const Vec3& axis = freedoms[0].angular;
  const Twist slide = unit_translation(axis);
  const auto [t1, t2] = readable_across(axis);
  const Twist turn1 = unit_rotation(t1, point);
  const Twist turn2 = unit_rotation(t2, point);
  return {{.to = CouplingType::cylindrical, .added = {slide}},
          {.to = CouplingType::universal, .added = {turn1}},
          {.to = CouplingType::universal, .added = {turn2}},
          {.to = CouplingType::spherical, .added = {turn1, turn2}},
          {.to = CouplingType::sphere_in_tube, .added = {turn1, turn2, slide}, .is_rare = true}};
}

constinit const KindMechanics kMechanicsOfRevolute = {
    .screws = screws_by(write_revolute),
    .law = [](LawWriter& law) { law.hinge(); },
    .carried = {.forces = kAtTail},
    .upgrades = upgrades_of_revolute,
};

}  // namespace

constinit const CouplingKind kRevolute = {
    .type = CouplingType::revolute,
    .word = "revolute",
    .meaning = "turns about an axis: 1 freedom; needs at, and in space axis",
    .example = "{type: revolute, bodies: [frame, crank], at: [0, 0]}",
    .others = kNamesOfRevolute,
    .keys = kKeysOfRevolute,
    .mechanics = &kMechanicsOfRevolute,
    .friction = FrictionKind::journal,
    .is_hinge = true,
    .is_bearing = true,
    .space_symbol = SpaceSymbol::hinge,
};

}  // namespace kinestat
