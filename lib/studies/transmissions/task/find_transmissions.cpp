#include "studies/transmissions/task/find_transmissions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/synthesis_tolerance.hpp"
#include "files/output.hpp"
#include "mechanism/bind/bind.hpp"
#include "report/number_format.hpp"
#include "studies/transmissions/task/relaxation.hpp"
#include "studies/transmissions/task/stored_search.hpp"
#include "studies/transmissions/task/transmission_files.hpp"

namespace kinestat {

namespace {

// Ladders of which all ratios agree to this many parts are one.
constexpr double kLadderParts = 1e6;

// Fractions of few decimals stand on the halves of the parts, where rounding would tell equal ones
// apart; beside them none does.
std::vector<long long> ladder_key(const FoundTransmission& found) {
  constexpr double kBeside = 0.2357;
  std::vector<long long> key;
  for (const double ratio : found.ratios) {
    key.push_back(std::llround(ratio * kLadderParts + kBeside));
  }
  return key;
}

TransmissionVariant variant_of(const FoundTransmission& found,
                               const TransmissionStructure& structure,
                               const TransmissionTask& task) {
  TransmissionVariant variant{.found = found, .sets = structure.sets, .shafts = structure.shafts};
  for (std::size_t s = 0; s < structure.sets.size(); ++s) {
    variant.teeth.push_back(choose_teeth(
        found.roles.kind_of(static_cast<int>(s)), found.stationary_ratios[s], task.teeth));
  }
  variant.gears = list_gears(task, variant, found.stationary_ratios);
  return variant;
}

void add_groups(const TransmissionSearch& search,
                std::uint64_t top,
                TransmissionAnalysis& analysis) {
  const TransmissionTask& task = analysis.task;
  const std::vector<TransmissionStructure> structures =
      enumerate_structures(task.sets(), task.engaged, task.free_shafts);
  std::map<std::vector<long long>, std::size_t> keys;
  for (const FoundTransmission& one : search.found) {
    const auto [known, is_new] = keys.emplace(ladder_key(one), keys.size());
    const std::size_t group = known->second;
    if (is_new && keys.size() <= top) {
      analysis.groups.emplace_back();
    }
    if (group < analysis.groups.size()) {
      analysis.groups[group].variants.push_back(variant_of(one, structures[one.structure], task));
    }
  }
  analysis.ladder_count = keys.size();
  for (const FoundTransmission& one : search.found) {
    analysis.all.push_back(one.figures);
  }
}

// Empty iff an error was added.
std::optional<TransmissionSearch> search_stored(const TransmissionAnalysis& analysis,
                                                const TransmissionOptions& options,
                                                Diagnostics& found) {
  const ForEach for_each = for_each_on_threads(options.jobs);
  if (options.work.empty()) {
    return search_transmissions(analysis.task, for_each, {}, nullptr, options.progress);
  }
  StoredSearch stored(
      options.work, report_stem(analysis.file), analysis.description, analysis.task.rank);
  if (!stored.prepare(found)) {
    return std::nullopt;
  }
  const SearchStore store = stored.store();
  TransmissionSearch search = search_transmissions(
      analysis.task, for_each, options.share.value_or(SearchShare{}), &store, options.progress);
  stored.tell(found);
  return search;
}

// Warns of transmissions of which the teeth that are told are but rough: close to 1 planets have no
// room.
void warn_of_teeth(const TransmissionAnalysis& analysis, Diagnostics& found) {
  std::size_t count = 0;
  std::string example;
  for (std::size_t g = 0; g < analysis.groups.size(); ++g) {
    const std::vector<TransmissionVariant>& variants = analysis.groups[g].variants;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const TransmissionVariant& one = variants[i];
      for (std::size_t s = 0; s < one.teeth.size(); ++s) {
        const SetTeeth& teeth = one.teeth[s];
        const double wanted = one.found.stationary_ratios[s];
        if (std::abs(teeth.stationary_ratio() - wanted) <= kNearStationaryRatio &&
            teeth.planet >= kUsualLeastPlanet) {
          continue;
        }
        ++count;
        if (example.empty()) {
          example = fmt::format(
              "set {} of transmission {}.{}, of ratio {}, has {} by {} teeth, a ratio of "
              "{}, and planets of {}",
              s + 1,
              g,
              i,
              format_short(wanted),
              teeth.ring,
              teeth.sun,
              format_short(teeth.stationary_ratio()),
              teeth.planet);
        }
      }
    }
  }
  if (count > 0) {
    found.warning(
        "W0805",
        analysis.description.synthesis->transmission->where,
        fmt::format("no common teeth have the stationary ratios of {} sets: {}", count, example),
        "begin 'stationary_ratio' at 1.1 or above, or give 'teeth', which all that is "
        "found has then");
  }
}

std::string last_stage_text(const SearchStages& stages) {
  if (stages.undecided > 0 && stages.with_ladder == 0) {
    return fmt::format("none was found, and {} layouts stay undecided", stages.undecided);
  }
  if (stages.layouts == 0) {
    return "no layout of so many elements has as many gears of different ratio";
  }
  if (stages.not_refuted == 0) {
    return fmt::format("the ranges of ratios refute all {} layouts", stages.labelled_layouts);
  }
  if (stages.with_ladder == 0) {
    return fmt::format("of {} layouts that the ranges of ratios leave, none has a ladder",
                       stages.not_refuted);
  }
  return fmt::format("of {} with a ladder {} cannot be arranged and {} exceed limits",
                     stages.with_ladder,
                     stages.not_buildable,
                     stages.over_limits);
}

}  // namespace

