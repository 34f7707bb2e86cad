#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfSpherical = std::to_array<std::string_view>({"ball", "s"});

constexpr auto kKeysOfSpherical = std::to_array<KindKey>({
    {CouplingKey::at},
});

constexpr auto write_spherical = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                                  CatalogueRow<Scalar>& row) {
  row.turn_freely(g.at);
  row.bear_all_forces(g.at);
};

void law_of_spherical(LawWriter& law) {
  if (law.is_planar()) {
    law.hinge();
    return;
  }
  law.add(ElementaryKind::ball, law.axis(), 0);
  law.meet();
}

std::vector<CouplingUpgrade> upgrades_of_spherical(std::span<const Twist>, const Vec3&) {
  std::vector<CouplingUpgrade> upgrades;
  for (int i = 0; i < 3; ++i) {
    upgrades.push_back({.to = CouplingType::sphere_in_tube,
                        .added = {unit_translation(Vec3(Vec3::Unit(i)))},
                        .is_rare = true});
  }
  return upgrades;
}

constexpr auto kFreedomsOfSpherical = std::to_array<Carried>({kAtTail});

constinit const KindMechanics kMechanicsOfSpherical = {
    .screws = screws_by(write_spherical),
    .law = law_of_spherical,
    .carried = {.freedoms = kFreedomsOfSpherical, .forces = kAtTail, .couples = kAtTail},
    .upgrades = upgrades_of_spherical,
};

}  // namespace

constinit const CouplingKind kSpherical = {
    .type = CouplingType::spherical,
    .word = "spherical",
    .meaning = "ball and socket, in space: 3 freedoms; needs at",
    .example = "{type: spherical, bodies: [rocker, rod], at: [0, 0, 0]}",
    .others = kNamesOfSpherical,
    .keys = kKeysOfSpherical,
    .mechanics = &kMechanicsOfSpherical,
    .is_in_plane = false,
    .is_bearing = true,
    .space_symbol = SpaceSymbol::ball,
};

}  // namespace kinestat
