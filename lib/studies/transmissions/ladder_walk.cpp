#include "studies/transmissions/ladder_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/synthesis_tolerance.hpp"

namespace kinestat {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Ranges that overlap so widely that no walk is refuted soon are not refuted at all.
constexpr int kMostNodes = 20000;

ClosedRange with_slack(const ClosedRange& range) {
  return {.from = range.from * (1.0 - kRangeSlack), .to = range.to * (1.0 + kRangeSlack)};
}

ClosedRange common(const ClosedRange& a, const ClosedRange& b) {
  return {.from = std::max(a.from, b.from), .to = std::min(a.to, b.to)};
}

bool is_empty(const ClosedRange& range) {
  return !(range.from <= range.to);
}

bool meet(const ClosedRange& a, const ClosedRange& b) {
  return a.from <= b.to && b.from <= a.to;
}

}  // namespace

LadderBounds::LadderBounds(const LadderTask& task)
    : task_(task),
      step_(with_slack(task.step)),
      spread_(with_slack(task.spread)),
      reverse_({.from = -task.reverse_ratio.to * (1.0 + kRangeSlack),
                .to = -task.reverse_ratio.from * (1.0 - kRangeSlack)}) {
  const ClosedRange first = with_slack(task.first);
  const ClosedRange last = with_slack(task.last);
  forward_ = {.from = kInfinity, .to = 0.0};
  for (int gear = 0; gear < task.forward; ++gear) {
    const int left = task.forward - 1 - gear;
    ClosedRange window = {.from = first.from / std::pow(step_.to, gear),
                          .to = first.to / std::pow(step_.from, gear)};
    window = common(
        window,
        {.from = last.from * std::pow(step_.from, left), .to = last.to * std::pow(step_.to, left)});
    window = common(
        window, {.from = first.from / spread_.to * std::pow(step_.from, left), .to = kInfinity});
    forward_ = {.from = std::min(forward_.from, window.from),
                .to = std::max(forward_.to, window.to)};
    windows_.push_back(window);
  }
}

LadderWalk::LadderWalk(const GenericTrain& train,
                       const TransmissionLayout& layout,
                       const LadderBounds& bounds)
    : train_(train),
      gears_(layout.gears),
      bounds_(bounds),
      elements_(std::popcount(layout.classes)) {
  const auto& gears = layout.gears;
  for (std::size_t i = 0; i < gears.size(); ++i) {
    direct_ |= train.states()[gears[i].state].is_direct ? GearMask{1} << i : 0;
    for (std::size_t j = 0; j < gears.size(); ++j) {
      const unsigned differ = gears[i].elements ^ gears[j].elements;
      const GearMask bit = i != j ? GearMask{1} << j : 0;
      const bool is_one_change = std::popcount(differ) == 2;
      neighbours_[i] |= is_one_change || !bounds.task().one_change ? bit : 0;
      reverse_neighbours_[i] |= is_one_change || !bounds.task().reverse_change ? bit : 0;
    }
  }
}

LadderWalk::Candidates LadderWalk::candidates(std::span<const ClosedRange> ratios) const {
  Candidates result;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    result.forward |= meet(ratios[i], bounds_.forward()) ? GearMask{1} << i : 0;
    result.reverse |= meet(ratios[i], bounds_.reverse()) ? GearMask{1} << i : 0;
  }
  return result;
}

// Conditions that need no walk: enough gears, and every element engaged by some gear.
bool LadderWalk::may_do(const Candidates& candidates) const {
  const LadderTask& task = bounds_.task();
  if (std::popcount(candidates.forward) < task.forward ||
      (task.reverse > 0 && candidates.reverse == 0) ||
      (task.needs_direct && (candidates.forward & direct_) == 0)) {
    return false;
  }
  unsigned engaged = 0;
  GearMask all = candidates.forward | (task.reverse > 0 ? candidates.reverse : 0);
  for (; all != 0; all &= all - 1) {
    engaged |= gears_[static_cast<std::size_t>(std::countr_zero(all))].elements;
  }
  return engaged == (1U << elements_) - 1;
}

// Walks along ladders whose gears have ratios in given ranges; a known ratio is a range of one
// value. `Visit` answers whether to go on.
template <class Visit>
class LadderWalk::Walker {
 public:
  Walker(const LadderWalk& walk,
         std::span<const ClosedRange> ratios,
         const Candidates& candidates,
         const Visit& visit)
      : walk_(walk), ratios_(ratios), candidates_(candidates), visit_(visit) {}

