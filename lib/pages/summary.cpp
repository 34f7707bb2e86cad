#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cases/report/planet_fit_record.hpp"
#include "core/spelling.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "couplings/kinds.hpp"
#include "pages/page_parts.hpp"
#include "report/number_format.hpp"
#include "studies/shift/report/gear_report.hpp"

namespace kinestat {

namespace {

// More values than these are read from the tables.
constexpr std::size_t kMostListed = 10;

using Sentences = std::vector<std::string>;

// "7 revolute, 4 gear", in the order in which the types first appear.
std::string types_text(const Topology& topology) {
  std::vector<std::pair<CouplingType, int>> counts;
  for (const CouplingTopology& one : topology.couplings) {
    const auto at =
        std::ranges::find(counts, one.type, [](const auto& count) { return count.first; });
    if (at == counts.end()) {
      counts.emplace_back(one.type, 1);
    } else {
      ++at->second;
    }
  }
  std::vector<std::string> parts;
  for (const auto& [type, count] : counts) {
    parts.push_back(fmt::format("{} {}", count, in_words(word_of(type))));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

void add_size(const Mechanism& mechanism, Sentences& sentences) {
  const Topology& topology = mechanism.topology;
  const int circuits = mechanism.graph.circuit_count();
  sentences.push_back(fmt::format("{} and {} ({}) form {}.",
                                  counted(topology.body_count(), "body", "bodies"),
                                  counted(topology.coupling_count(), "coupling"),
                                  types_text(topology),
                                  counted(circuits, "independent circuit")));
}

std::string mobility_reading(int net_freedom) {
  switch (net_freedom) {
    case 0:
      return "nothing can move";
    case 1:
      return "one given rate determines all others";
    default:
      return fmt::format("{} given rates determine all others", net_freedom);
  }
}

// "21 in space, 6 in the plane"; orders in which nothing is redundant are left out.
std::string redundancy_text(const MobilityCounts& counts) {
  std::vector<std::string> parts;
  const auto add = [&](const MotionCounts& one, const char* where) {
    if (one.net_constraint > 0) {
      parts.push_back(fmt::format("{} {}", one.net_constraint, where));
    }
  };
  add(counts.spatial.motions, "in space");
  if (counts.planar) {
    add(counts.planar->motions, "in the plane");
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

void add_mobility(const MobilityCounts& counts, Sentences& sentences) {
  const MotionCounts& minimal = counts.minimal.motions;
  sentences.push_back(
      fmt::format("Mobility {}: {}.", minimal.net_freedom, mobility_reading(minimal.net_freedom)));
  const std::string redundant = redundancy_text(counts);
  sentences.push_back(redundant.empty() ? "No constraint is redundant."
                                        : fmt::format("Redundant constraints: {}.", redundant));
}

bool is_solved(const CaseAnalysis& one) {
  return (!one.motion || one.motion->status == SolveStatus::solved) &&
         (!one.action || one.action->status == SolveStatus::solved);
}

// "M3 (actions indeterminate)"
std::string open_text(const CaseAnalysis& one) {
  std::vector<std::string> parts;
  if (one.motion && one.motion->status != SolveStatus::solved) {
    parts.push_back(fmt::format("motions {}", in_words(word_of(one.motion->status))));
  }
  if (one.action && one.action->status != SolveStatus::solved) {
    parts.push_back(fmt::format("actions {}", in_words(word_of(one.action->status))));
  }
  return fmt::format("{} ({})", printable(one.which.label), fmt::join(parts, ", "));
}

// "5 cases and 4 gears are", "1 gear is".
std::string counted_cases(const Analysis& analysis) {
  const int gears = gear_count(analysis);
  const int others = static_cast<int>(analysis.cases.size()) - gears;
  if (gears == 0 || others == 0) {
    return gears == 0 ? counted(others, "case is", "cases are")
                      : counted(gears, "gear is", "gears are");
  }
  return fmt::format("{} and {} are", counted(others, "case"), counted(gears, "gear"));
}

// A motion has positions of its own, so that it may be solved where the drawn one is not.
void add_cases(const Analysis& analysis, bool moves, Sentences& sentences) {
  const std::vector<CaseAnalysis>& cases = analysis.cases;
  if (cases.empty()) {
    return;
  }
  std::vector<std::string> open;
  for (const CaseAnalysis& one : cases) {
    if (!is_solved(one)) {
      open.push_back(open_text(one));
    }
  }
  const auto count = static_cast<int>(cases.size());
  const int solved = count - static_cast<int>(open.size());
  const std::string list = plain_list(open, kMostListed);
  sentences.push_back(
      open.empty() ? fmt::format("{} solved.", counted_cases(analysis))
      : solved == 0
          ? fmt::format("{} case is solved: {}.", moves ? "In the drawn position no" : "No", list)
          : fmt::format(
                "Of {} cases {} solved; not so: {}.", count, counted(solved, "is", "are"), list));
}

// Of teeth; power that runs around a linkage is nothing to look at.
void add_circulation(const Analysis& analysis, Sentences& sentences) {
  const bool meshes = std::ranges::any_of(
      analysis.mechanism.topology.couplings, has_teeth, &CouplingTopology::type);
  if (!meshes) {
    return;
  }
  std::vector<std::string> labels;
  for (const CaseAnalysis& one : analysis.cases) {
    if (one.power_graph && !one.power_graph->circulating.empty()) {
      labels.push_back(printable(one.which.label));
    }
  }
  if (!labels.empty()) {
    sentences.push_back(fmt::format("Power circulates in {}.", plain_list(labels, kMostListed)));
  }
}

void add_shift(const ShiftAnalysis& shift, Sentences& sentences) {
  const ShiftSolution& solution = shift.solution;
  const auto elements = static_cast<int>(shift.plan.elements.size());
  const auto gears = static_cast<int>(solution.table.steps.size());
  std::string text = fmt::format("A gear engages {} of {} shift elements; {} of {} {}",
                                 solution.needed,
                                 elements,
                                 gears,
                                 counted(solution.states.size(), "combination"),
                                 gears == 1 ? "gives a gear" : "give a gear");
  if (solution.table.span) {
    text += fmt::format("; the ratio spread of the forward gears is {}",
                        format_short(*solution.table.span));
  }
  sentences.push_back(text + ".");
}

std::string end_text(const MotionTable& motion, const DriveTravel& drive) {
  switch (motion.end) {
    case MotionEnd::complete:
      return "";
    case MotionEnd::limited:
    case MotionEnd::lost:
      return drive.reached
                 ? fmt::format(", but reaches only {} {}", format_short(*drive.reached), drive.unit)
                 : "";
    case MotionEnd::drives_locked:
      return motion.drives.size() > 1 ? ", but cannot run with the others" : ", but cannot run";
    case MotionEnd::not_assembled:
      return ", but the drawn position cannot be assembled";
  }
  return "";
}

// "30 to 390 deg", or as far as the drive goes.
void add_motion(const MotionTable& motion, Sentences& sentences) {
  const bool is_to_limit = motion.until_limit && motion.end == MotionEnd::limited;
  std::string text;
  for (const DriveTravel& drive : motion.drives) {
    text += fmt::format("{}{}{} from {} to {}{} {}{}",
                        text.empty() ? "Drive " : "; ",
                        drive.name,
                        text.empty() ? " goes" : "",
                        format_short(drive.from),
                        is_to_limit ? "its limit at " : "",
                        format_short(is_to_limit ? drive.reached.value_or(drive.to) : drive.to),
                        drive.unit,
                        is_to_limit ? "" : end_text(motion, drive));
  }
  if (!text.empty()) {
    sentences.push_back(text + ".");
  }
  const auto count = [&](std::string_view kind) {
    return static_cast<int>(std::ranges::count(motion.events, kind, &MotionEvent::kind));
  };
  std::vector<std::string> passed;
  const auto add = [&](int number, const char* noun) {
    if (number > 0) {
      passed.push_back(counted(number, noun));
    }
  };
  add(count(kDeadPointEvent), "dead point");
  add(count(kSingularEvent), "singular position");
  if (!passed.empty()) {
    sentences.push_back(fmt::format("It passes {}.", fmt::join(passed, " and ")));
  }
}

// "The simulation runs to 2.5 s of 5, with 3 impacts."
void add_simulation(const MotionTable& simulation, Sentences& sentences) {
  const DriveTravel& time = simulation.drives.front();
  const auto impacts =
      static_cast<int>(std::ranges::count(simulation.events, "impact", &MotionEvent::kind));
  sentences.push_back(
      fmt::format("The simulation runs to {} {}{}{}.",
                  format_short(*time.reached),
                  time.unit,
                  *time.reached < time.to ? fmt::format(" of {}", format_short(time.to)) : "",
                  impacts > 0 ? fmt::format(", with {}", counted(impacts, "impact")) : ""));
}

}  // namespace

std::vector<std::string> result_sentences(const FilePage& page) {
  Sentences sentences;
  if (page.analysis) {
    add_circulation(*page.analysis, sentences);
    if (page.analysis->shift) {
      add_shift(*page.analysis->shift, sentences);
    }
  }
  if (page.motion) {
    add_motion(page.motion->table, sentences);
  }
  if (page.simulation) {
    add_simulation(page.simulation->rows.table, sentences);
  }
  if (page.synthesis) {
    for (std::string& one : synthesis_sentences(*page.synthesis)) {
      sentences.push_back(std::move(one));
    }
  }
  if (page.transmissions) {
    sentences.push_back(transmission_sentence(*page.transmissions));
  }
  if (page.analysis) {
    add_cases(*page.analysis, page.motion.has_value(), sentences);
  }
  return sentences;
}

std::vector<std::string> count_sentences(const FilePage& page) {
  Sentences sentences;
  if (page.analysis) {
    add_size(page.analysis->mechanism, sentences);
    add_mobility(page.analysis->mobility, sentences);
    const MechanismDescription& description = page.analysis->description;
    for (const std::string& one :
         planet_fit_sentences(find_planet_fits(description), InUnits(description.units))) {
      sentences.push_back(one + ".");
    }
  }
  return sentences;
}

}  // namespace kinestat
