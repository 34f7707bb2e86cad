#include <array>

#include "couplings/internal/key_texts.hpp"
#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfRigid = std::to_array<std::string_view>({"fixed", "weld", "welded"});

constexpr auto kKeysOfRigid = std::to_array<KindKey>({
    {CouplingKey::at, kPointForDrawings},
});

}  // namespace

constinit const CouplingKind kRigid = {
    .type = CouplingType::rigid,
    .word = "rigid",
    .meaning = "no freedom: the two bodies move as one",
    .example = "{type: rigid, bodies: [frame, ring]}",
    .others = kNamesOfRigid,
    .keys = kKeysOfRigid,
    .needs_place = false,
};

}  // namespace kinestat