  // Whether the visitor, or the bound of nodes, did not end it.
  bool run(int most_nodes) {
    nodes_left_ = most_nodes;
    for (GearMask rest = candidates_.forward; rest != 0; rest &= rest - 1) {
      const int gear = std::countr_zero(rest);
      const ClosedRange range = common(ratio(gear), bounds().window(0));
      if (!is_empty(range) && !go(gear, range)) {
        return false;
      }
    }
    return true;
  }

 private:
  const LadderBounds& bounds() const { return walk_.bounds_; }

  const ClosedRange& ratio(int gear) const { return ratios_[static_cast<std::size_t>(gear)]; }

  static GearMask bit(int gear) { return GearMask{1} << gear; }

  bool go(int gear, const ClosedRange& range) {
    if (--nodes_left_ < 0) {
      return false;
    }
    path_.push_back(static_cast<std::uint8_t>(gear));
    used_ |= bit(gear);
    const bool goes_on = step_from(gear, range);
    used_ ^= bit(gear);
    path_.pop_back();
    return goes_on;
  }

  bool step_from(int gear, const ClosedRange& range) {
    const LadderTask& task = bounds().task();
    if (task.needs_direct && (used_ & walk_.direct_) == 0 && range.to < 1.0) {
      return true;
    }
    if (path_.size() == 1) {
      first_ = range;
    }
    if (static_cast<int>(path_.size()) == task.forward) {
      return finish(range);
    }
    const ClosedRange next =
        common({.from = range.from / bounds().step().to, .to = range.to / bounds().step().from},
               bounds().window(static_cast<int>(path_.size())));
    GearMask rest =
        walk_.neighbours_[static_cast<std::size_t>(gear)] & candidates_.forward & ~used_;
    for (; rest != 0; rest &= rest - 1) {
      const int other = std::countr_zero(rest);
      const ClosedRange its = common(ratio(other), next);
      if (!is_empty(its) && !go(other, its)) {
        return false;
      }
    }
    return true;
  }

  bool finish(const ClosedRange& last) {
    const LadderTask& task = bounds().task();
    const bool is_direct = !task.needs_direct || (used_ & walk_.direct_) != 0;
    if (!is_direct || first_.from > last.to * bounds().spread().to ||
        first_.to < last.from * bounds().spread().from) {
      return true;
    }
    if (task.reverse == 0) {
      return finish_with(path_);
    }
    GearMask rest = candidates_.reverse & walk_.reverse_neighbours_[path_.front()] & ~used_;
    for (; rest != 0; rest &= rest - 1) {
      path_.push_back(static_cast<std::uint8_t>(std::countr_zero(rest)));
      const bool goes_on = finish_with(path_);
      path_.pop_back();
      if (!goes_on) {
        return false;
      }
    }
    return true;
  }

  bool finish_with(const Ladder& ladder) {
    ladder_gears_.clear();
    for (const std::uint8_t gear : ladder) {
      ladder_gears_.push_back(walk_.gears_[gear]);
    }
    return !all_have_use(walk_.train_, walk_.elements_, ladder_gears_) || visit_(ladder);
  }

  const LadderWalk& walk_;
  std::span<const ClosedRange> ratios_;
  Candidates candidates_;
  const Visit& visit_;
  int nodes_left_ = 0;
  Ladder path_;
  GearMask used_ = 0;
  ClosedRange first_;
  std::vector<LayoutGear> ladder_gears_;  // kept for its memory
};

bool LadderWalk::may_have_ladder(std::span<const ClosedRange> ratios) const {
  const Candidates found = candidates(ratios);
  if (!may_do(found)) {
    return false;
  }
  const auto stop = [](const Ladder&) { return false; };
  return !Walker(*this, ratios, found, stop).run(kMostNodes);
}

void LadderWalk::for_each_ladder(std::span<const double> ratios,
                                 const std::function<bool(const Ladder&)>& visit) const {
  std::array<ClosedRange, kMostGears> ranges;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    ranges[i] = {.from = ratios[i], .to = ratios[i]};
  }
  const std::span<const ClosedRange> points = std::span(ranges).first(ratios.size());
  Candidates found = candidates(points);
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    if (ratios[i] == 0.0) {
      found.forward &= ~(GearMask{1} << i);
      found.reverse &= ~(GearMask{1} << i);
    }
  }
  if (may_do(found)) {
    Walker(*this, points, found, visit).run(std::numeric_limits<int>::max());
  }
}

}  // namespace kinestat
