#include "network/primary_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/rank.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kMostCompletions = 5;

// Beyond this many missing times candidates, a hint is not worth the search.
constexpr std::size_t kLongestSearch = 40000;

// One row a magnitude, one column a motion (or self-stress) that is still possible.
MatX possible(const Elimination& elimination, int first_column, int count) {
  const std::vector<VecX> vectors = elimination.null_vectors();
  MatX result(count, static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t j = 0; j < vectors.size(); ++j) {
    result.col(static_cast<Eigen::Index>(j)) = vectors[j].segment(first_column, count);
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

// Searches the choices that complete the primaries, those whose rows of the possible motions are a
// basis, in lexicographic order. A beginning is kept only if its rows are independent and the
// candidates after it can still complete it, so that no beginning is searched in vain.
class CompletionSearch {
 public:
  CompletionSearch(const MatX& motions, const std::vector<int>& candidates)
      : motions_(motions), candidates_(candidates) {}

  std::vector<std::vector<int>> run() {
    extend(0);
    return std::move(found_);
  }

 private:
  int rank_of(const std::vector<int>& rows) const {
    return find_rank(motions_(rows, Eigen::all)).rank;
  }

  bool can_be_completed(std::size_t next) const {
    std::vector<int> rows = chosen_;
    rows.insert(
        rows.end(), candidates_.begin() + static_cast<std::ptrdiff_t>(next), candidates_.end());
    return rank_of(rows) == motions_.cols();
  }

  void extend(std::size_t next) {
    if (static_cast<Eigen::Index>(chosen_.size()) == motions_.cols()) {
      found_.push_back(chosen_);
      return;
    }
    for (; found_.size() < kMostCompletions && can_be_completed(next); ++next) {
      chosen_.push_back(candidates_[next]);
      if (rank_of(chosen_) == static_cast<int>(chosen_.size())) {
        extend(next + 1);
      }
      chosen_.pop_back();
    }
  }

  const MatX& motions_;
  const std::vector<int>& candidates_;
  std::vector<int> chosen_;
  std::vector<std::vector<int>> found_;
};

}  // namespace

PrimaryCheck check_primaries(const Elimination& elimination,
                             int first_column,
                             std::span<const double> units,
                             std::span<const double> rhs) {
  PrimaryCheck check;
  const int count = static_cast<int>(units.size());
  for (const Relation& relation : elimination.relations(rhs)) {
    Dependence dependence{.terms = {},
                          .equations = relation.equations,
                          .constant = relation.constant,
                          .constant_size = relation.constant_size};
    for (const SparseEntry& term : relation.terms) {
      const int index = term.column - first_column;
      dependence.terms.push_back(
          {.index = index, .coefficient = term.value / units[static_cast<std::size_t>(index)]});
    }
    check.dependences.push_back(std::move(dependence));
  }
  check.missing = static_cast<int>(elimination.free_columns().size());
  if (check.missing == 0) {
    return check;
  }
  const MatX motions = possible(elimination, first_column, count);
  const MatX clear = clear_part(motions);
  check.undetermined = rows_in_use(motions);
  check.candidates = rows_in_use(clear);
  if (static_cast<std::size_t>(check.missing) * check.candidates.size() <= kLongestSearch) {
    check.completions = CompletionSearch(clear, check.candidates).run();
  }
  return check;
}

}  // namespace kinestat