std::vector<LadderGear> list_gears(const TransmissionTask& task,
                                   const TransmissionVariant& variant,
                                   const StationaryPoint& stationary_ratios) {
  const FoundTransmission& found = variant.found;
  const TransmissionStructure structure{
      .shafts = variant.shafts, .sets = variant.sets, .automorphisms = {}};
  const GenericTrain train(structure, task.engaged);
  return find_ladder_gears(task,
                           {.train = &train,
                            .roles = found.roles,
                            .stationary_ratios = stationary_ratios,
                            .elements = found.elements},
                           found.ladder);
}

std::optional<TransmissionAnalysis> find_transmissions(const std::string& path,
                                                       MechanismDescription description,
                                                       const TransmissionOptions& options,
                                                       Diagnostics& found) {
  if (!check(description, found)) {
    return std::nullopt;
  }
  if (!description.synthesis || !description.synthesis->transmission) {
    found.error("E0303",
                description.synthesis ? description.synthesis->where : SourceRange{},
                description.synthesis ? "the section 'synthesis' has no 'transmission'"
                                      : "the file has no section 'synthesis'",
                "'kinestat new transmission' writes an example");
    return std::nullopt;
  }
  std::optional<TransmissionTask> task = read_transmission_task(description, found);
  if (!task) {
    return std::nullopt;
  }
  task->rank = options.rank.value_or(task->rank);
  TransmissionAnalysis analysis;
  analysis.file = path;
  analysis.description = std::move(description);
  analysis.task = *std::move(task);
  const ForEach for_each = for_each_on_threads(options.jobs);
  const std::optional<TransmissionSearch> searched = search_stored(analysis, options, found);
  if (!searched) {
    return std::nullopt;
  }
  const TransmissionSearch& search = *searched;
  analysis.structure_count = search.structure_count;
  analysis.stages = search.stages;
  add_groups(search, options.top.value_or(kUsualLadders), analysis);
  const TransmissionDescription& wanted = *analysis.description.synthesis->transmission;
  const SourceRange where = wanted.where;
  if (analysis.stages.structures == 0 && !options.share) {
    found.error(
        "E0803",
        wanted.structures ? wanted.structures->where : where,
        fmt::format("there are {} structures, and none of 'structures'", analysis.structure_count),
        fmt::format("their numbers are 0 to {}", analysis.structure_count - 1));
    return std::nullopt;
  }
  if (analysis.stages.undecided > 0) {
    found.warning(
        "W0803",
        where,
        fmt::format("{} layouts are neither refuted nor solved", analysis.stages.undecided),
        "narrow 'stationary_ratio', or give its values as a list");
  }
  if (!analysis.task.teeth) {
    warn_of_teeth(analysis, found);
  }
  if (analysis.stages.found == 0 && !options.share) {
    found.error("E0804",
                where,
                "no transmission was found that meets the requirements: " +
                    last_stage_text(analysis.stages),
                relaxation_text(analysis.task, analysis.stages, for_each));
  }
  return analysis;
}

}  // namespace kinestat
