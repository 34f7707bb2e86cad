#include "studies/shift/report/non_gear_states.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace kinestat {

namespace {

// Beyond so many nobody reads their reasons, and of more than a few the first of each class tell
// how it goes.
constexpr std::size_t kMostStates = 40;
constexpr std::size_t kFewStates = 12;
constexpr std::size_t kFirstOfClass = 4;

}  // namespace

std::vector<std::size_t> shown_others(const ShiftSolution& solution,
                                      std::size_t gears,
                                      ShownOthers shown) {
  const std::size_t all = solution.states.size() - gears;
  const std::size_t of_class =
      shown == ShownOthers::all || all <= kFewStates ? kMostStates : kFirstOfClass;
  std::map<ShiftClass, std::size_t> counts;
  std::vector<std::size_t> states;
  for (std::size_t s = gears; s < solution.states.size(); ++s) {
    if (states.size() < kMostStates && counts[solution.states[s].state.kind]++ < of_class) {
      states.push_back(s);
    }
  }
  return states;
}

std::string rest_of_others_text(const ShiftSolution& solution,
                                std::size_t gears,
                                const std::vector<std::size_t>& shown) {
  std::map<ShiftClass, std::size_t> rest;
  for (std::size_t s = gears; s < solution.states.size(); ++s) {
    if (!std::ranges::binary_search(shown, s)) {
      ++rest[solution.states[s].state.kind];
    }
  }
  std::vector<std::string> parts;
  for (const auto& [kind, count] : rest) {
    parts.push_back(fmt::format("{} more {}", count, word_of(kind)));
  }
  return parts.empty()
             ? ""
             : fmt::format("  and {}, which --format csv lists\n", fmt::join(parts, ", "));
}

}  // namespace kinestat
