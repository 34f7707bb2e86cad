#include "studies/motion/task/friction_turns.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "couplings/kinds.hpp"
#include "math/dense/first_crossing.hpp"

namespace kinestat {

namespace {

// Of more parts or rows a motion would take many times as long.
constexpr double kMostParts = 64.0;
constexpr double kMostRows = 4000.0;

// How short the shortest stretch is in which a friction slides the other way, in steps.
class ShortTurns {
 public:
  ShortTurns(const std::vector<FrictionSliding>& sliding, const SlidingBetween& between)
      : sliding_(sliding), between_(between) {}

  double shortest(std::size_t friction) {
    friction_ = friction;
    shortest_ = 1.0;
    for (std::size_t row = 1; row < sliding_.size(); ++row) {
      if (sliding_[row - 1].rates.empty() || sliding_[row].rates.empty()) {
        continue;
      }
      const Vec3& before = sliding_[row - 1].rates[friction];
      const Vec3& behind = sliding_[row].rates[friction];
      if (before.dot(behind) > 0.0) {
        if (may_dip(row)) {
          look(row, before.normalized());
        }
      } else if (behind.isZero(0.0) && sliding_[row].stands && !before.isZero(0.0)) {
        look(row, before.normalized());
      } else if (before.isZero(0.0) && sliding_[row - 1].stands && !behind.isZero(0.0)) {
        look_back(row, behind.normalized());
      }
    }
    return shortest_;
  }

 private:
  std::optional<double> speed(double row, const Vec3& along) const {
    const FrictionSliding there = between_(row);
    return there.rates.empty() ? std::nullopt : std::optional(there.rates[friction_].dot(along));
  }

  std::optional<double> speed_of(std::size_t row, const Vec3& along) const {
    return row < sliding_.size() && !sliding_[row].rates.empty()
               ? std::optional(sliding_[row].rates[friction_].dot(along))
               : std::nullopt;
  }

  // In the first and the last step always; else if it slides slowest at one end of the step.
  bool may_dip(std::size_t row) const {
    return row == 1 || row + 1 == sliding_.size() || dips_at(row - 1) || dips_at(row);
  }

  bool dips_at(std::size_t row) const {
    const Vec3 along = sliding_[row].rates[friction_].normalized();
    const std::optional<double> a = speed_of(row - 1, along);
    const std::optional<double> b = speed_of(row, along);
    const std::optional<double> c = speed_of(row + 1, along);
    return a && b && c && *b <= *a && *b <= *c;
  }

  void look(std::size_t row, const Vec3& along) {
    const auto to = static_cast<double>(row);
    find(to - 1.0, to, [&](double at) { return speed(at, along); });
  }

  // From behind, where it slides, to the rest before.
  void look_back(std::size_t row, const Vec3& along) {
    const auto from = static_cast<double>(row);
    find(0.0, 1.0, [&](double back) { return speed(from - back, along); });
  }

  void find(double from, double to, const ValueAt& value) {
    const std::optional<SignChange> there = find_crossing(value, from, to, kParts);
    if (!there) {
      return;
    }
    const double begin = border(value, there->before, there->behind);
    const double end = value(to).value_or(0.0) > 0.0 ? border(value, to, there->behind) : to;
    shortest_ = std::min(shortest_, end - begin);
  }

  // Between a place where it slides on and one where it slides back.
  static double border(const ValueAt& value, double on, double back) {
    constexpr int kHalvings = 12;
    for (int round = 0; round < kHalvings; ++round) {
      const double middle = 0.5 * (on + back);
      (value(middle).value_or(0.0) < 0.0 ? back : on) = middle;
    }
    return back;
  }

  static constexpr int kParts = 2;

  const std::vector<FrictionSliding>& sliding_;
  const SlidingBetween& between_;
  std::size_t friction_ = 0;
  double shortest_ = 1.0;
};

class TurnFinder {
 public:
  TurnFinder(const std::vector<FrictionSliding>& sliding,
             const SlidingBetween& between,
             MotionTable& table)
      : sliding_(sliding), between_(between), table_(table) {
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
      const FrictionSliding found =
          is_there ? between_(static_cast<double>(row) + (is_behind ? kBesideRow : -kBesideRow))
                   : FrictionSliding{};
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
  const SlidingBetween& between_;
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

int parts_for_friction(const Mechanism& mechanism,
                       const std::vector<FrictionSliding>& sliding,
                       const SlidingBetween& between) {
  double shortest = 1.0;
  ShortTurns turns(sliding, between);
  for (std::size_t f = 0; f < mechanism.frictions.size(); ++f) {
    if (!vanishes_at_rest(mechanism.frictions[f])) {
      shortest = std::min(shortest, turns.shortest(f));
    }
  }
  const double parts = shortest < 1.0 ? std::ceil(1.0 / shortest) + 1.0 : 1.0;
  const bool is_worth_it =
      parts <= kMostParts && parts * static_cast<double>(sliding.size()) <= kMostRows;
  return is_worth_it ? static_cast<int>(parts) : 1;
}

void find_friction_turns(const Mechanism& mechanism,
                         const std::vector<FrictionSliding>& sliding,
                         const SlidingBetween& between,
                         MotionTable& table) {
  TurnFinder finder(sliding, between, table);
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
