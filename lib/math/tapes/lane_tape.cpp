#include "math/tapes/lane_tape.hpp"

#include "core/contract.hpp"
#include "math/tapes/internal/lane_player.hpp"

namespace kinestat {

LaneTape::Workspace LaneTape::make_workspace(std::size_t lanes) const {
  KINESTAT_EXPECTS(lanes == 1 || lanes == kLanes);
  Workspace result;
  result.lanes_ = lanes;
  result.groups_.resize((cell_count_ * lanes + kLanes) / kLanes);
  for (std::size_t c = 0; c < constants_.size(); ++c) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      result.cells()[c * lanes + lane] = constants_[c];
    }
  }
  return result;
}

void LaneTape::play(Workspace& workspace) const {
  const LaneOperations tape{.operations = operations_, .products = products_};
  workspace.lanes_ == 1 ? play_one(tape, workspace.cells(), workspace.failures_)
                        : play_lanes(tape, workspace.cells(), workspace.failures_);
}

}  // namespace kinestat
