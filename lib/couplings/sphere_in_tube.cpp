#include <array>

#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfSphereInTube = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis,
     "The axis of the tube: x, y, z, -x, -y, -z or a vector [ax, ay, az] of any length but zero."},
});

}  // namespace

constinit const CouplingKind kSphereInTube = {
    .type = CouplingType::sphere_in_tube,
    .word = "sphere_in_tube",
    .meaning = "a ball in a tube, in space: 4 freedoms; needs at, axis",
    .example = "{type: sphere_in_tube, bodies: [rod, tube], at: [0, 0, 0], axis: z}",
    .keys = kKeysOfSphereInTube,
    .is_in_plane = false,
};

}  // namespace kinestat
