#include "sensitivity/dual_solution.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graph/cutsets.hpp"

namespace kinestat {

namespace {

// Rows of coefficients, the right-hand side last.
using Rows = std::vector<std::vector<Dual>>;

// Complete pivoting; surplus rows are left over.
std::vector<Dual> solve(Rows rows, std::size_t unknowns) {
  std::vector<std::size_t> pivot_of(unknowns);
  std::vector<bool> is_done(unknowns, false);
  for (std::size_t step = 0; step < unknowns; ++step) {
    std::size_t best_row = step;
    std::size_t best_column = 0;
    double best = 0.0;
    for (std::size_t r = step; r < rows.size(); ++r) {
      for (std::size_t c = 0; c < unknowns; ++c) {
        if (!is_done[c] && std::abs(rows[r][c].value) > best) {
          best = std::abs(rows[r][c].value);
          best_row = r;
          best_column = c;
        }
      }
    }
    if (best < 1e-9) {
      throw std::runtime_error("the case does not determine its unknowns");
    }
    std::swap(rows[step], rows[best_row]);
    is_done[best_column] = true;
    pivot_of[best_column] = step;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r != step) {
        const Dual factor = rows[r][best_column] / rows[step][best_column];
        for (std::size_t c = 0; c <= unknowns; ++c) {
          rows[r][c] = rows[r][c] - factor * rows[step][c];
        }
      }
    }
  }
  std::vector<Dual> x;
  for (std::size_t c = 0; c < unknowns; ++c) {
    x.push_back(rows[pivot_of[c]][unknowns] / rows[pivot_of[c]][c]);
  }
  return x;
}

// The equation x[index] = value.
void fix(std::size_t index, const Dual& value, std::size_t unknowns, Rows& rows) {
  rows.emplace_back(unknowns + 1);
  rows.back()[index] = Dual(1.0);
  rows.back()[unknowns] = value;
}

// Rows of the network matrix: for each circuit or cut-set six, with the screws of its couplings.
template <class Screws, class Labels>
Rows network_rows(const MatXi& signs,
                  const std::vector<int>& columns,
                  const Screws& screws,
                  const Labels& labels) {
  Rows rows;
  for (Eigen::Index i = 0; i < signs.rows(); ++i) {
    for (int coordinate = 0; coordinate < 6; ++coordinate) {
      rows.emplace_back(screws.size() + 1);
      for (std::size_t s = 0; s < screws.size(); ++s) {
        const auto column = std::ranges::find(columns, labels[s].coupling.value) - columns.begin();
        rows.back()[s] = Dual(signs(i, column)) * screws[s].coordinates()[coordinate];
      }
    }
  }
  return rows;
}

}  // namespace

std::vector<Dual> dual_rates(const Mechanism& mechanism, const MechanismDerivatives& derivatives) {
  const auto& screws = derivatives.geometry.motions;
  Rows rows = network_rows(circuit_matrix(cutset_matrix(mechanism.graph)),
                           mechanism.graph.columns,
                           screws,
                           mechanism.topology.freedoms);
  const Case& which = mechanism.cases.front();
  for (std::size_t i = 0; i < which.motions.size(); ++i) {
    fix(static_cast<std::size_t>(which.motions[i].index),
        derivatives.cases.front().motions[i],
        screws.size(),
        rows);
  }
  return solve(std::move(rows), screws.size());
}

std::vector<Dual> dual_actions(const Mechanism& mechanism,
                               const MechanismDerivatives& derivatives) {
  const auto& screws = derivatives.geometry.actions;
  Rows rows = network_rows(
      cutset_matrix(mechanism.graph), mechanism.graph.columns, screws, mechanism.topology.actions);
  const Case& which = mechanism.cases.front();
  for (std::size_t i = 0; i < which.actions.size(); ++i) {
    fix(static_cast<std::size_t>(which.actions[i].index),
        derivatives.cases.front().actions[i],
        screws.size(),
        rows);
  }
  return solve(std::move(rows), screws.size());
}

}  // namespace kinestat
