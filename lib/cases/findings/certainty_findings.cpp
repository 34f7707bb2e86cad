#include "cases/findings/certainty_findings.hpp"

#include <string>

#include <fmt/format.h>

#include "cases/exact_input_cases.hpp"

namespace kinestat {

namespace {

// Of the largest number, in the scaled equations.
std::string dropped_text(double dropped) {
  return dropped > 0.0 ? fmt::format("{:.2g} of the largest number", dropped) : "lost in rounding";
}

// Of the scaled equations, where their singular values are known.
std::string deciding_text(const RankCertainty& certainty) {
  if (!certainty.deciding) {
    return dropped_text(certainty.dropped);
  }
  return *certainty.deciding > 0.0
             ? fmt::format("a singular value of {:.2g} of the largest", *certainty.deciding)
             : "lost in rounding";
}

// Both answers, where rounding to double decides.
void add_rank_finding(const std::optional<RankCertainty>& certainty,
                      std::string_view what,
                      Diagnostics& found) {
  if (!certainty || !certainty->differs()) {
    return;
  }
  const int rank = certainty->rank;
  const int exact_input = certainty->exact_input->rank;
  found.warning(
      "W0501",
      {},
      fmt::format("the {} have rank {} as typed and {} once rounded to double: {} as typed, {} "
                  "once rounded; what decides is {}",
                  what,
                  exact_input,
                  rank,
                  exact_input > rank ? "regular" : "redundant",
                  exact_input > rank ? "redundant" : "regular",
                  deciding_text(*certainty)),
      exact_input > rank
          ? "the position is close to a singular one, or coordinates were rounded before "
            "they were typed: write expressions; '--accuracy exact' solves what is typed"
          : "the counts are those as typed; '--accuracy exact' solves what is typed, too");
}

// A case that only the numbers as typed answer.
void add_exact_input_answers(const CaseAnalysis& one,
                             const CaseCertainty& certainty,
                             bool is_taken,
                             Diagnostics& found) {
  const auto add = [&](bool is_new, std::string_view what, double dropped) {
    if (is_new) {
      found.warning("W0501",
                    one.which.where,
                    fmt::format("case '{}' has its {} as typed and none once rounded to double: "
                                "regular as typed, singular once rounded; what decides is {}",
                                one.which.label,
                                what,
                                dropped_text(dropped)),
                    is_taken ? "the report has the answer as typed; the position is close to a "
                               "singular one"
                             : "'--accuracy exact' gives the answer as typed; the position is "
                               "close to a singular one");
    }
  };
  add(certainty.has_exact_input_motion,
      "velocities",
      one.motion ? one.motion->evidence.largest_dropped : 0.0);
  add(certainty.has_exact_input_action,
      "actions",
      one.action ? one.action->evidence.largest_dropped : 0.0);
}

// Whether the values of a solved case are as sure as was asked for, where that can be known.
void add_missing_digits(int digits,
                        const CaseAnalysis& one,
                        const AnswerEvidence& answer,
                        std::string_view what,
                        Diagnostics& found) {
  if (!answer.error_bound || reaches(answer, digits)) {
    return;
  }
  found.warning("W0502",
                one.which.where,
                fmt::format("case '{}': the worst of its {} may be wrong by {:.2g} of its "
                            "magnitude, where {} digits were requested",
                            one.which.label,
                            what,
                            *answer.error_bound,
                            digits),
                answer.precision == Precision::exact
                    ? "a double holds no more; ask for fewer --digits"
                    : "add --accuracy exact, or ask for fewer --digits");
}

void add_digit_findings(int digits, const CaseAnalysis& one, Diagnostics& found) {
  if (one.motion && one.motion->status == SolveStatus::solved) {
    add_missing_digits(digits, one, one.motion->answer, "velocities", found);
  }
  if (one.action && !one.action->magnitudes.empty()) {
    add_missing_digits(digits, one, one.action->answer, "actions", found);
  }
}

}  // namespace

void add_rank_findings(const Certainty& certainty, Diagnostics& found) {
  add_rank_finding(certainty.motion_rank, "motions", found);
  add_rank_finding(certainty.action_rank, "actions", found);
}

void add_certainty_findings(const Analysis& analysis,
                            const Certainty& certainty,
                            Diagnostics& found) {
  add_rank_findings(certainty, found);
  const bool is_taken = certainty.accuracy.accuracy == Accuracy::exact;
  for (std::size_t c = 0; c < analysis.cases.size(); ++c) {
    add_exact_input_answers(analysis.cases[c], certainty.cases[c], is_taken, found);
    add_digit_findings(certainty.accuracy.digits, analysis.cases[c], found);
  }
}

}  // namespace kinestat
