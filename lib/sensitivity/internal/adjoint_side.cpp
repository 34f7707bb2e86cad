#include "sensitivity/internal/adjoint_side.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/tolerance.hpp"

namespace kinestat {

AdjointSide::AdjointSide(FactoredSide equations, ParameterChanges changes)
    : equations_(std::move(equations)), changes_(std::move(changes)) {
  for (const Change& change : changes_.total) {
    is_possible_.push_back(equations_.allows(change));
  }
}

void AdjointSide::add(const std::vector<double>& slopes,
                      std::vector<std::optional<Sum>>& result) const {
  const AdjointSolution adjoint = equations_.solve_adjoint(slopes);
  for (std::size_t p = 0; p < result.size(); ++p) {
    if (!is_possible_[p] || shows_open(adjoint, p)) {
      result[p] = std::nullopt;
    } else if (result[p]) {
      kinestat::add(adjoint, changes_.total[p], *result[p]);
    }
  }
}

bool AdjointSide::shows_open(const AdjointSolution& adjoint, std::size_t parameter) const {
  return std::ranges::any_of(changes_.open, [&](const std::vector<Change>& one) {
    return moves(adjoint, one[parameter]);
  });
}

}  // namespace kinestat
