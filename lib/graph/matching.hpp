// Pairs between two sides, each member in one pair at most.
#pragma once

#include <optional>
#include <vector>

namespace kinestat {

/// For every demand the offers that may serve it, the preferred first.
using Offers = std::vector<std::vector<int>>;

/// For every demand the offer that serves it; as many demands as possible are served, and of
/// equally many the earlier ones. An offer serves one demand (augmenting paths, Kuhn 1955).
std::vector<std::optional<int>> find_matching(const Offers& offers, int offer_count);

}  // namespace kinestat
