#include "studies/sensitivity/internal/adjoint_side.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/contract.hpp"

namespace kinestat {

AdjointSide::AdjointSide(FactoredSide equations,
                         ParameterChanges changes,
                         std::optional<Compatibility> compatibility)
    : equations_(std::move(equations)),
      changes_(std::move(changes)),
      compatibility_(std::move(compatibility)) {
  changes_.is_possible.resize(changes_.total.size(), true);
  for (std::size_t p = 0; p < changes_.total.size(); ++p) {
    changes_.is_possible[p] = changes_.is_possible[p] && equations_.allows(changes_.total[p]);
  }
}

void AdjointSide::add(const std::vector<double>& slopes,
                      std::vector<std::optional<Sum>>& result) const {
  const VecX shares = compatibility_ ? compatibility_->shares(slopes) : VecX();
  const AdjointSolution adjoint =
      equations_.solve_adjoint(compatibility_ ? compatibility_->remaining(slopes, shares) : slopes);
  for (std::size_t p = 0; p < result.size(); ++p) {
    const bool fits = !compatibility_ || compatibility_->allows(shares, p);
    if (!is_possible(p) || !fits || shows_open(adjoint, p)) {
      result[p] = std::nullopt;
    } else if (result[p]) {
      kinestat::add(adjoint, changes_.total[p], *result[p]);
      if (compatibility_) {
        compatibility_->add(shares, p, *result[p]);
      }
    }
  }
}

std::optional<std::vector<double>> AdjointSide::slopes_of(std::size_t parameter) const {
  KINESTAT_EXPECTS(!compatibility_);
  return is_possible(parameter) ? std::optional(equations_.solve(changes_.total[parameter]))
                                : std::nullopt;
}

bool AdjointSide::shows_open(const AdjointSolution& adjoint, std::size_t parameter) const {
  const auto first = static_cast<std::ptrdiff_t>(changes_.completed_count);
  return std::any_of(
      changes_.by_open.begin() + first,
      changes_.by_open.end(),
      [&](const std::vector<Change>& one) { return moves(adjoint, one[parameter]); });
}

}  // namespace kinestat
