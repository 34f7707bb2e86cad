#include <array>

#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfUniversal = std::to_array<std::string_view>({"cardan", "hooke", "u"});

constexpr auto kKeysOfUniversal = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::axes},
});

}  // namespace

constinit const CouplingKind kUniversal = {
    .type = CouplingType::universal,
    .word = "universal",
    .meaning = "turns about two crossing axes, in space: 2 freedoms; needs at, axes",
    .example = "{type: universal, bodies: [shaft, driven], at: [0, 0, 0], axes: [x, z]}",
    .others = kNamesOfUniversal,
    .keys = kKeysOfUniversal,
    .is_in_plane = false,
};

}  // namespace kinestat
