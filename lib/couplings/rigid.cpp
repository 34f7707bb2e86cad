#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfRigid = std::to_array<std::string_view>({"fixed", "weld", "welded"});

constexpr auto kKeysOfRigid = std::to_array<KindKey>({
    {CouplingKey::at, kPointForDrawings},
});

constexpr auto write_rigid = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                              CatalogueRow<Scalar>& row) {
  row.bear_all_forces(g.at);
  row.bear_all_couples();
};

void law_of_rigid(LawWriter& law) {
  law.meet();
  law.keep_orientation();
}

constinit const KindMechanics kMechanicsOfRigid = {
    .screws = screws_by(write_rigid),
    .law = law_of_rigid,
    .carried = {.forces = kAtTail, .couples = kAtTail},
};

}  // namespace

constinit const CouplingKind kRigid = {
    .type = CouplingType::rigid,
    .word = "rigid",
    .meaning = "no freedom: the two bodies move as one",
    .example = "{type: rigid, bodies: [frame, ring]}",
    .others = kNamesOfRigid,
    .keys = kKeysOfRigid,
    .mechanics = &kMechanicsOfRigid,
    .needs_place = false,
    .planar_symbol = PlanarSymbol::square,
};

}  // namespace kinestat
