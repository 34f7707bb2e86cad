#include "studies/transmissions/labelled_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/synthesis_tolerance.hpp"
#include "studies/transmissions/section_layout.hpp"

namespace kinestat {

namespace {

// Parts of ranges of which that many are neither refuted nor solved are given up.
constexpr int kMostParts = 4000;

// Points that are tried before parts of ranges are refuted.
constexpr std::size_t kSamples = 64;

// Steps in which stationary ratios are bettered, and how many points that may take.
constexpr double kFirstStep = 0.256;
constexpr double kLastStep = 0.001;
constexpr int kMostRefinements = 1000;

double largest_size(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

// A number of the sequence of van der Corput: what is evenly spread, one after the other.
double spread_number(std::size_t index, std::size_t base) {
  double result = 0.0;
  double share = 1.0;
  for (; index > 0; index /= base) {
    share /= static_cast<double>(base);
    result += share * static_cast<double>(index % base);
  }
  return result;
}

}  // namespace

LabelledSearch::LabelledSearch(const TransmissionTask& task,
                               const GenericTrain& train,
                               const SearchedLayout& layout,
                               const RoleChoice& choice)
    : task_(task),
      train_(train),
      layout_(layout),
      choice_(choice),
      axes_(task, choice),
      table_(train),
      parts_left_(kMostParts) {
  best_.roles = choice;
  best_.rank = std::numeric_limits<double>::infinity();
}

LabelledOutcome LabelledSearch::run() {
  bool is_undecided = false;
  if (axes_.is_grid()) {
    search(axes_.whole());
  } else {
    try_samples();
    if (!is_found_) {
      search(axes_.whole());
      is_undecided = parts_left_ < 0;
    }
    if (is_found_) {
      refine();
    }
  }
  if (is_found_) {
    return LabelledOutcome::found;
  }
  if (has_ladder_) {
    return placements_ && placements_->empty() && !has_too_many_parts_
               ? LabelledOutcome::not_buildable
               : LabelledOutcome::over_limits;
  }
  return is_undecided ? LabelledOutcome::undecided : LabelledOutcome::refuted;
}

bool LabelledSearch::has_any(int most_parts) {
  parts_left_ = most_parts;
  needs_one_ = true;
  if (!axes_.is_grid()) {
    try_samples();
    parts_ += kSamples / kRatioLanes;
  }
  search(axes_.whole());
  return is_found_;
}

bool LabelledSearch::may_have_ladder(const StationaryPart& part) {
  ++parts_;
  std::array<ClosedRange, kMostGears> ranges;
  const std::span<ClosedRange> its = std::span(ranges).first(layout_.states.size());
  table_.set_corners(choice_, axes_.box(part));
  table_.ranges(layout_.states, its);
  return layout_.walk.may_have_ladder(its);
}

void LabelledSearch::search(const StationaryPart& part) {
  const bool is_grid = axes_.is_grid();
  const bool is_done =
      (is_found_ && (needs_one_ || !is_grid)) || (placements_ && placements_->empty());
  if (is_done || parts_left_ < 0 || !may_have_ladder(part)) {
    return;
  }
  if (axes_.is_corners(part)) {
    try_corners(part);
    return;
  }
  if (!is_grid) {
    --parts_left_;
    if (try_point(axes_.middle(part))) {
      return;
    }
  }
  std::array<StationaryPart, 2> halves;
  if (axes_.is_point(part)) {
    return;
  }
  if (!axes_.halve(part, halves)) {
    parts_left_ = -1;
    return;
  }
  search(halves[0]);
  search(halves[1]);
}

// The corners stand in the table.
void LabelledSearch::try_corners(const StationaryPart& part) {
  std::vector<RatioLanes> lanes(layout_.states.size() * table_.blocks());
  table_.ratios(layout_.states, lanes);
  const auto sets = static_cast<std::size_t>(task_.sets());
  std::vector<double> ratios(layout_.states.size());
  for (std::size_t corner = 0; corner < std::size_t{1} << sets; ++corner) {
    StationaryPoint point{};
    bool is_its_own = true;  // and not that of another corner
    for (std::size_t s = 0; s < sets; ++s) {
      const bool is_upper = (corner >> s & 1U) != 0;
      is_its_own = is_its_own && (!is_upper || part[s].last > part[s].first);
      point[s] = is_upper ? part[s].to : part[s].from;
    }
    if (!is_its_own || !is_least(part, corner)) {
      continue;
    }
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      ratios[i] = lanes[i * table_.blocks() + corner / kRatioLanes].at[corner % kRatioLanes];
    }
    if (try_ratios(point, ratios)) {
      ++best_.points;
    }
  }
}

// Whether no automorphism of the layout with its roles takes the point to an earlier one.
bool LabelledSearch::is_least(const StationaryPart& part, std::size_t corner) const {
  const auto sets = static_cast<std::size_t>(task_.sets());
  std::array<std::size_t, kMostGearSets> point{};
  for (std::size_t s = 0; s < sets; ++s) {
    point[s] = (corner >> s & 1U) != 0 ? part[s].last : part[s].first;
  }
  return std::ranges::none_of(layout_.actions, [&](const SetAction& action) {
    std::array<std::size_t, kMostGearSets> image{};
    for (std::size_t s = 0; s < sets; ++s) {
      image[static_cast<std::size_t>(action.set_of(static_cast<int>(s)))] = point[s];
    }
    return image < point && action.image(choice_) == choice_;
  });
}

bool LabelledSearch::try_point(const StationaryPoint& point) {
  std::array<StationaryPoint, kRatioLanes> points;
  points.fill(point);
  table_.set_points(choice_, points);
  std::vector<RatioLanes> lanes(layout_.states.size());
  table_.ratios(layout_.states, lanes);
  std::vector<double> ratios;
  for (const RatioLanes& one : lanes) {
    ratios.push_back(one.at[0]);
  }
  return try_ratios(point, ratios);
}

void LabelledSearch::try_samples() {
  constexpr std::array<std::size_t, kMostGearSets> kBases = {2, 3, 5, 7};
  std::vector<RatioLanes> lanes(layout_.states.size());
  std::vector<double> ratios(layout_.states.size());
  for (std::size_t sample = 0; sample < kSamples; sample += kRatioLanes) {
    std::array<StationaryPoint, kRatioLanes> points{};
    for (std::size_t lane = 0; lane < kRatioLanes; ++lane) {
      for (std::size_t s = 0; s < static_cast<std::size_t>(task_.sets()); ++s) {
        const double share = spread_number(sample + lane + 1, kBases[s]);
        const ClosedRange& range = axes_.range(s);
        points[lane][s] = axes_.nearest(s, range.from * std::pow(range.to / range.from, share));
      }
    }
    table_.set_points(choice_, points);
    table_.ratios(layout_.states, lanes);
    for (std::size_t lane = 0; lane < kRatioLanes; ++lane) {
      for (std::size_t i = 0; i < ratios.size(); ++i) {
        ratios[i] = lanes[i].at[lane];
      }
      try_ratios(points[lane], ratios);
      if (placements_ && placements_->empty()) {
        return;
      }
    }
  }
}

// From the best point found along each axis, and along two at once, as requirements are met on
// their edges; as long as the rank betters, in ever smaller steps.
void LabelledSearch::refine() {
  const auto sets = static_cast<std::size_t>(task_.sets());
  int tries_left = kMostRefinements;
  for (double step = kFirstStep; step > kLastStep / 2.0; step /= 2.0) {
    for (bool betters = true; betters;) {
      betters = false;
      for (std::size_t way = 0; way < 4 * sets * sets && tries_left > 0; ++way) {
        const std::size_t first = way / 4 / sets;
        const std::size_t second = way / 4 % sets;
        if (second < first || (second == first && way % 4 > 1)) {
          continue;
        }
        StationaryPoint point =
            neighbour(best_.stationary_ratios, first, way % 2 == 0 ? -step : step);
        if (second > first) {
          point = neighbour(point, second, way % 4 < 2 ? -step : step);
        }
        const double before = best_.rank;
        if (point != best_.stationary_ratios) {
          --tries_left;
          try_point(point);
        }
        betters = betters || best_.rank < before;
      }
    }
  }
}

StationaryPoint LabelledSearch::neighbour(StationaryPoint point,
                                          std::size_t set,
                                          double step) const {
  point[set] = axes_.neighbour(set, point[set], step);
  return point;
}

void LabelledSearch::find_placements() {
  placements_.emplace();
  const TransmissionStructure& structure = train_.structure();
  for (ElementPlacement& one : placements_of(train_, layout_.layout)) {
    const auto brakes = static_cast<int>(
        std::ranges::count_if(one, [](const ShaftPair& pair) { return pair[0] == kHousing; }));
    if (brakes != task_.brakes.value_or(brakes) ||
        !can_be_arranged(structure, choice_, one, task_.layout)) {
      continue;
    }
    const int clutches = static_cast<int>(one.size()) - brakes;
    const std::uint64_t hollow =
        task_.limits.hollow_shafts || counts_parts()
            ? least_hollow_shafts(structure, choice_, one, task_.layout).value_or(0)
            : 0;
    if (clutches > task_.limits.rotating_clutches.value_or(clutches) ||
        hollow > task_.limits.hollow_shafts.value_or(hollow)) {
      has_too_many_parts_ = true;
      continue;
    }
    placements_->push_back(
        {.elements = std::move(one), .parts = static_cast<std::uint64_t>(clutches) + hollow});
  }
  best_.placements = static_cast<std::uint32_t>(placements_->size());
}

void LabelledSearch::find_losses(const StationaryPoint& point) {
  std::array<double, kMostGearSets> set_losses{};
  for (int s = 0; s < task_.sets(); ++s) {
    set_losses[static_cast<std::size_t>(s)] =
        task_.losses[static_cast<std::size_t>(choice_.kind_of(s))];
  }
  losses_ = find_gear_losses(train_, choice_, point, set_losses, layout_.states);
}

// Whether some ladder of the point does all that is asked; the best is kept.
bool LabelledSearch::try_ratios(const StationaryPoint& point, std::span<const double> ratios) {
  bool is_good = false;
  losses_.clear();
  layout_.walk.for_each_ladder(ratios, [&](const Ladder& ladder) {
    has_ladder_ = true;
    if (!placements_) {
      find_placements();
    }
    if (placements_->empty()) {
      return false;
    }
    if (losses_.empty()) {
      find_losses(point);
    }
    is_good = try_ladder(point, ratios, ladder) || is_good;
    return true;
  });
  is_found_ = is_found_ || is_good;
  return is_good;
}

bool LabelledSearch::try_ladder(const StationaryPoint& point,
                                std::span<const double> ratios,
                                const Ladder& ladder) {
  // A gear that its losses lock is none.
  const double least = task_.limits.efficiency.value_or(0.0) * (1.0 - kRangeSlack);
  if (std::ranges::any_of(ladder, [&](std::uint8_t gear) {
        return losses_[gear].efficiency <= 0.0 || losses_[gear].efficiency < least;
      })) {
    return false;
  }
  FoundTransmission candidate;
  candidate.stationary_ratios = point;
  for (const std::uint8_t gear : ladder) {
    candidate.ladder.push_back(layout_.layout.gears[gear].elements);
    candidate.ratios.push_back(ratios[gear]);
  }
  candidate.rank = task_.rank == TransmissionRank::steps
                       ? unevenness(std::span(candidate.ratios).first(forward_gears()))
                       : mean_loss(ladder);
  const TransmissionLimits& limits = task_.limits;
  const bool needs_figures = limits.element_torque || limits.element_slip || limits.shaft_speed ||
                             limits.planet_speed || task_.rank == TransmissionRank::torque ||
                             task_.rank == TransmissionRank::speed || counts_parts();
  if (!needs_figures && candidate.rank >= best_.rank - kSameRank) {
    return true;
  }
  if (!choose_placement(candidate)) {
    return false;
  }
  if (candidate.rank < best_.rank - kSameRank) {
    best_.stationary_ratios = point;
    best_.elements = std::move(candidate.elements);
    best_.ladder = std::move(candidate.ladder);
    best_.ratios = std::move(candidate.ratios);
    best_.rank = candidate.rank;
  }
  return true;
}

double LabelledSearch::mean_loss(const Ladder& ladder) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < forward_gears(); ++i) {
    sum += 1.0 - losses_[ladder[i]].efficiency;
  }
  return sum / static_cast<double>(forward_gears());
}

