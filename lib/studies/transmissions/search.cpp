#include "studies/transmissions/search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <span>
#include <tuple>
#include <utility>

#include "core/synthesis_tolerance.hpp"
#include "studies/transmissions/labelled_search.hpp"

namespace kinestat {

namespace {

constexpr std::uint64_t kNoBound = std::numeric_limits<std::uint64_t>::max();

// A part of ranges takes as long as so many layouts that are refuted at once.
constexpr std::uint64_t kWorkOfPart = 10;

// Parts that are tried for a layout where it is but counted.
constexpr int kCountedParts = 100;

// A structure with the layouts of its elements, whatever ratios are asked for.
struct SearchedStructure {
  SearchedStructure(const TransmissionTask& task, const TransmissionStructure& structure)
      : train(structure, task.engaged),
        layouts(find_layouts(
            train, task.elements, task.ladder.forward + task.ladder.reverse, task.free_shafts)) {
    for (const VertexMap& automorphism : structure.automorphisms) {
      actions.emplace_back(structure, automorphism);
    }
  }

  GenericTrain train;
  std::vector<TransmissionLayout> layouts;
  std::vector<SetAction> actions;  // of the automorphisms
};

// All of one structure.
class StructureSearchJob {
 public:
  StructureSearchJob(const TransmissionTask& task,
                     const LadderBounds& bounds,
                     const SearchedStructure& structure)
      : task_(task), train_(structure.train) {
    add_layouts(structure, bounds);
  }

  // All that there are; found ones have no number of their structure yet.
  TransmissionSearch run() {
    result_.stages.structures = 1;
    result_.stages.layouts = layouts_.size();
    search_all();
    for (const Placed& one : layouts_) {
      result_.stages.layouts_found += one.is_found ? 1 : 0;
    }
    return std::move(result_);
  }

  TransmissionCount count(std::uint64_t most_work) {
    work_left_ = most_work;
    is_counting_ = true;
    search_all();
    return {.found = result_.stages.found,
            .is_of_a_part = is_of_a_part_ || work_left_ == 0,
            .work = most_work - work_left_};
  }

 private:
  // A layout, and where its ratios stand among those of all layouts.
  struct Placed {
    SearchedLayout searched;
    std::vector<std::size_t> places;
    bool is_found = false;
  };

  void search_all() {
    if (layouts_.empty()) {
      return;
    }
    RatioTable table(train_);
    for (const RoleChoice& choice :
         least_role_choices(task_.sets(), task_.double_planet_sets, {})) {
      search_roles(choice, table);
    }
  }

  void spend(std::uint64_t work) {
    work_left_ -= work_left_ == kNoBound ? 0 : std::min(work, work_left_);
  }

  void add_layouts(const SearchedStructure& structure, const LadderBounds& bounds) {
    std::map<std::uint32_t, std::size_t> place_of;
    layouts_.reserve(structure.layouts.size());
    for (const TransmissionLayout& layout : structure.layouts) {
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
        actions.push_back(structure.actions[which]);
      }
      layouts_.push_back({.searched = {.layout = layout,
                                       .states = std::move(states),
                                       .actions = std::move(actions),
                                       .walk = LadderWalk(train_, layout, bounds)},
                          .places = std::move(places)});
    }
  }

  // The ranges over all stationary ratios are made once for all layouts.
  void search_roles(const RoleChoice& choice, RatioTable& table) {
    const StationaryAxes axes(task_, choice);
    std::vector<ClosedRange> ranges;
    for (std::size_t i = 0; i < layouts_.size() && work_left_ > 0; ++i) {
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
      spend(1);
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
    if (is_counting_) {
      stages.found += search.has_any(kCountedParts) ? 1 : 0;
      is_of_a_part_ = is_of_a_part_ || search.is_given_up();
      spend(kWorkOfPart * search.parts());
      return;
    }
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
        result_.found.back().layout = static_cast<std::uint32_t>(layout);
        result_.found.back().figures = figures_of(result_.found.back());
        break;
    }
  }

  LadderFigures figures_of(const FoundTransmission& found) const {
    const TransmissionTrain transmission{.train = &train_,
                                         .roles = found.roles,
                                         .stationary_ratios = found.stationary_ratios,
                                         .elements = found.elements};
    return find_ladder_figures(
        task_, transmission, find_ladder_gears(task_, transmission, found.ladder));
  }

  const TransmissionTask& task_;
  const GenericTrain& train_;
  std::vector<Placed> layouts_;
  std::vector<std::uint32_t> states_;  // gears of any layout
  TransmissionSearch result_;
  std::uint64_t work_left_ = kNoBound;
  bool is_counting_ = false;
  bool is_of_a_part_ = false;
};

// One structure on its way.
struct SearchUnit {
  TransmissionSearch result = {};
  bool is_known = false;
  double weight = 0.0;
};

// Tells how far a search is.
class SearchTeller {
 public:
  SearchTeller(const std::vector<SearchUnit>& units,
               const std::function<void(const SearchProgress&)>& tell)
      : tell_(tell) {
    progress_.total = units.size();
    for (const SearchUnit& unit : units) {
      all_weight_ += unit.weight;
      if (unit.is_known) {
        ++progress_.known;
        add(unit);
      }
    }
    progress_.known_share = share();
  }

  void hear(const SearchUnit& unit) {
    if (tell_) {
      const std::lock_guard lock(mutex_);
      add(unit);
      progress_.share = share();
      tell_(progress_);
    }
  }

 private:
  void add(const SearchUnit& unit) {
    ++progress_.structures;
    progress_.found += unit.result.stages.found;
    weight_ += unit.weight;
  }

  double share() const { return all_weight_ > 0.0 ? weight_ / all_weight_ : 1.0; }

