#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfUniversal = std::to_array<std::string_view>({"cardan", "hooke", "u"});

constexpr auto kKeysOfUniversal = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::axes},
});

constexpr auto write_universal = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                                  CatalogueRow<Scalar>& row) {
  row.turn_along(g.axis, g.at);
  row.turn_along(g.second, g.at);
  row.bear_all_forces(g.at);
  const AxisOf<Scalar> third = third_of<Scalar>(g.axis, g.second);
  row.bear_couple(name_along('T', third), third.direction);
};

void law_of_universal(LawWriter& law) {
  const Vec3 second = law.geometry().second.direction;
  law.add(ElementaryKind::turn, law.axis(), 0);
  law.add(ElementaryKind::turn, second, 1);
  law.meet();
  law.keep_angle(law.axis(), second);
  FreedomMeasure& about_first = law.measure(0, law.axis());
  about_first.from = second;
  about_first.to = second;
  FreedomMeasure& about_second = law.measure(1, second);
  about_second.is_in_head = true;
  about_second.sense = -1.0;
  about_second.from = law.axis();
  about_second.to = law.axis();
}

std::vector<CouplingUpgrade> upgrades_of_universal(std::span<const Twist> freedoms,
                                                   const Vec3& point) {
  const Vec3 third = freedoms[0].angular.cross(freedoms[1].angular).normalized();
  return {{.to = CouplingType::spherical, .added = {unit_rotation(third, point)}}};
}

constexpr auto kFreedomsOfUniversal = std::to_array<Carried>({kWithTail, kWithHead});

constinit const KindMechanics kMechanicsOfUniversal = {
    .screws = screws_by(write_universal),
    .law = law_of_universal,
    .carried = {.freedoms = kFreedomsOfUniversal,
                .forces = kAtTail,
                .couple_is_across_turns = true},
    .upgrades = upgrades_of_universal,
};

}  // namespace

constinit const CouplingKind kUniversal = {
    .type = CouplingType::universal,
    .word = "universal",
    .meaning = "turns about two crossing axes, in space: 2 freedoms; needs at, axes",
    .example = "{type: universal, bodies: [shaft, driven], at: [0, 0, 0], axes: [x, z]}",
    .others = kNamesOfUniversal,
    .keys = kKeysOfUniversal,
    .mechanics = &kMechanicsOfUniversal,
    .is_in_plane = false,
    .is_bearing = true,
    .space_symbol = SpaceSymbol::cross,
};

}  // namespace kinestat
