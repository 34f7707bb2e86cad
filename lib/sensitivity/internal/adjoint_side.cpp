#include "sensitivity/internal/adjoint_side.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/tolerance.hpp"

namespace kinestat {

AdjointSide::AdjointSide(FactoredSide equations, ParameterChanges changes)
    : equations_(std::move(equations)), changes_(std::move(changes)) {
  changes_.is_possible.resize(changes_.total.size(), true);
  for (std::size_t p = 0; p < changes_.total.size(); ++p) {
    changes_.is_possible[p] = changes_.is_possible[p] && equations_.allows(changes_.total[p]);
  }
}

void AdjointSide::add(const std::vector<double>& slopes,
                      std::vector<std::optional<Sum>>& result) const {
  const AdjointSolution adjoint = equations_.solve_adjoint(slopes);
  for (std::size_t p = 0; p < result.size(); ++p) {
    if (!is_possible(p) || shows_open(adjoint, p)) {
      result[p] = std::nullopt;
    } else if (result[p]) {
      kinestat::add(adjoint, changes_.total[p], *result[p]);
    }
  }
}

std::optional<std::vector<double>> AdjointSide::slopes_of(std::size_t parameter) const {
  return is_possible(parameter) ? std::optional(equations_.solve(changes_.total[parameter]))
                                : std::nullopt;
}

bool AdjointSide::shows_open(const AdjointSolution& adjoint, std::size_t parameter) const {
  return std::ranges::any_of(changes_.by_open, [&](const std::vector<Change>& one) {
    return moves(adjoint, one[parameter]);
  });
}

}  // namespace kinestat
