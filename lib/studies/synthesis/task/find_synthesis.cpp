#include "studies/synthesis/task/find_synthesis.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/digit_limits.hpp"
#include "mechanism/bind/bind.hpp"
#include "studies/synthesis/dyads/precise_burmester.hpp"
#include "studies/synthesis/task/synthesis_findings.hpp"
#include "studies/synthesis/task/synthesis_selection.hpp"
#include "studies/synthesis/task/synthesis_task.hpp"
#include "studies/synthesis/task/task_positions.hpp"

namespace kinestat {

namespace {

// With many digits; circuits and branches need no more than a double has.
bool solve_precise_tasks(int digits,
                         const SynthesisValues& values,
                         Diagnostics& found,
                         SynthesisAnalysis& analysis) {
  const TaskPositions<ExactInput> precise(analysis.description);
  const auto tasks = precise.of_tasks({}, found);
  if (!tasks) {
    return false;
  }
  for (const auto& positions : *tasks) {
    SynthesisTask task;
    for (const PositionJetsOf<BigFloat>& position : positions) {
      task.positions.push_back(rounded(position));
    }
    task.dyads =
        solve_burmester_precisely(positions, digits, last_decimal_of(analysis.description));
    task.linkages = rank_linkages(task.dyads->dyads, task.positions, values.limits());
    analysis.tasks.push_back(std::move(task));
  }
  analysis.form = form_of(analysis.tasks.front().positions);
  return true;
}

// The solver for many digits knows five positions, and a search has no typed ones.
bool check_digits(int digits, const MechanismDescription& description, Diagnostics& found) {
  const SynthesisDescription& task = *description.synthesis;
  if (!task.vary.empty()) {
    found.error(
        "E0305",
        task.vary.front().where,
        fmt::format(
            "a selection works with {} digits, and {} are asked for", kDoubleDigits, digits),
        "write what it finds into the file without 'vary', and ask for the digits then");
    return false;
  }
  if (task.function) {
    found.error(
        "E0305",
        task.function->where,
        fmt::format(
            "a function is generated with {} digits, and {} are asked for", kDoubleDigits, digits),
        "leave the digits out");
    return false;
  }
  int count = 0;
  for (const PositionDescription& position : task.positions) {
    count += position.order();
  }
  if (count != 5) {
    found.error(
        "E0305",
        task.where,
        fmt::format("{} digits are for tasks of five positions, and this has {}", digits, count),
        "leave the digits out, or add positions");
    return false;
  }
  return true;
}

bool solve_tasks(const SynthesisValues& values, Diagnostics& found, SynthesisAnalysis& analysis) {
  if (analysis.digits) {
    return check_digits(*analysis.digits, analysis.description, found) &&
           solve_precise_tasks(*analysis.digits, values, found, analysis);
  }
  const auto tasks = values.positions_of_tasks({}, found);
  if (!tasks) {
    return false;
  }
  for (const std::vector<PositionJets>& positions : *tasks) {
    const auto given = values.given_dyads(positions, found);
    if (!given) {
      return false;
    }
    analysis.tasks.push_back(
        solve_task(positions, values.limits(), last_decimal_of(analysis.description), *given));
  }
  analysis.form = form_of(tasks->front());
  return true;
}

// Usable linkages of other kinds than `asked`, in the order of the kinds.
std::vector<LeftOutLinkages> left_out_of(const SynthesisTask& task,
                                         LinkageType asked,
                                         const LinkageLimits& of_any_kind) {
  std::map<LinkageType, int> usable;
  for (const LinkageCandidate& one :
       rank_linkages(task.dyads->dyads, task.positions, of_any_kind)) {
    const LinkageType type = one.linkage.type();
    if (one.is_usable() && type != asked) {
      ++usable[type];
    }
  }
  std::vector<LeftOutLinkages> result;
  for (const auto& [type, count] : usable) {
    result.push_back({.type = type, .usable = count});
  }
  return result;
}

// What a file that asks for one kind of linkage would not hear of.
void add_left_out(SynthesisAnalysis& analysis) {
  const std::optional<LinkageType> asked = analysis.limits.type;
  LinkageLimits of_any_kind = analysis.limits;
  of_any_kind.type = std::nullopt;
  for (SynthesisTask& task : analysis.tasks) {
    if (asked && task.dyads) {
      task.left_out = left_out_of(task, *asked, of_any_kind);
    }
  }
}

// Of the answers of one task: the fewest.
double digits_left(const SynthesisTask& task) {
  double digits = kDoubleDigits;
  if (task.curves && task.curves->status != BurmesterStatus::family) {
    digits = task.curves->status == BurmesterStatus::no_digits ? 0.0 : task.curves->digits;
  }
  if (task.dyads && task.dyads->status != BurmesterStatus::family) {
    digits = task.dyads->status == BurmesterStatus::no_digits ? 0.0 : task.dyads->digits;
    for (const Dyad& dyad : task.dyads->dyads) {
      digits = std::min(digits, dyad.digits);
    }
  }
  return digits;
}

void warn_of_few_digits(const SynthesisAnalysis& analysis, Diagnostics& found) {
  constexpr double kFew = 3.0;
  double digits = kDoubleDigits;
  for (const SynthesisTask& task : analysis.tasks) {
    digits = std::min(digits, digits_left(task));
  }
  if (digits >= kFew) {
    return;
  }
  const bool may_have_more = position_count(analysis.tasks.front().positions) == 5 &&
                             analysis.description.synthesis->vary.empty();
  const std::string_view hint =
      analysis.digits ? "write the positions with more digits, and raise --digits"
      : may_have_more ? "write the positions with more digits and run with --digits 40, or give "
                        "derivatives instead of positions that close in"
                      : "give derivatives instead of positions that close in";
  found.warning("W0801",
                analysis.description.synthesis->where,
                fmt::format("of {} digits the positions leave {:.0f}",
                            analysis.digits.value_or(kDoubleDigits),
                            std::floor(digits)),
                std::string(hint));
}

// Whether every choice of angles has the dyads that the file gives.
bool check_given_dyads(const SynthesisValues& values,
                       const std::optional<std::vector<std::vector<PositionJets>>>& tasks,
                       Diagnostics& found) {
  return tasks && std::ranges::all_of(*tasks, [&](const std::vector<PositionJets>& positions) {
           return values.given_dyads(positions, found).has_value();
         });
}

}  // namespace

std::optional<SynthesisAnalysis> find_synthesis(const std::string& path,
                                                MechanismDescription description,
                                                const SynthesisOptions& options,
                                                Diagnostics& found) {
  if (!check(description, found)) {
    return std::nullopt;
  }
  if (!description.synthesis) {
    found.error("E0303",
                {},
                "the file has no section 'synthesis'",
                "'kinestat new synthesis' writes an example");
    return std::nullopt;
  }
  if (description.synthesis->transmission) {
    found.error("E0303",
                description.synthesis->where,
                "the section 'synthesis' asks for transmissions, not for linkages",
                "'kinestat new synthesis' writes an example");
    return std::nullopt;
  }
  SynthesisAnalysis analysis;
  analysis.file = path;
  analysis.description = std::move(description);
  const SynthesisValues values(analysis.description);
  analysis.digits = options.digits ? options.digits : values.digits();
  analysis.limits = values.limits();
  const bool selects = !analysis.description.synthesis->vary.empty() && !analysis.digits;
  const bool is_right = selects ? select_tasks(values, options.jobs, found, analysis)
                                : solve_tasks(values, found, analysis);
  if (!is_right) {
    return std::nullopt;
  }
  add_left_out(analysis);
  analysis.curve_count = values.curve_count().value_or(analysis.curve_count);
  warn_of_few_digits(analysis, found);
  warn_of_degenerate_best(analysis, found);
  add_usability_findings(analysis, found);
  return analysis;
}

bool check_synthesis_task(const MechanismDescription& description, Diagnostics& found) {
  const SynthesisValues values(description);
  if (const auto digits = values.digits()) {
    return check_digits(*digits, description, found) &&
           TaskPositions<ExactInput>(description).of_tasks({}, found).has_value();
  }
  return check_given_dyads(values,
                           description.synthesis->vary.empty()
                               ? values.positions_of_tasks({}, found)
                               : find_selection_tasks(values, *description.synthesis, found),
                           found);
}

}  // namespace kinestat
