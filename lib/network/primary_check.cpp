#include "network/primary_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/rank.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kMostCompletions = 5;
constexpr int kMostTries = 2000;

// One row a magnitude, one column a motion (or self-stress) that is still possible.
MatX possible(const Elimination& elimination, int first_column, int count) {
  const std::vector<VecX> vectors = elimination.null_vectors();
  MatX result(count, static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t j = 0; j < vectors.size(); ++j) {
    const VecX part = vectors[j].segment(first_column, count);
    const double largest = part.size() == 0 ? 0.0 : part.cwiseAbs().maxCoeff();
    result.col(static_cast<Eigen::Index>(j)) =
        (part.array().abs() <= kRankZero * largest).select(0.0, part);
  }
  return result;
}

// The next ascending choice of chosen.size() out of `count`; false after the last one.
bool advance(std::vector<int>& chosen, int count) {
  const int size = static_cast<int>(chosen.size());
  for (int i = size - 1; i >= 0; --i) {
    int& item = chosen[static_cast<std::size_t>(i)];
    if (item < count - size + i) {
      ++item;
      for (int j = i + 1; j < size; ++j) {
        chosen[static_cast<std::size_t>(j)] = chosen[static_cast<std::size_t>(j - 1)] + 1;
      }
      return true;
    }
  }
  return false;
}

// A choice completes the primaries iff its rows of the possible motions are independent.
std::vector<std::vector<int>> find_completions(const MatX& motions,
                                               const std::vector<int>& candidates) {
  std::vector<std::vector<int>> found;
  const auto size = static_cast<std::size_t>(motions.cols());
  std::vector<int> chosen(size);
  for (std::size_t i = 0; i < size; ++i) {
    chosen[i] = static_cast<int>(i);
  }
  const int count = static_cast<int>(candidates.size());
  for (int tries = 0; tries < kMostTries && found.size() < kMostCompletions; ++tries) {
    std::vector<int> rows;
    for (const int i : chosen) {
      rows.push_back(candidates[static_cast<std::size_t>(i)]);
    }
    if (find_rank(motions(rows, Eigen::all)).rank == motions.cols()) {
      found.push_back(rows);
    }
    if (!advance(chosen, count)) {
      break;
    }
  }
  return found;
}

}  // namespace

PrimaryCheck check_primaries(const Elimination& elimination, int first_column, int count) {
  PrimaryCheck check;
  for (const Relation& relation : elimination.relations()) {
    std::vector<DependenceTerm> terms;
    for (const SparseEntry& term : relation.terms) {
      terms.push_back({.index = term.column - first_column, .coefficient = term.value});
    }
    check.dependences.push_back(std::move(terms));
  }
  check.missing = static_cast<int>(elimination.free_columns().size());
  if (check.missing == 0) {
    return check;
  }
  const MatX motions = possible(elimination, first_column, count);
  for (int i = 0; i < count; ++i) {
    if (!motions.row(i).isZero(0.0)) {
      check.undetermined.push_back(i);
    }
  }
  check.completions = find_completions(motions, check.undetermined);
  return check;
}

}  // namespace kinestat
