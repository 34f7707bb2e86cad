#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfSphereInTube = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis,
     "The axis of the tube, which moves with the second body: x, y, z, -x, -y, -z or a vector [ax, "
     "ay, az] of any length but zero."},
});

constexpr auto write_sphere_in_tube = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                                       CatalogueRow<Scalar>& row) {
  row.turn_freely(g.at);
  row.slide_along(g.axis);
  row.bear_forces_across(g.axis, g.at);
};

void law_of_sphere_in_tube(LawWriter& law) {
  law.add(ElementaryKind::ball, law.axis(), 0);
  law.add(ElementaryKind::slide, law.axis(), 3);
  law.keep_along_in_head(law.first());
  law.keep_along_in_head(law.second());
  FreedomMeasure& slide = law.measure(3, law.axis());
  slide.is_turn = false;
  slide.is_in_head = true;
}

constexpr auto kFreedomsOfSphereInTube =
    std::to_array<Carried>({kAtTail, kAtTail, kAtTail, kWithHead});

constinit const KindMechanics kMechanicsOfSphereInTube = {
    .screws = screws_by(write_sphere_in_tube),
    .law = law_of_sphere_in_tube,
    .carried = {.freedoms = kFreedomsOfSphereInTube, .forces = kHeadAtTail, .couples = kHeadAtTail},
};

}  // namespace

constinit const CouplingKind kSphereInTube = {
    .type = CouplingType::sphere_in_tube,
    .word = "sphere_in_tube",
    .meaning =
        "a ball of the first body in a tube of the second, in space: 4 freedoms; needs at, axis",
    .example = "{type: sphere_in_tube, bodies: [rod, tube], at: [0, 0, 0], axis: z}",
    .keys = kKeysOfSphereInTube,
    .mechanics = &kMechanicsOfSphereInTube,
    .is_in_plane = false,
    .space_symbol = SpaceSymbol::ball,
};

}  // namespace kinestat
