#include "studies/synthesis/dyads/internal/precise_null_space.hpp"

#include <cstddef>
#include <limits>
#include <utility>

namespace kinestat {

namespace {

class NullSpaceFinder {
 public:
  explicit NullSpaceFinder(std::vector<PreciseRow> rows) : rows_(std::move(rows)) {
    for (std::size_t i = 0; i < 7; ++i) {
      columns_[i] = i;
    }
  }

  std::optional<PreciseBasis> run() {
    PreciseBasis basis;
    for (std::size_t step = 0; step < rows_.size(); ++step) {
      const BigFloat pivot = take_pivot(step);
      basis.reciprocal_condition = static_cast<double>(pivot);
      if (is_rounding(pivot)) {
        return std::nullopt;
      }
      eliminate(step);
    }
    for (std::size_t free = 0; free < 3; ++free) {
      basis.vectors[free] = solution(free);
    }
    make_orthonormal(basis);
    return basis;
  }

 private:
  static bool is_rounding(const BigFloat& pivot) { return pivot < big_float_rounding(); }

  BigFloat take_pivot(std::size_t step) {
    std::size_t best_row = step;
    std::size_t best = step;
    BigFloat largest(-1);
    for (std::size_t at = 0; at < rows_.size() * columns_.size(); ++at) {
      const std::size_t i = at / columns_.size();
      const std::size_t j = at % columns_.size();
      const BigFloat size = i < step || j < step ? BigFloat(-1) : abs(rows_[i][columns_[j]]);
      if (size > largest) {
        largest = size;
        best_row = i;
        best = j;
      }
    }
    std::swap(rows_[step], rows_[best_row]);
    std::swap(columns_[step], columns_[best]);
    return largest;
  }

  // Gauss and Jordan: the pivot column is left with a one.
  void eliminate(std::size_t step) {
    const BigFloat pivot = rows_[step][columns_[step]];
    for (BigFloat& entry : rows_[step]) {
      entry /= pivot;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const BigFloat factor = rows_[i][columns_[step]];
      for (std::size_t j = 0; i != step && j < 7; ++j) {
        rows_[i][j] -= factor * rows_[step][j];
      }
    }
  }

  PreciseRow solution(std::size_t free) const {
    PreciseRow x;
    x.fill(BigFloat(0));
    const std::size_t column = columns_[rows_.size() + free];
    x[column] = BigFloat(1);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      x[columns_[i]] = -rows_[i][column];
    }
    return x;
  }

  static BigFloat inner(const PreciseRow& a, const PreciseRow& b) {
    BigFloat sum(0);
    for (std::size_t i = 0; i < 7; ++i) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  static void take_out(PreciseRow& one, const PreciseRow& unit) {
    const BigFloat share = inner(one, unit);
    for (std::size_t k = 0; k < one.size(); ++k) {
      one[k] -= share * unit[k];
    }
  }

  static void make_orthonormal(PreciseBasis& basis) {
    for (std::size_t i = 0; i < 3; ++i) {
      PreciseRow& one = basis.vectors[i];
      for (std::size_t j = 0; j < i; ++j) {
        take_out(one, basis.vectors[j]);
      }
      const BigFloat length = sqrt(inner(one, one));
      for (BigFloat& entry : one) {
        entry /= length;
      }
    }
  }

  std::vector<PreciseRow> rows_;
  std::array<std::size_t, 7> columns_{};
};

}  // namespace

std::optional<PreciseBasis> find_precise_null_space(std::vector<PreciseRow> rows) {
  return NullSpaceFinder(std::move(rows)).run();
}

}  // namespace kinestat
