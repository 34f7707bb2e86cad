#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/internal/listed_screw.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfHelical = std::to_array<std::string_view>({"screw"});

constexpr auto kKeysOfHelical = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis, kAxisOfTurningAndSliding},
    {CouplingKey::pitch},
    {CouplingKey::lead},
});

constexpr auto write_helical = []<class Scalar>(const CouplingGeometryOf<Scalar>& g,
                                                CatalogueRow<Scalar>& row) {
  const Vec3Of<Scalar>& axis = g.axis.direction;
  row.add(
      {.name = "w", .is_rotation = true, .screw = turn_with_pitch<Scalar>(axis, g.at, g.pitch)});
  row.bear_forces_across(g.axis, g.at);
  row.add(
      {.name = "Ra", .is_couple = false, .screw = force_with_pitch<Scalar>(axis, g.at, -g.pitch)});
  row.bear_couples_across(g.axis);
};

constinit const KindMechanics kMechanicsOfHelical = {
    .screws = screws_by(write_helical),
    .law = [](LawWriter& law) { law.thread(law.geometry().pitch); },
};

}  // namespace

constinit const CouplingKind kHelical = {
    .type = CouplingType::helical,
    .word = "helical",
    .meaning = "screw and nut, in space: 1 freedom; needs at, axis, and pitch or lead",
    .example = "{type: helical, bodies: [frame, nut], at: [0, 0, 0], axis: z, lead: 5 mm}",
    .others = kNamesOfHelical,
    .keys = kKeysOfHelical,
    .mechanics = &kMechanicsOfHelical,
    .friction = FrictionKind::thread,
    .is_in_plane = false,
    .space_symbol = SpaceSymbol::sleeve,
};

}  // namespace kinestat
