#include <array>

#include "couplings/internal/added_freedoms.hpp"
#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfPrismatic = std::to_array<std::string_view>(
    {"slider", "slide", "translation", "translational", "sliding", "p"});

constexpr auto kKeysOfPrismatic = std::to_array<KindKey>({
    {CouplingKey::at,
     "A point of the coupling in the drawn position, which moves with the head. Its couples are "
     "about it, and with friction it is the middle of a guide with a 'length'; nothing else "
     "depends on it."},
    {CouplingKey::sliding_axis},
});

constexpr auto write_prismatic = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                                  CatalogueRow<Scalar>& row) {
  row.slide_along(g.axis);
  row.bear_forces_across(g.axis, g.at);
  row.bear_all_couples();
};

std::vector<CouplingUpgrade> upgrades_of_prismatic(std::span<const Twist> freedoms,
                                                   const Vec3& point) {
  const Vec3& axis = freedoms[0].linear;
  return {{.to = CouplingType::cylindrical, .added = {unit_rotation(axis, point)}},
          {.to = CouplingType::sphere_in_tube, .added = turns_about_all(point), .is_rare = true}};
}

constinit const KindMechanics kMechanicsOfPrismatic = {
    .screws = screws_by(write_prismatic),
    .law = [](LawWriter& law) { law.prism(); },
    .carried = {.forces = kWithHead, .couples = kAtTail, .place = Follows::head},
    .upgrades = upgrades_of_prismatic,
};

}  // namespace

constinit const CouplingKind kPrismatic = {
    .type = CouplingType::prismatic,
    .word = "prismatic",
    .meaning = "slides along an axis: 1 freedom; needs axis",
    .example = "{type: prismatic, bodies: [frame, slider], at: [0, 0], axis: x}",
    .others = kNamesOfPrismatic,
    .keys = kKeysOfPrismatic,
    .mechanics = &kMechanicsOfPrismatic,
    .friction = FrictionKind::guide,
    .needs_place = false,
    .is_bearing = true,
    .planar_symbol = PlanarSymbol::block,
    .space_symbol = SpaceSymbol::box,
};

}  // namespace kinestat
