// What a choice of the free numbers of a selection gives: a linkage, or what is missing for one.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "studies/synthesis/synthesis.hpp"

namespace kinestat {

/// The best linkage for a choice of the free numbers, one a range; empty where there is none. It is
/// asked from several threads at once.
using CandidateMaker = std::function<std::optional<LinkageCandidate>(std::span<const double>)>;

/// The positions for a choice of the free numbers; empty where there is no such motion.
using TaskMaker =
    std::function<std::optional<std::vector<PositionJets>>(std::span<const double> choice)>;

/// Five positions a task: the best pair of their dyads.
CandidateMaker candidates_of(const TaskMaker& make_task, const LinkageLimits& limits);

/// Why a choice has no linkage, worst first.
enum class Missing {
  motion,  ///< its positions contradict themselves
  dyads,   ///< fewer than two real dyads stand alone
  kind     ///< its dyads make linkages of other kinds than the limits ask for
};

inline constexpr std::size_t kMissingCount = static_cast<std::size_t>(Missing::kind) + 1;

/// The word in reports.
std::string_view word_of(Missing missing);

struct Shortfall {
  Missing missing = Missing::dyads;
  double residual = 0.0;  ///< of what comes nearest to a real dyad
};

/// What a choice without a linkage misses.
using ShortfallFinder = std::function<Shortfall(std::span<const double>)>;

/// Five positions a task.
ShortfallFinder shortfalls_of(const TaskMaker& make_task);

}  // namespace kinestat
