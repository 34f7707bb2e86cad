#include "network/primary_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/elimination/rank.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kMostProposals = 5;

// Beyond this many missing times candidates, a hint is not worth the search.
constexpr std::size_t kLongestSearch = 40000;

// Beyond this many numbers the motions are mixed: names of what is open are all that is asked of
// them then.
constexpr std::size_t kMostNumbers = 1000000;

// One row a magnitude, one column a motion (or self-stress) that is still possible; where these are
// very many, one column alone.
MatX possible(const Elimination& elimination, const InexactBlocks& blocks, int count) {
  const std::size_t size = elimination.free_columns().size() * static_cast<std::size_t>(count);
  const std::vector<VecX> vectors =
      size > kMostNumbers ? std::vector<VecX>{settled_null_mixture(elimination, blocks)}
                          : settled_null_vectors(elimination, blocks);
  MatX result(count, static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t j = 0; j < vectors.size(); ++j) {
    result.col(static_cast<Eigen::Index>(j)) = vectors[j].segment(blocks.first_column, count);
  }
  return result;
}

// Without the entries that are too small beside the largest to build a choice on.
MatX clear_part(const MatX& motions) {
  MatX result = motions;
  for (Eigen::Index j = 0; j < result.cols(); ++j) {
    const VecX column = result.col(j);
    const double largest = column.size() == 0 ? 0.0 : column.cwiseAbs().maxCoeff();
    result.col(j) = (column.array().abs() <= kRankZero * largest).select(0.0, column);
  }
  return result;
}

std::vector<int> rows_in_use(const MatX& motions) {
  std::vector<int> rows;
  for (int i = 0; i < static_cast<int>(motions.rows()); ++i) {
    if (!motions.row(i).isZero(0.0)) {
      rows.push_back(i);
    }
  }
  return rows;
}

// Searches the choices whose rows are a basis, in the order of the candidates. A beginning is kept
// only if its rows are independent and the candidates after it can still complete it, so that no
// beginning is searched in vain.
class BasisSearch {
 public:
  BasisSearch(const MatX& rows, const std::vector<int>& candidates)
      : rows_(rows), candidates_(candidates) {}

  std::vector<std::vector<int>> run() {
    extend(0);
    return std::move(found_);
  }

 private:
  int rank_of(const std::vector<int>& rows) const {
    return find_rank(rows_(rows, Eigen::all)).rank;
  }

  bool can_be_completed(std::size_t next) const {
    std::vector<int> rows = chosen_;
    rows.insert(
        rows.end(), candidates_.begin() + static_cast<std::ptrdiff_t>(next), candidates_.end());
    return rank_of(rows) == rows_.cols();
  }

  void extend(std::size_t next) {
    if (static_cast<Eigen::Index>(chosen_.size()) == rows_.cols()) {
      found_.push_back(chosen_);
      return;
    }
    for (; found_.size() < kMostProposals && can_be_completed(next); ++next) {
      chosen_.push_back(candidates_[next]);
      if (rank_of(chosen_) == static_cast<int>(chosen_.size())) {
        extend(next + 1);
      }
      chosen_.pop_back();
    }
  }

  const MatX& rows_;
  const std::vector<int>& candidates_;
  std::vector<int> chosen_;
  std::vector<std::vector<int>> found_;
};

// Those that actuators drive first.
std::vector<int> driven_first(std::vector<int> magnitudes, std::span<const int> driven) {
  std::stable_partition(magnitudes.begin(), magnitudes.end(), [&](int m) {
    return std::ranges::find(driven, m) != driven.end();
  });
  return magnitudes;
}

// Sets, one magnitude a relation, in whose columns the relations are independent: each of the set
// follows from the rest. A relation without terms is about loads alone.
std::vector<std::vector<int>> find_removals(const std::vector<Dependence>& dependences,
                                            std::span<const double> units,
                                            std::span<const int> driven) {
  std::vector<std::vector<int>> removals;
  MatX shares = MatX::Zero(static_cast<Eigen::Index>(units.size()), 0);
  for (const Dependence& one : dependences) {
    if (one.terms.empty()) {
      continue;
    }
    shares.conservativeResize(Eigen::NoChange, shares.cols() + 1);
    shares.col(shares.cols() - 1).setZero();
    for (const DependenceTerm& term : one.terms) {
      shares(term.index, shares.cols() - 1) =
          term.coefficient * units[static_cast<std::size_t>(term.index)];
    }
  }
  if (shares.cols() == 0) {
    return removals;
  }
  const std::vector<int> involved = rows_in_use(shares);
  if (shares.cols() == 1) {
    for (const int magnitude : involved) {
      removals.push_back({magnitude});
    }
    return removals;
  }
  const std::size_t search = static_cast<std::size_t>(shares.cols()) * involved.size();
  if (search > kLongestSearch) {
    return removals;
  }
  std::vector<int> candidates = driven_first(involved, driven);
  std::ranges::reverse(candidates);
  removals = BasisSearch(shares, candidates).run();
  for (std::vector<int>& set : removals) {
    std::ranges::sort(set);
  }
  return removals;
}

}  // namespace

PrimaryCheck check_primaries(const Elimination& elimination,
                             const InexactBlocks& blocks,
                             std::span<const double> units,
                             std::span<const double> rhs,
                             std::span<const int> driven) {
  PrimaryCheck check;
  const int count = static_cast<int>(units.size());
  for (const Relation& relation : elimination.relations(rhs)) {
    Dependence dependence{.terms = {},
                          .equations = relation.equations,
                          .constant = relation.constant,
                          .constant_size = relation.constant_size};
    for (const SparseEntry& term : relation.terms) {
      const int index = term.column - blocks.first_column;
      dependence.terms.push_back(
          {.index = index, .coefficient = term.value / units[static_cast<std::size_t>(index)]});
    }
    check.dependences.push_back(std::move(dependence));
  }
  check.removals = find_removals(check.dependences, units, driven);
  check.missing = static_cast<int>(elimination.free_columns().size());
  if (check.missing == 0) {
    return check;
  }
  const MatX motions = possible(elimination, blocks, count);
  const MatX clear = clear_part(motions);
  check.undetermined = rows_in_use(motions);
  check.candidates = rows_in_use(clear);
  const std::size_t search = static_cast<std::size_t>(check.missing) * check.candidates.size();
  if (clear.cols() == check.missing && search <= kLongestSearch) {
    check.completions = BasisSearch(clear, driven_first(check.candidates, driven)).run();
  }
  return check;
}

}  // namespace kinestat
