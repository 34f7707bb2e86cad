#include "cases/report/efficiency_text.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "report/number_format.hpp"

namespace kinestat {

namespace {

std::string share_text(const Efficiency& one) {
  if (one.is_self_locking) {
    return "self-locking";
  }
  return one.value ? format_short(*one.value) : "none (" + one.reason + ")";
}

// All three have none, for one reason.
bool has_one_reason(const TransmissionEfficiency& efficiency) {
  const Efficiency& first = efficiency.carrier;
  return !first.is_self_locking && !first.reason.empty() &&
         first.reason == efficiency.carrier_backward.reason &&
         first.reason == efficiency.absolute.reason;
}

bool nothing_rolls(const LossyState& state) {
  return std::ranges::none_of(state.meshes, &MeshLossPower::rolls);
}

}  // namespace

std::string losses_text(const Mechanism& mechanism, const CaseAnalysis& one) {
  if (!one.efficiency) {
    return {};
  }
  const TransmissionEfficiency& efficiency = *one.efficiency;
  if (has_one_reason(efficiency)) {
    return fmt::format("  no efficiency with mesh losses: {}\n", efficiency.carrier.reason);
  }
  const std::string carrier = fmt::format(
      "  efficiency with mesh losses, of what rolls in each carrier: {}; backwards {}\n",
      share_text(efficiency.carrier),
      share_text(efficiency.carrier_backward));
  const std::string absolute =
      fmt::format("  efficiency with mesh losses, of all power seen from the ground: {}\n",
                  share_text(efficiency.absolute));
  const std::string_view block =
      efficiency.state && nothing_rolls(*efficiency.state)
          ? "  no lossy mesh rolls, as in a train that turns as a block: its teeth lose nothing;\n"
            "  the figure seen from the ground takes a share of power that only rides along with "
            "them\n"
          : "";
  return (mechanism.loss_model == LossModel::carrier ? carrier + absolute : absolute + carrier) +
         std::string(block);
}

}  // namespace kinestat
