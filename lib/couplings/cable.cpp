#include <array>

#include "couplings/cable_geometry.hpp"
#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfCable = std::to_array<std::string_view>({"rope", "belt"});

constexpr auto kKeysOfCable = std::to_array<KindKey>({
    {CouplingKey::from},
    {CouplingKey::to},
});

// The tail pulls the head from the end on the head towards the end on the tail.
constexpr auto write_cable = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                              CatalogueRow<Scalar>& row) {
  const Vec3Of<Scalar> along = unit_along<Scalar>(along_segment<Scalar>(g.from, g.to));
  if (row.is_planar()) {
    row.turn("w", Vec3Of<Scalar>::UnitZ(), g.from);
    row.turn("w", Vec3Of<Scalar>::UnitZ(), g.to);
  } else {
    const auto [first, second] = transverse_to<Scalar>(along);
    for (const Vec3Of<Scalar>& end : {g.from, g.to}) {
      row.turn("w", first, end);
      row.turn("w", second, end);
    }
    row.turn("w", along, g.to);
  }
  row.bear_force("F", -along, g.to);
};

// Without pulleys it is a rod between two points.
void law_of_cable(LawWriter& law) {
  law.set_kind(LawKind::contact);
  const CableStationGeometry tail = law.drawn().from.value_or(
      CableStationGeometry{.centre = law.geometry().from, .meets = {}, .leaves = {}});
  const CableStationGeometry head = law.drawn().to.value_or(
      CableStationGeometry{.centre = law.geometry().to, .meets = {}, .leaves = {}});
  const bool has_points = tail.leaves || head.meets;
  const bool is_wrapped = tail.radius != 0.0 || head.radius != 0.0;
  if (has_points || (is_wrapped && !law.is_planar())) {
    law.set_kind(LawKind::unknown);
    return;
  }
  ClosureCondition& condition = law.require(is_wrapped ? ClosureKind::cable : ClosureKind::reach);
  condition.tail_point = tail.centre;
  condition.head_point = head.centre;
  condition.tail_radius = tail.radius;
  condition.head_radius = head.radius;
  condition.value = (law.geometry().to - law.geometry().from).norm();
}

constinit const KindMechanics kMechanicsOfCable = {
    .screws = screws_by(write_cable),
    .law = law_of_cable,
    .carried = {.are_found_anew = true},
};

}  // namespace

constinit const CouplingKind kCable = {
    .type = CouplingType::cable,
    .word = "cable",
    .meaning =
        "a straight segment of a cable: 5 freedoms (2 in the plane); tension is positive; needs "
        "from, to",
    .example = "{type: cable, bodies: [frame, load], from: [0, 5], to: [0, 1]}",
    .others = kNamesOfCable,
    .keys = kKeysOfCable,
    .mechanics = &kMechanicsOfCable,
    .needs_place = false,
    .frees_more_in_space = true,
};

}  // namespace kinestat
