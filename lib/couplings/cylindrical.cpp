#include <array>

#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfCylindrical = std::to_array<std::string_view>({"c", "cylinder"});

constexpr auto kKeysOfCylindrical = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis, kAxisOfTurningAndSliding},
});

}  // namespace

constinit const CouplingKind kCylindrical = {
    .type = CouplingType::cylindrical,
    .word = "cylindrical",
    .meaning = "turns about an axis and slides along it, in space: 2 freedoms; needs at, axis",
    .example = "{type: cylindrical, bodies: [frame, rod], at: [0, 0, 0], axis: z}",
    .others = kNamesOfCylindrical,
    .keys = kKeysOfCylindrical,
    .is_in_plane = false,
};

}  // namespace kinestat
