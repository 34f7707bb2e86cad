#include <array>

#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfSpherical = std::to_array<std::string_view>({"ball", "s"});

constexpr auto kKeysOfSpherical = std::to_array<KindKey>({
    {CouplingKey::at},
});

}  // namespace

constinit const CouplingKind kSpherical = {
    .type = CouplingType::spherical,
    .word = "spherical",
    .meaning = "ball and socket, in space: 3 freedoms; needs at",
    .example = "{type: spherical, bodies: [rocker, rod], at: [0, 0, 0]}",
    .others = kNamesOfSpherical,
    .keys = kKeysOfSpherical,
    .is_in_plane = false,
};

}  // namespace kinestat
