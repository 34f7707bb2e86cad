#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfPinInSlot = std::to_array<std::string_view>({"pin_slot"});

constexpr auto kKeysOfPinInSlot = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::slot},
});

// In space the pin stays perpendicular to the plane and in it.
constexpr auto write_pin_in_slot = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                                    CatalogueRow<Scalar>& row) {
  CatalogueRow<Scalar> in_plane(Space::planar);
  in_plane.turn_freely(g.at);
  in_plane.slide_along(g.axis);
  in_plane.bear_forces_across(g.axis, g.at);
  const CouplingScrewsOf<Scalar> screws = in_plane.take();
  for (const NamedTwistOf<Scalar>& freedom : screws.freedoms) {
    row.add(freedom);
  }
  row.add(screws.constraints.front());
  if (!row.is_planar()) {
    const AxisOf<Scalar> pin;
    row.bear_force_along(pin, g.at);
    row.bear_couples_across(pin);
  }
};

void law_of_pin_in_slot(LawWriter& law) {
  const Vec3 slot = law.axis();
  law.add(ElementaryKind::turn, Vec3::UnitZ(), 0);
  law.add(ElementaryKind::slide, slot, 1);
  law.keep_along_in_head(Vec3::UnitZ().cross(slot));
  if (!law.is_planar()) {
    law.keep_along_in_head(Vec3::UnitZ());
    law.keep_angle(Vec3::UnitX(), Vec3::UnitZ());
    law.keep_angle(Vec3::UnitY(), Vec3::UnitZ());
  }
  law.measure_turn(0, Vec3::UnitZ());
  FreedomMeasure& slide = law.measure(1, slot);
  slide.is_turn = false;
  slide.is_in_head = true;
}

constexpr auto kFreedomsOfPinInSlot = std::to_array<Carried>({kWithTail, kWithHead});

constinit const KindMechanics kMechanicsOfPinInSlot = {
    .screws = screws_by(write_pin_in_slot),
    .law = law_of_pin_in_slot,
    .carried = {.freedoms = kFreedomsOfPinInSlot, .forces = kHeadAtTail, .couples = kHeadAtTail},
};

}  // namespace

constinit const CouplingKind kPinInSlot = {
    .type = CouplingType::pin_in_slot,
    .word = "pin_in_slot",
    .meaning =
        "a pin of the first body in a straight slot of the second, in the plane: 2 freedoms; needs "
        "at, slot",
    .example = "{type: pin_in_slot, bodies: [crank, link], at: [0, 0], slot: x}",
    .others = kNamesOfPinInSlot,
    .keys = kKeysOfPinInSlot,
    .mechanics = &kMechanicsOfPinInSlot,
    .friction = FrictionKind::sliding,
    .is_in_space = false,
    .planar_symbol = PlanarSymbol::slot,
};

}  // namespace kinestat