std::vector<double> LabelledSearch::planet_turns(const StationaryPoint& point) const {
  std::vector<double> turns;
  for (int s = 0; s < task_.sets(); ++s) {
    turns.push_back(
        sun_by_planet(choice_.kind_of(s), point[static_cast<std::size_t>(s)], task_.teeth));
  }
  return turns;
}

// The placement that keeps the limits and, of those with the fewest parts where they are counted,
// of which the elements bear least; false if none keeps them.
bool LabelledSearch::choose_placement(FoundTransmission& candidate) const {
  const auto exceeds = [](double value, const std::optional<double>& limit) {
    return limit && value > *limit * (1.0 + kRangeSlack);
  };
  const TransmissionLimits& limits = task_.limits;
  const std::vector<double> turns =
      limits.planet_speed ? planet_turns(candidate.stationary_ratios) : std::vector<double>();
  double least = std::numeric_limits<double>::infinity();
  std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
  const double rank = candidate.rank;  // but for what the placement adds
  for (const Placement& placement : *placements_) {
    double torque = 0.0;
    double slip = 0.0;
    double speed = 0.0;
    double planets = 0.0;
    const TransmissionTrain transmission{.train = &train_,
                                         .roles = choice_,
                                         .stationary_ratios = candidate.stationary_ratios,
                                         .elements = placement.elements};
    for (const std::uint8_t engaged : candidate.ladder) {
      const GearFigures figures = find_gear_figures(transmission, engaged);
      torque = std::max(torque, largest_size(figures.torques));
      slip = std::max(slip, largest_size(figures.slips));
      speed = std::max(speed, largest_size(figures.speeds));
      for (std::size_t set = 0; set < turns.size(); ++set) {
        planets = std::max(planets, std::abs(figures.rolling[set] * turns[set]));
      }
    }
    const std::uint64_t parts = counts_parts() ? placement.parts : 0;
    const bool is_better = parts != fewest ? parts < fewest : torque < least * (1.0 - kRangeSlack);
    if (is_better && !exceeds(torque, limits.element_torque) &&
        !exceeds(slip, limits.element_slip) && !exceeds(speed, limits.shaft_speed) &&
        !exceeds(planets, limits.planet_speed)) {
      least = torque;
      fewest = parts;
      candidate.elements = placement.elements;
      candidate.rank = task_.rank == TransmissionRank::torque  ? torque
                       : task_.rank == TransmissionRank::speed ? speed
                                                               : rank + static_cast<double>(parts);
    }
  }
  return !candidate.elements.empty();
}

}  // namespace kinestat
