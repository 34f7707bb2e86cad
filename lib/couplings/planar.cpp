#include <array>

#include "couplings/internal/added_freedoms.hpp"
#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfPlanar = std::to_array<std::string_view>({"plane"});

constexpr auto kKeysOfPlanar = std::to_array<KindKey>({
    {CouplingKey::at, kPointForDrawings},
    {CouplingKey::normal, "The normal of the plane in which the head slides and turns."},
});

constexpr auto write_planar = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                               CatalogueRow<Scalar>& row) {
  row.turn_along(g.axis, g.at);
  row.slide_across(g.axis);
  row.bear_force_along(g.axis, g.at);
  row.bear_couples_across(g.axis);
};

// The freedoms of the catalogue: the turn about the normal, then the slides across it.
void law_of_planar(LawWriter& law) {
  const auto keyword = law.geometry().axis.keyword;
  const Vec3 u = keyword == 0 ? law.first() : Vec3(Vec3::Unit(keyword == 'x' ? 1 : 0));
  const Vec3 v = keyword == 0 ? law.second() : Vec3(Vec3::Unit(keyword == 'z' ? 1 : 2));
  law.add(ElementaryKind::slide, u, 1);
  law.add(ElementaryKind::slide, v, 2);
  law.add(ElementaryKind::turn, law.axis(), 0);
  law.keep_along(law.axis());
  law.keep_axis();
  law.measure_turn(0, law.axis());
  law.measure_slide(1, u);
  law.measure_slide(2, v);
}

std::vector<CouplingUpgrade> upgrades_of_planar(std::span<const Twist> freedoms,
                                                const Vec3& point) {
  return with_turns_across(CouplingType::point_contact, freedoms[0].angular, point);
}

constexpr auto kFreedomsOfPlanar = std::to_array<Carried>({kWithHead, kWithTail});

constinit const KindMechanics kMechanicsOfPlanar = {
    .screws = screws_by(write_planar),
    .law = law_of_planar,
    .carried = {.freedoms = kFreedomsOfPlanar, .forces = kWithHead, .couples = kWithHead},
    .upgrades = upgrades_of_planar,
};

}  // namespace

constinit const CouplingKind kPlanar = {
    .type = CouplingType::planar,
    .word = "planar",
    .meaning = "slides and turns on a plane, in space: 3 freedoms; needs normal",
    .example = "{type: planar, bodies: [frame, block], at: [0, 0, 0], normal: z}",
    .others = kNamesOfPlanar,
    .keys = kKeysOfPlanar,
    .mechanics = &kMechanicsOfPlanar,
    .is_in_plane = false,
    .needs_place = false,
    .space_symbol = SpaceSymbol::plate,
};

}  // namespace kinestat
