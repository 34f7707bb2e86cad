#include "studies/sweep/task/row_status.hpp"

#include <algorithm>

#include "cases/case_efficiency.hpp"
#include "cases/case_status.hpp"

namespace kinestat {

namespace {

// Known magnitudes that no longer fit where they usually do: the position is to blame.
std::string_view status_word(SolveStatus status, bool is_usually_solved) {
  const bool is_of_choice = status == SolveStatus::dependent ||
                            status == SolveStatus::underdetermined ||
                            status == SolveStatus::inconsistent;
  return is_usually_solved && is_of_choice ? kSingular : word_of(status);
}

bool has_solved_motion(const CaseAnalysis& one) {
  return one.motion && one.motion->status == SolveStatus::solved;
}

// Of a case whose ratio is asked for and has no value.
std::string_view ratio_status(const CaseAnalysis& one, const Topology& topology) {
  if (!has_solved_motion(one) || one.which.inputs.empty()) {
    return "solved";
  }
  const bool is_input_at_rest = std::ranges::all_of(one.which.inputs, [&](int input) {
    const auto freedom =
        static_cast<std::size_t>(topology.actuators[static_cast<std::size_t>(input)].freedom);
    return one.motion->rates[freedom] == 0.0;
  });
  return status_without_ratio(is_input_at_rest);
}

}  // namespace

std::string_view status_without_ratio(bool is_input_at_rest) {
  return is_input_at_rest ? kLocked : kNoRatio;
}

std::string_view row_status(const CaseAnalysis& one,
                            const SweepTask& task,
                            const Mechanism& mechanism,
                            bool is_usually_solved) {
  if (one.motion && one.motion->status != SolveStatus::solved) {
    return one.motion->status == SolveStatus::dependent && one.motion->counts.net_freedom <= 0
               ? kLocked
               : status_word(one.motion->status, is_usually_solved);
  }
  const bool has_actions = !one.action || one.action->status == SolveStatus::solved;
  if (!has_actions && is_usually_solved) {
    return status_word(one.action->status, is_usually_solved);
  }
  const std::string_view word = case_status(mechanism, one, asks_power(task.columns));
  if (word != word_of(SolveStatus::solved)) {
    return word;
  }
  if (asks(task.columns, SweepColumnKind::ratio) && one.ratios && !one.ratios->ratio) {
    return ratio_status(one, mechanism.topology);
  }
  if (asks(task.columns, SweepColumnKind::efficiency) && lacks_efficiency(one, mechanism)) {
    return kNoEfficiency;
  }
  const bool has_idle_rate = std::ranges::any_of(task.columns, [&one](const SweepColumn& column) {
    return column.kind == SweepColumnKind::rate && one.motion &&
           !one.motion->knows_rate(column.index);
  });
  return has_idle_rate ? kNoNumber : "solved";
}

}  // namespace kinestat
