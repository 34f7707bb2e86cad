// The best linkages of a synthesis side by side, each through its positions.
#pragma once

#include <cstddef>
#include <vector>

#include "draw/picture.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// A linkage by its task and its number there.
struct LinkagePlace {
  std::size_t task = 0;
  std::size_t number = 0;
};

/// Of all tasks the usable linkages, the best first, kBestLinkages at most: of a selection the best
/// one of each choice. Without a usable one that which comes nearest; empty without a linkage.
std::vector<LinkagePlace> find_best_linkages(const SynthesisAnalysis& analysis);

/// Each to a scale of its own: the first position drawn out, the others faint, with the path of the
/// origin of the moving frame over the circuit as far as it stays near, and what is known of it.
Picture draw_best_linkages(const SynthesisAnalysis& analysis);

}  // namespace kinestat
