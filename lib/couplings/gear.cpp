#include <array>

#include "couplings/internal/kind_rows.hpp"

namespace kinestat {

namespace {

constexpr auto kNamesOfGear = std::to_array<std::string_view>({"spur_gear", "gears", "mesh"});

constexpr auto kKeysOfGear = std::to_array<KindKey>({
    {CouplingKey::at,
     "The pitch point in the drawn position: [x, y] in the plane, [x, y, z] in space. Where "
     "'gears' places both bodies, one number gives its position along the axis."},
    {CouplingKey::turning_axis,
     "The direction of the gears' axes: x, y, z, -x, -y, -z or a vector [ax, ay, az]. In the "
     "plane it is z, which need not be written."},
    {CouplingKey::tangent},
    {CouplingKey::pressure_angle},
    {CouplingKey::helix_angle},
    {CouplingKey::internal},
    {CouplingKey::contact},
    {CouplingKey::line_of_action,
     "The direction of the force of the tail on the head, instead of tangent and pressure angle."},
});

}  // namespace

constinit const CouplingKind kGear = {
    .type = CouplingType::gear,
    .word = "gear",
    .meaning =
        "two gears in mesh, rolling about the pitch point: 1 freedom; needs at, in space axis, "
        "and tangent with pressure_angle or line_of_action",
    .example =
        "{type: gear, bodies: [sun, planet], at: [0, 0], tangent: x, pressure_angle: 20 deg}",
    .others = kNamesOfGear,
    .keys = kKeysOfGear,
    .friction = FrictionKind::sliding,
    .teeth = Teeth::of_wheels,
};

}  // namespace kinestat
