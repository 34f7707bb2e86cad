#include "studies/motion/task/friction_turns.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "couplings/kinds.hpp"

namespace kinestat {

namespace {

class TurnFinder {
 public:
  TurnFinder(const std::vector<FrictionSliding>& sliding,
             const SlidingBeside& beside,
             MotionTable& table)
      : sliding_(sliding), beside_(beside), table_(table) {
    // Before any turn is told: of several frictions at one row each has its own.
    for (std::size_t r = 0; r < sliding_.size(); ++r) {
      is_left_open_.push_back(!sliding_[r].stands &&
                              table_.rows[r].status == word_of(SolveStatus::at_rest));
    }
  }

  FrictionTurn find(std::size_t f, const std::string& coupling) {
    FrictionTurn turn{.coupling = coupling, .friction = f, .turns = {}};
    std::optional<std::size_t> before;
    for (std::size_t r = 0; r < sliding_.size(); ++r) {
      if (sliding_[r].rates.empty()) {
        before.reset();
        continue;
      }
      if (!slides(r, f)) {
        continue;
      }
      if (r == 1 && rests(0, f)) {
        add(0, 0, turn);
      } else if (before && sliding_[*before].rates[f].dot(sliding_[r].rates[f]) < 0.0) {
        add(*before, r, turn);
      }
      before = r;
    }
    const std::size_t last = sliding_.size() - 1;
    if (before && *before + 1 == last && rests(last, f)) {
      add(last, last, turn);
    }
    for (std::size_t r = 0; r < sliding_.size(); ++r) {
      look_beside(r, turn);
    }
    std::ranges::stable_sort(turn.turns, {}, &RowsAround::before);
    return turn;
  }

 private:
  bool slides(std::size_t row, std::size_t friction) const {
    return !sliding_[row].rates.empty() && !sliding_[row].rates[friction].isZero(0.0);
  }

  // Whether that leaves a row without an answer.
  bool rests(std::size_t row, std::size_t friction) const {
    return !sliding_[row].rates.empty() && sliding_[row].rates[friction].isZero(0.0) &&
           is_left_open_[row];
  }

  // Where so few steps are asked for that the rows beside one that rests do so, too.
  void look_beside(std::size_t row, FrictionTurn& turn) {
    const auto is_told = [row](const RowsAround& one) {
      return one.before == one.after ? one.before == row : one.before < row && row < one.after;
    };
    if (!rests(row, turn.friction) || std::ranges::any_of(turn.turns, is_told)) {
      return;
    }
    const bool is_last = row + 1 == sliding_.size();
    const auto sliding_at = [&](bool is_there, bool is_behind) {
      const FrictionSliding found = is_there ? beside_(row, is_behind) : FrictionSliding{};
      return found.rates.empty() ? Vec3(Vec3::Zero()) : found.rates[turn.friction];
    };
    const Vec3 before = sliding_at(row > 0, false);
    const Vec3 behind = sliding_at(!is_last, true);
    if (row == 0 || is_last ? !before.isZero(0.0) || !behind.isZero(0.0)
                            : before.dot(behind) < 0.0) {
      const bool is_at_end = row == 0 || is_last;
      add(is_at_end ? row : row - 1, is_at_end ? row : row + 1, turn);
    }
  }

  // What nothing but the turn of a friction leaves open is at its reversal.
  void add(std::size_t before, std::size_t after, FrictionTurn& turn) {
    turn.turns.push_back({.before = before, .after = after});
    const bool is_at_end = before == after;
    const std::size_t end = is_at_end ? after + 1 : after;
    for (std::size_t r = is_at_end ? before : before + 1; r < end; ++r) {
      if (is_left_open_[r]) {
        table_.rows[r].status = kFrictionReversalEvent;
      }
    }
  }

  const std::vector<FrictionSliding>& sliding_;
  const SlidingBeside& beside_;
  MotionTable& table_;
  std::vector<bool> is_left_open_;  // each row, by the direction of friction alone
};

}  // namespace

Vec3 sliding_of(const Topology& topology,
                CouplingId coupling,
                std::span<const std::optional<double>> rates) {
  const CouplingTopology& one = topology.coupling(coupling);
  const bool has_axis = kind_of(one.type).friction != FrictionKind::sliding;
  Vec3 result = Vec3::Zero();
  Eigen::Index count = 0;
  for (int i = 0; i < one.freedom_count && count < result.size(); ++i) {
    const auto f = static_cast<std::size_t>(one.first_freedom + i);
    if (has_axis || !topology.freedoms[f].is_rotation) {
      result[count++] = rates[f].value_or(0.0);
    }
  }
  return result;
}

FrictionSliding sliding_at(const Mechanism& mechanism,
                           const MotionPlan& plan,
                           const MotionPosition& position) {
  FrictionSliding sliding;
  if (!position.solved || !position.solved->motion || position.solved->motion->rates.empty()) {
    return sliding;
  }
  sliding.stands = has_drive_at_rest(plan, position);
  const std::vector<double>& known = position.solved->motion->rates;
  const std::vector<std::optional<double>> rates(known.begin(), known.end());
  const std::optional<StaticSolution>& action = position.solved->action;
  for (const CouplingFriction& friction : mechanism.frictions) {
    const CouplingId id = friction.coupling;
    const bool rests = action && std::ranges::find(action->at_rest, id) != action->at_rest.end();
    sliding.rates.push_back(rests ? Vec3(Vec3::Zero()) : sliding_of(mechanism.topology, id, rates));
  }
  return sliding;
}

void find_friction_turns(const Mechanism& mechanism,
                         const std::vector<FrictionSliding>& sliding,
                         const SlidingBeside& beside,
                         MotionTable& table) {
  TurnFinder finder(sliding, beside, table);
  for (std::size_t f = 0; f < mechanism.frictions.size(); ++f) {
    if (vanishes_at_rest(mechanism.frictions[f])) {
      continue;
    }
    const CouplingId id = mechanism.frictions[f].coupling;
    FrictionTurn turn = finder.find(f, mechanism.topology.coupling(id).name);
    if (!turn.turns.empty()) {
      table.friction_turns.push_back(std::move(turn));
    }
  }
}

CaseFindings told_of_row(const CaseFindings& said,
                         const FrictionSliding& sliding,
                         const MotionRow& row,
                         const MotionTable& table) {
  CaseFindings told;
  for (const CaseFinding& one : said.items()) {
    if (one.code != "E0606") {
      told.add(one);
    } else if (sliding.stands) {
      told.warning(
          "W0508",
          one.where,
          fmt::format("case '{}': friction has no direction while {}",
                      table.label,
                      table.drives.size() > 1 ? "a drive rests" : "the drive rests"),
          "at rest it may be anything up to its limit: these rows have no actions; extremes, "
          "means, "
          "RMS and energies leave it out there, and its own are over the rest of the time");
    } else if (row.status != kFrictionReversalEvent) {
      told.add(one);
    }
  }
  return told;
}

}  // namespace kinestat
