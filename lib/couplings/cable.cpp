#include <array>

#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfCable = std::to_array<std::string_view>({"rope", "belt"});

constexpr auto kKeysOfCable = std::to_array<KindKey>({
    {CouplingKey::from},
    {CouplingKey::to},
});

}  // namespace

constinit const CouplingKind kCable = {
    .type = CouplingType::cable,
    .word = "cable",
    .meaning =
        "a straight segment of a rope: 5 freedoms (2 in the plane); tension is positive; needs "
        "from, to",
    .example = "{type: cable, bodies: [frame, load], from: [0, 5], to: [0, 1]}",
    .others = kNamesOfCable,
    .keys = kKeysOfCable,
    .needs_place = false,
};

}  // namespace kinestat
