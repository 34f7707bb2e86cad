#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/internal/listed_screw.hpp"
#include "couplings/internal/reciprocal_complement.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfScrews = std::to_array<KindKey>({
    {CouplingKey::freedoms},
    {CouplingKey::constraints},
});

constexpr auto write_listed = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                               CatalogueRow<Scalar>& row) {
  for (const ScrewGeometryOf<Scalar>& screw : g.freedoms) {
    add_freedom<Scalar>(screw, row);
  }
  for (const ScrewGeometryOf<Scalar>& screw : g.constraints) {
    add_constraint<Scalar>(screw, row);
  }
  const CouplingScrewsOf<Scalar> given = row.screws();
  if (given.constraints.empty()) {
    for (auto& one : reciprocal_wrenches<Scalar>(given.freedoms, row.is_planar(), g.at)) {
      row.add(std::move(one));
    }
  } else if (given.freedoms.empty()) {
    for (auto& one : reciprocal_twists<Scalar>(given.constraints, row.is_planar(), g.at)) {
      row.add(std::move(one));
    }
  }
};

// One freedom is a turn, a slide or a thread; of several the order is not known.
void law_of_screws(LawWriter& law) {
  if (law.geometry().freedoms.size() != 1) {
    law.set_kind(LawKind::unknown);
    return;
  }
  const ScrewGeometry& screw = law.geometry().freedoms.front();
  law.take_axis(screw.direction.direction);
  if (screw.kind == ScrewWord::translation) {
    law.prism();
  } else {
    law.take_place(screw.at);
    screw.pitch == 0.0 ? law.hinge() : law.thread(screw.pitch);
  }
}

constinit const KindMechanics kMechanicsOfScrews = {
    .screws = screws_by(write_listed),
    .law = law_of_screws,
};

}  // namespace

constinit const CouplingKind kScrews = {
    .type = CouplingType::screws,
    .word = "screws",
    .meaning = "freedoms and constraints given as screws; needs freedoms or constraints",
    .example = "{type: screws, bodies: [frame, table], freedoms: [{rotation: z, at: [0, 0, 0]}]}",
    .keys = kKeysOfScrews,
    .mechanics = &kMechanicsOfScrews,
    .needs_place = false,
    .planar_symbol = PlanarSymbol::bars,
};

}  // namespace kinestat
