#include <array>

#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfScrews = std::to_array<KindKey>({
    {CouplingKey::freedoms},
    {CouplingKey::constraints},
});

}  // namespace

constinit const CouplingKind kScrews = {
    .type = CouplingType::screws,
    .word = "screws",
    .meaning = "freedoms and constraints given as screws; needs freedoms or constraints",
    .example = "{type: screws, bodies: [frame, table], freedoms: [{rotation: z, at: [0, 0, 0]}]}",
    .keys = kKeysOfScrews,
    .needs_place = false,
};

}  // namespace kinestat