  const std::function<void(const SearchProgress&)>& tell_;
  std::mutex mutex_;
  SearchProgress progress_;
  double weight_ = 0.0;
  double all_weight_ = 0.0;
};

// What is counted of one structure for one task.
struct CountedPart {
  TransmissionCount count = {};
  std::size_t layouts = 0;
  bool is_cut = true;  // for want of work
};

// Structures that are searched, by their numbers.
std::vector<std::size_t> searched_numbers(const TransmissionTask& task,
                                          std::size_t structures,
                                          const SearchShare& share) {
  const std::size_t first = task.structures ? static_cast<std::size_t>((*task.structures)[0]) : 0;
  const std::size_t end =
      std::min(structures,
               task.structures ? static_cast<std::size_t>((*task.structures)[1]) + 1 : structures);
  std::vector<std::size_t> numbers;
  for (std::size_t number = first + share.place; number < end; number += share.count) {
    numbers.push_back(number);
  }
  return numbers;
}

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
                                        const SearchStore* store,
                                        const std::function<void(const SearchProgress&)>& tell) {
  const std::vector<TransmissionStructure> structures =
      enumerate_structures(task.sets(), task.engaged, task.free_shafts);
  const LadderBounds bounds(task.ladder);
  const std::vector<std::size_t> numbers = searched_numbers(task, structures.size(), share);
  std::vector<SearchUnit> units(numbers.size());
  const auto roles =
      static_cast<double>(least_role_choices(task.sets(), task.double_planet_sets, {}).size());
  // What is known, and how much else there is to do where somebody wants to hear of it.
  for_each(units.size(), [&](std::size_t i) {
    SearchUnit& unit = units[i];
    if (auto known = store != nullptr ? store->find(numbers[i]) : std::nullopt) {
      unit = {.result = *std::move(known), .is_known = true};
      unit.weight = static_cast<double>(unit.result.stages.labelled_layouts);
    } else if (tell) {
      const SearchedStructure structure(task, structures[numbers[i]]);
      unit.weight = roles * static_cast<double>(structure.layouts.size());
    }
  });
  SearchTeller teller(units, tell);
  for_each(units.size(), [&](std::size_t i) {
    SearchUnit& unit = units[i];
    if (unit.is_known) {
      return;
    }
    const SearchedStructure structure(task, structures[numbers[i]]);
    unit.result = StructureSearchJob(task, bounds, structure).run();
    for (FoundTransmission& one : unit.result.found) {
      one.structure = static_cast<std::uint32_t>(numbers[i]);
    }
    if (store != nullptr) {
      store->keep(numbers[i], unit.result);
    }
    teller.hear(unit);
  });
  TransmissionSearch result;
  result.structure_count = structures.size();
  for (SearchUnit& unit : units) {
    result.stages += unit.result.stages;
    std::ranges::move(unit.result.found, std::back_inserter(result.found));
  }
  // Ranks that only rounding tells apart leave the order of the numbers.
  std::ranges::stable_sort(result.found, {}, [](const FoundTransmission& one) {
    constexpr double kBeside = 0.2357;  // of what stands on a half
    return std::llround(one.rank / kSameRank + kBeside);
  });
  return result;
}

std::vector<TransmissionCount> count_transmissions(std::span<const TransmissionTask> tasks,
                                                   std::uint64_t layouts,
                                                   std::uint64_t most_work,
                                                   const ForEach& for_each) {
  std::vector<TransmissionCount> result(tasks.size());
  if (tasks.empty() || layouts == 0) {
    return result;
  }
  const TransmissionTask& first = tasks.front();
  const std::vector<TransmissionStructure> structures =
      enumerate_structures(first.sets(), first.engaged, first.free_shafts);
  const std::vector<std::size_t> numbers = searched_numbers(first, structures.size(), {});
  std::vector<CountedPart> parts(numbers.size() * tasks.size());
  // A share of the work by the layouts, and what others left of theirs once more.
  const auto count_parts = [&](std::uint64_t work_of_layout) {
    for_each(numbers.size(), [&](std::size_t i) {
      const std::span its = std::span(parts).subspan(i * tasks.size(), tasks.size());
      if (std::ranges::none_of(its, &CountedPart::is_cut)) {
        return;
      }
      const SearchedStructure structure(first, structures[numbers[i]]);
      for (std::size_t t = 0; t < tasks.size(); ++t) {
        its[t].layouts = structure.layouts.size();
        its[t].is_cut = its[t].is_cut && its[t].layouts > 0;
        if (its[t].is_cut) {
          const LadderBounds bounds(tasks[t].ladder);
          const std::uint64_t most = work_of_layout * its[t].layouts;
          its[t].count = StructureSearchJob(tasks[t], bounds, structure).count(most);
          its[t].is_cut = its[t].count.work == most;
        }
      }
    });
  };
  const std::uint64_t half = most_work / 2;
  const std::uint64_t share = half / (layouts * tasks.size()) + 1;
  count_parts(share);
  std::uint64_t work = 0;
  std::uint64_t cut_layouts = 0;
  for (const CountedPart& part : parts) {
    work += part.count.work;
    cut_layouts += part.is_cut ? part.layouts : 0;
  }
  const std::uint64_t more = cut_layouts > 0 ? (most_work - std::min(work, half)) / cut_layouts : 0;
  if (more > share) {
    count_parts(more);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    TransmissionCount& sum = result[i % tasks.size()];
    sum.found += parts[i].count.found;
    sum.is_of_a_part = sum.is_of_a_part || parts[i].count.is_of_a_part;
    sum.work += parts[i].count.work;
  }
  return result;
}

}  // namespace kinestat
