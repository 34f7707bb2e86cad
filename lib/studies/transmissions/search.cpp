#include "studies/transmissions/search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "core/synthesis_tolerance.hpp"
#include "studies/transmissions/labelled_search.hpp"

namespace kinestat {

namespace {

// All of one structure.
class StructureSearchJob {
 public:
  StructureSearchJob(const TransmissionTask& task,
                     const LadderBounds& bounds,
                     const TransmissionStructure& structure,
                     std::uint32_t number)
      : task_(task), bounds_(bounds), train_(structure, task.engaged), number_(number) {
    for (const VertexMap& automorphism : structure.automorphisms) {
      actions_.emplace_back(structure, automorphism);
    }
    add_layouts();
  }

  TransmissionSearch run() {
    result_.stages.structures = 1;
    result_.stages.layouts = layouts_.size();
    if (!layouts_.empty()) {
      RatioTable table(train_);
      for (const RoleChoice& choice :
           least_role_choices(task_.sets(), task_.double_planet_sets, {})) {
        search_roles(choice, table);
      }
    }
    for (const Placed& one : layouts_) {
      result_.stages.layouts_found += one.is_found ? 1 : 0;
    }
    return std::move(result_);
  }

 private:
  // A layout, and where its ratios stand among those of all layouts.
  struct Placed {
    SearchedLayout searched;
    std::vector<std::size_t> places;
    bool is_found = false;
  };

  void add_layouts() {
    std::vector<TransmissionLayout> found = find_layouts(
        train_, task_.elements, task_.ladder.forward + task_.ladder.reverse, task_.free_shafts);
    std::map<std::uint32_t, std::size_t> place_of;
    layouts_.reserve(found.size());
    for (TransmissionLayout& layout : found) {
      std::vector<std::uint32_t> states;
      std::vector<std::size_t> places;
      for (const LayoutGear& gear : layout.gears) {
        const auto [place, is_new] = place_of.emplace(gear.state, states_.size());
        if (is_new) {
          states_.push_back(gear.state);
        }
        states.push_back(gear.state);
        places.push_back(place->second);
      }
      std::vector<SetAction> actions;
      for (const std::size_t which : layout.automorphisms) {
        actions.push_back(actions_[which]);
      }
      LadderWalk walk(train_, layout, bounds_);
      layouts_.push_back({.searched = {.layout = std::move(layout),
                                       .states = std::move(states),
                                       .actions = std::move(actions),
                                       .walk = walk},
                          .places = std::move(places)});
    }
  }

  // The ranges over all stationary ratios are made once for all layouts.
  void search_roles(const RoleChoice& choice, RatioTable& table) {
    const StationaryAxes axes(task_, choice);
    std::vector<ClosedRange> ranges;
    for (std::size_t i = 0; i < layouts_.size(); ++i) {
      Placed& one = layouts_[i];
      if (one.searched.actions.size() > 1 && !is_least(choice, one.searched.actions)) {
        continue;
      }
      if (ranges.empty()) {
        ranges.resize(states_.size());
        table.set_corners(choice, axes.box(axes.whole()));
        table.ranges(states_, ranges);
      }
      ++result_.stages.labelled_layouts;
      if (may_have_ladder(one, ranges)) {
        ++result_.stages.not_refuted;
        search_labelled(i, choice);
      }
    }
  }

  static bool may_have_ladder(const Placed& one, const std::vector<ClosedRange>& ranges) {
    std::array<ClosedRange, kMostGears> its;
    for (std::size_t g = 0; g < one.places.size(); ++g) {
      its[g] = ranges[one.places[g]];
    }
    return one.searched.walk.may_have_ladder(std::span(its).first(one.places.size()));
  }

  void search_labelled(std::size_t layout, const RoleChoice& choice) {
    LabelledSearch search(task_, train_, layouts_[layout].searched, choice);
    SearchStages& stages = result_.stages;
    switch (search.run()) {
      case LabelledOutcome::refuted:
        break;
      case LabelledOutcome::undecided:
        ++stages.undecided;
        break;
      case LabelledOutcome::not_buildable:
        ++stages.with_ladder;
        ++stages.not_buildable;
        break;
      case LabelledOutcome::over_limits:
        ++stages.with_ladder;
        ++stages.over_limits;
        break;
      case LabelledOutcome::found:
        ++stages.with_ladder;
        ++stages.found;
        stages.points += search.best().points;
        layouts_[layout].is_found = true;
        result_.found.push_back(search.best());
        result_.found.back().structure = number_;
        result_.found.back().layout = static_cast<std::uint32_t>(layout);
        result_.found.back().figures = figures_of(result_.found.back());
        break;
    }
  }

  LadderFigures figures_of(const FoundTransmission& found) const {
    return find_ladder_figures(task_,
                               found.elements,
                               find_ladder_gears(task_,
                                                 {.train = &train_,
                                                  .roles = found.roles,
                                                  .stationary_ratios = found.stationary_ratios,
                                                  .elements = found.elements},
                                                 found.ladder));
  }

  const TransmissionTask& task_;
  const LadderBounds& bounds_;
  GenericTrain train_;
  std::uint32_t number_;
  std::vector<SetAction> actions_;
  std::vector<Placed> layouts_;
  std::vector<std::uint32_t> states_;  // gears of any layout
  TransmissionSearch result_;
};

}  // namespace

SearchStages& SearchStages::operator+=(const SearchStages& other) {
  structures += other.structures;
  layouts += other.layouts;
  labelled_layouts += other.labelled_layouts;
  not_refuted += other.not_refuted;
  undecided += other.undecided;
  with_ladder += other.with_ladder;
  not_buildable += other.not_buildable;
  over_limits += other.over_limits;
  points += other.points;
  found += other.found;
  layouts_found += other.layouts_found;
  return *this;
}

TransmissionSearch search_transmissions(const TransmissionTask& task,
                                        const ForEach& for_each,
                                        const SearchShare& share,
                                        const SearchStore* store) {
  const std::vector<TransmissionStructure> structures =
      enumerate_structures(task.sets(), task.engaged, task.free_shafts);
  const LadderBounds bounds(task.ladder);
  const std::size_t first = task.structures ? static_cast<std::size_t>((*task.structures)[0]) : 0;
  const std::size_t end = std::min(
      structures.size(),
      task.structures ? static_cast<std::size_t>((*task.structures)[1]) + 1 : structures.size());
  std::vector<std::size_t> numbers;
  for (std::size_t number = first + share.place; number < end; number += share.count) {
    numbers.push_back(number);
  }
  std::vector<TransmissionSearch> parts(numbers.size());
  for_each(parts.size(), [&](std::size_t i) {
    const std::size_t number = numbers[i];
    if (store != nullptr) {
      if (std::optional<TransmissionSearch> known = store->find(number)) {
        parts[i] = *std::move(known);
        return;
      }
    }
    parts[i] =
        StructureSearchJob(task, bounds, structures[number], static_cast<std::uint32_t>(number))
            .run();
    if (store != nullptr) {
      store->keep(number, parts[i]);
    }
  });
  TransmissionSearch result;
  result.structure_count = structures.size();
  for (TransmissionSearch& part : parts) {
    result.stages += part.stages;
    std::ranges::move(part.found, std::back_inserter(result.found));
  }
  // Ranks that only rounding tells apart leave the order of the numbers.
  std::ranges::stable_sort(result.found, {}, [](const FoundTransmission& one) {
    constexpr double kBeside = 0.2357;  // of what stands on a half
    return std::llround(one.rank / kSameRank + kBeside);
  });
  return result;
}

}  // namespace kinestat
