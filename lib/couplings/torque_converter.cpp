#include <array>

#include "couplings/internal/catalogue_row.hpp"
#include "couplings/internal/kind_rows.hpp"
#include "couplings/internal/law_writer.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

constexpr auto kKeysOfConverter = std::to_array<KindKey>({
    {CouplingKey::at},
    {CouplingKey::turning_axis},
    {CouplingKey::stator},
    {CouplingKey::characteristic},
});

constexpr auto kNamesOfConverter =
    std::to_array<std::string_view>({"converter", "fluid_coupling", "hydraulic_coupling"});

// What flows in it bears a couple about the axis alone, which its characteristic tells.
constinit const KindMechanics kMechanicsOfConverter = {
    .screws = screws_by([](const auto& g, auto& row) { row.turn_along(g.axis, g.at); }),
    .law = [](LawWriter& law) { law.hinge(); },
};

}  // namespace

constinit const CouplingKind kTorqueConverter = {
    .type = CouplingType::torque_converter,
    .word = "torque_converter",
    .meaning =
        "a torque converter or fluid coupling from pump to turbine: 1 freedom; its characteristic "
        "gives the torques; needs at, in space axis",
    .example =
        "{type: torque_converter, bodies: [pump, turbine], at: [0, 0], stator: housing, "
        "characteristic: {pump_speed: 2000 rpm, pump_torque: 150 N*m, "
        "torque_ratio: 2 - speed_ratio}}",
    .others = kNamesOfConverter,
    .keys = kKeysOfConverter,
    .mechanics = &kMechanicsOfConverter,
    .friction = FrictionKind::fluid,
    .is_hinge = true,
    .space_symbol = SpaceSymbol::hinge,
};

}  // namespace kinestat
