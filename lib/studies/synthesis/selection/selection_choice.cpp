#include "studies/synthesis/selection/selection_choice.hpp"

#include <utility>

namespace kinestat {

CandidateMaker candidates_of(const TaskMaker& make_task, const LinkageLimits& limits) {
  return [make_task, limits](std::span<const double> choice) -> std::optional<LinkageCandidate> {
    const auto positions = make_task(choice);
    if (!positions) {
      return std::nullopt;
    }
    const BurmesterSolution solution = solve_burmester(*positions);
    std::vector<LinkageCandidate> found = rank_linkages(solution.dyads, *positions, limits);
    return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
  };
}

std::string_view word_of(Missing missing) {
  switch (missing) {
    case Missing::motion:
      return "contradiction";
    case Missing::dyads:
      return "dyads";
    case Missing::kind:
      return "kind";
  }
  return "";
}

ShortfallFinder shortfalls_of(const TaskMaker& make_task) {
  return [make_task](std::span<const double> choice) -> Shortfall {
    const auto positions = make_task(choice);
    if (!positions) {
      return {.missing = Missing::motion};
    }
    const BurmesterSolution solution = solve_burmester(*positions);
    if (solution.dyads.size() >= 2) {
      return {.missing = Missing::kind};
    }
    return {.missing = Missing::dyads,
            .residual = solution.nearest ? solution.nearest->residual : 0.0};
  };
}

}  // namespace kinestat
