#include <array>

#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfPlanar = std::to_array<std::string_view>({"plane"});

constexpr auto kKeysOfPlanar = std::to_array<KindKey>({
    {CouplingKey::at, kPointForDrawings},
    {CouplingKey::normal, "The normal of the plane in which the head slides and turns."},
});

}  // namespace

constinit const CouplingKind kPlanar = {
    .type = CouplingType::planar,
    .word = "planar",
    .meaning = "slides and turns on a plane, in space: 3 freedoms; needs normal",
    .example = "{type: planar, bodies: [frame, block], at: [0, 0, 0], normal: z}",
    .others = kNamesOfPlanar,
    .keys = kKeysOfPlanar,
    .is_in_plane = false,
    .needs_place = false,
};

}  // namespace kinestat
