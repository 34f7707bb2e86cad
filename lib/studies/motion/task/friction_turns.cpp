#include "studies/motion/task/friction_turns.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace kinestat {

namespace {

class TurnFinder {
 public:
  TurnFinder(std::span<const FrictionPlace> places,
             const SlidingBetween& between,
             MotionTable& table)
      : places_(places), between_(between), table_(table) {
    // Before any turn is told: of several frictions at one row each has its own.
    for (const FrictionPlace& one : places) {
      is_left_open_.push_back(one.row && !one.sliding.stands &&
                              table_.rows[*one.row].status == word_of(SolveStatus::at_rest));
    }
  }

  FrictionTurn find(std::size_t f, const std::string& coupling) {
    FrictionTurn turn{.coupling = coupling, .friction = f, .turns = {}};
    std::optional<std::size_t> before;
    for (std::size_t p = 0; p < places_.size(); ++p) {
      const std::vector<Vec3>& rates = places_[p].sliding.rates;
      if (rates.empty()) {
        before.reset();
        continue;
      }
      if (!slides(p, f)) {
        continue;
      }
      if (p == 1 && rests(0, f)) {
        add(0, 0, turn);
      } else if (before && places_[*before].sliding.rates[f].dot(rates[f]) < 0.0) {
        add(*before, p, turn);
      }
      before = p;
    }
    const std::size_t last = places_.size() - 1;
    if (before && *before + 1 == last && rests(last, f)) {
      add(last, last, turn);
    }
    for (std::size_t p = 0; p < places_.size(); ++p) {
      look_beside(p, turn);
    }
    std::ranges::stable_sort(turn.turns, {}, &PlacesAround::before);
    return turn;
  }

 private:
  bool slides(std::size_t place, std::size_t friction) const {
    return places_[place].sliding.slides(friction);
  }

  // Whether that leaves a row without an answer.
  bool rests(std::size_t place, std::size_t friction) const {
    const FrictionSliding& sliding = places_[place].sliding;
    return !sliding.rates.empty() && !sliding.slides(friction) && is_left_open_[place];
  }

  // Where so few steps are asked for that the places beside a row that rests do so, too.
  void look_beside(std::size_t place, FrictionTurn& turn) {
    const double step = places_[place].step;
    const auto is_told = [step](const PlacesAround& one) {
      return one.before == one.after ? one.before == step : one.before < step && step < one.after;
    };
    if (!rests(place, turn.friction) || std::ranges::any_of(turn.turns, is_told)) {
      return;
    }
    const bool is_last = place + 1 == places_.size();
    const auto sliding_at = [&](bool is_there, bool is_behind) {
      const FrictionSliding found =
          is_there ? between_(step + (is_behind ? kBesideRow : -kBesideRow)) : FrictionSliding{};
      return found.rates.empty() ? Vec3(Vec3::Zero()) : found.rates[turn.friction];
    };
    const Vec3 before = sliding_at(place > 0, false);
    const Vec3 behind = sliding_at(!is_last, true);
    if (place == 0 || is_last ? !before.isZero(0.0) || !behind.isZero(0.0)
                              : before.dot(behind) < 0.0) {
      const bool is_at_end = place == 0 || is_last;
      add(is_at_end ? place : place - 1, is_at_end ? place : place + 1, turn);
    }
  }

  // What nothing but the turn of a friction leaves open is at its reversal.
  void add(std::size_t before, std::size_t after, FrictionTurn& turn) {
    turn.turns.push_back({.before = places_[before].step, .after = places_[after].step});
    const bool is_at_end = before == after;
    const std::size_t end = is_at_end ? after + 1 : after;
    for (std::size_t p = is_at_end ? before : before + 1; p < end; ++p) {
      if (is_left_open_[p]) {
        table_.rows[*places_[p].row].status = kFrictionReversalEvent;
      }
    }
  }

  std::span<const FrictionPlace> places_;
  const SlidingBetween& between_;
  MotionTable& table_;
  std::vector<bool> is_left_open_;  // each row, by the direction of friction alone
};

}  // namespace

std::vector<FrictionTurn> find_friction_turns(const Mechanism& mechanism,
                                              std::span<const FrictionPlace> places,
                                              const SlidingBetween& between,
                                              MotionTable& table) {
  std::vector<FrictionTurn> turns;
  TurnFinder finder(places, between, table);
  for (std::size_t f = 0; f < mechanism.frictions.size(); ++f) {
    if (vanishes_at_rest(mechanism.frictions[f])) {
      continue;
    }
    const CouplingId id = mechanism.frictions[f].coupling;
    FrictionTurn turn = finder.find(f, mechanism.topology.coupling(id).name);
    if (!turn.turns.empty()) {
      turns.push_back(std::move(turn));
    }
  }
  return turns;
}

CaseFindings told_of_row(const CaseFindings& said,
                         const FrictionSliding& sliding,
                         const std::string& status,
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
    } else if (status != kFrictionReversalEvent) {
      told.add(one);
    }
  }
  return told;
}

}  // namespace kinestat
