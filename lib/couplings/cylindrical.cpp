#include <array>

#include "couplings/internal/added_freedoms.hpp"
#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfCylindrical = std::to_array<std::string_view>({"c", "cylinder"});

constexpr auto kKeysOfCylindrical = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis, kAxisOfTurningAndSliding},
});

constexpr auto write_cylindrical = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                                    CatalogueRow<Scalar>& row) {
  row.turn_along(g.axis, g.at);
  row.slide_along(g.axis);
  row.bear_forces_across(g.axis, g.at);
  row.bear_couples_across(g.axis);
};

void law_of_cylindrical(LawWriter& law) {
  law.add(ElementaryKind::turn, law.axis(), 0);
  law.add(ElementaryKind::slide, law.axis(), 1);
  law.keep_along(law.first());
  law.keep_along(law.second());
  law.keep_axis();
  law.measure_turn(0, law.axis());
  law.measure_slide(1, law.axis());
}

std::vector<CouplingUpgrade> upgrades_of_cylindrical(std::span<const Twist> freedoms,
                                                     const Vec3& point) {
  return with_turns_across(CouplingType::sphere_in_tube, freedoms[0].angular, point);
}

constinit const KindMechanics kMechanicsOfCylindrical = {
    .screws = screws_by(write_cylindrical),
    .law = law_of_cylindrical,
    .upgrades = upgrades_of_cylindrical,
};

}  // namespace

constinit const CouplingKind kCylindrical = {
    .type = CouplingType::cylindrical,
    .word = "cylindrical",
    .meaning = "turns about an axis and slides along it, in space: 2 freedoms; needs at, axis",
    .example = "{type: cylindrical, bodies: [frame, rod], at: [0, 0, 0], axis: z}",
    .others = kNamesOfCylindrical,
    .keys = kKeysOfCylindrical,
    .mechanics = &kMechanicsOfCylindrical,
    .is_in_plane = false,
    .is_hinge = true,
    .is_bearing = true,
    .space_symbol = SpaceSymbol::sleeve,
};

}  // namespace kinestat
