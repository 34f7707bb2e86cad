#include "synthesis/precise_burmester.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/conic_intersection.hpp"
#include "synthesis/internal/condition_rows.hpp"
#include "synthesis/internal/condition_space.hpp"
#include "synthesis/internal/dyad_point.hpp"

namespace kinestat {

namespace {

using Row = std::array<BigFloat, 7>;
using Vector = std::array<BigFloat, 3>;
using Matrix = std::array<Vector, 3>;

double to_double(const BigFloat& x) {
  return static_cast<double>(x);
}

// The null space of four rows: the columns x of Row[i], i = 0 to 2, orthonormal.
struct Basis {
  std::array<Row, 3> vectors;
  double flatness = 0.0;  // the last pivot of a complete elimination
};

class NullSpaceFinder {
 public:
  explicit NullSpaceFinder(std::vector<Row> rows) : rows_(std::move(rows)) {
    for (std::size_t i = 0; i < 7; ++i) {
      columns_[i] = i;
    }
  }

  // Empty if the rows depend on each other to the last digit.
  std::optional<Basis> run() {
    Basis basis;
    for (std::size_t step = 0; step < rows_.size(); ++step) {
      const BigFloat pivot = take_pivot(step);
      basis.flatness = to_double(pivot);
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
  static bool is_rounding(const BigFloat& pivot) {
    return pivot < 1024 * std::numeric_limits<BigFloat>::epsilon();
  }

  BigFloat take_pivot(std::size_t step) {
    std::size_t best_row = step;
    std::size_t best = step;
    BigFloat largest(-1);
    for (std::size_t i = step; i < rows_.size(); ++i) {
      for (std::size_t j = step; j < 7; ++j) {
        const BigFloat size = abs(rows_[i][columns_[j]]);
        if (size > largest) {
          largest = size;
          best_row = i;
          best = j;
        }
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

  Row solution(std::size_t free) const {
    Row x;
    x.fill(BigFloat(0));
    const std::size_t column = columns_[rows_.size() + free];
    x[column] = BigFloat(1);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      x[columns_[i]] = -rows_[i][column];
    }
    return x;
  }

  static BigFloat inner(const Row& a, const Row& b) {
    BigFloat sum(0);
    for (std::size_t i = 0; i < 7; ++i) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  static void make_orthonormal(Basis& basis) {
    for (std::size_t i = 0; i < 3; ++i) {
      Row& one = basis.vectors[i];
      for (std::size_t j = 0; j < i; ++j) {
        const BigFloat share = inner(one, basis.vectors[j]);
        for (std::size_t k = 0; k < 7; ++k) {
          one[k] -= share * basis.vectors[j][k];
        }
      }
      const BigFloat length = sqrt(inner(one, one));
      for (BigFloat& entry : one) {
        entry /= length;
      }
    }
  }

  std::vector<Row> rows_;
  std::array<std::size_t, 7> columns_{};
};

// Symmetric product of two of the seven numbers as a form in the coordinates of the basis.
void add_product(Matrix& form, const Basis& basis, std::size_t a, std::size_t b, int sign) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      form[i][j] += sign * (basis.vectors[i][a] * basis.vectors[j][b] +
                            basis.vectors[i][b] * basis.vectors[j][a]);
    }
  }
}

Matrix zero_form() {
  Matrix form;
  for (Vector& row : form) {
    row.fill(BigFloat(0));
  }
  return form;
}

Mat3 rounded_form(const Matrix& form) {
  Mat3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = to_double(form[i][j]);
    }
  }
  return result;
}

Vector times(const Matrix& form, const Vector& y) {
  Vector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = form[i][0] * y[0] + form[i][1] * y[1] + form[i][2] * y[2];
  }
  return result;
}

BigFloat dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Newton on both forms, the step orthogonal to y: it lies in the span of the two gradients' duals.
Vector improved(const Matrix& first, const Matrix& second, Vector y) {
  constexpr int kSteps = 8;
  for (int step = 0; step < kSteps; ++step) {
    const Vector one = times(first, y);
    const Vector other = times(second, y);
    // dy with 2 one.dy = -f, 2 other.dy = -g, y.dy = 0 by Cramer's rule.
    const Vector product = cross(one, other);
    const BigFloat determinant = dot(product, y);
    if (determinant == 0) {
      return y;
    }
    const BigFloat f = -dot(y, one) / 2;
    const BigFloat g = -dot(y, other) / 2;
    const Vector to_one = cross(other, y);
    const Vector to_other = cross(y, one);
    for (std::size_t i = 0; i < 3; ++i) {
      y[i] += (f * to_one[i] + g * to_other[i]) / determinant;
    }
  }
  return y;
}

class PreciseSolver {
 public:
  explicit PreciseSolver(std::span<const PositionJetsOf<BigFloat>> positions)
      : system_(make_condition_rows(positions)) {
    for (const PositionJetsOf<BigFloat>& position : positions) {
      positions_.push_back(rounded(position));
    }
  }

  BurmesterSolution run() {
    const auto basis = NullSpaceFinder(system_.rows).run();
    if (!basis) {
      return solve_burmester(positions_);
    }
    solution_.flatness = basis->flatness;
    const double noise = std::ranges::max(system_.noise);
    solution_.digits = digits_of(noise / basis->flatness);
    Matrix first = zero_form();
    add_product(first, *basis, 4, 6, 1);
    add_product(first, *basis, 0, 2, -1);
    add_product(first, *basis, 1, 3, -1);
    Matrix second = zero_form();
    add_product(second, *basis, 5, 6, 1);
    add_product(second, *basis, 0, 3, -1);
    add_product(second, *basis, 1, 2, 1);
    const ConicIntersection shared = intersect_conics(rounded_form(first), rounded_form(second));
    solution_.shared_gap = shared.gap;
    if (shared.shared != SharedPart::none) {
      return solve_burmester(positions_);
    }
    for (const ConicPoint& point : shared.points) {
      add_point(point, first, second, *basis);
    }
    sort_dyads(solution_.dyads);
    return std::move(solution_);
  }

 private:
  void add_point(const ConicPoint& point,
                 const Matrix& first,
                 const Matrix& second,
                 const Basis& basis) {
    if (!point.is_real) {
      solution_.imaginary_count += point.multiplicity;
      return;
    }
    Vector y = {
        BigFloat(point.y[0].real()), BigFloat(point.y[1].real()), BigFloat(point.y[2].real())};
    y = point.multiplicity == 1 ? improved(first, second, y) : y;
    Row x;
    for (std::size_t i = 0; i < 7; ++i) {
      x[i] = basis.vectors[0][i] * y[0] + basis.vectors[1][i] * y[1] + basis.vectors[2][i] * y[2];
    }
    add_dyad(x, point);
  }

  // The unit and origin of the system are those of doubles; the moving frame is not.
  void add_dyad(const Row& x, const ConicPoint& point) {
    ConditionRows frame;
    frame.x = to_double(system_.x);
    frame.y = to_double(system_.y);
    frame.length = to_double(system_.length);
    Eigen::Matrix<double, 7, 1> values;
    for (std::size_t i = 0; i < 7; ++i) {
      values[static_cast<Eigen::Index>(i)] = to_double(x[i]);
    }
    std::optional<Dyad> dyad = dyad_of(values, frame, positions_[0]);
    if (!dyad) {
      return;
    }
    dyad->multiplicity = point.multiplicity;
    dyad->digits = solution_.digits;
    dyad->residual = find_residual(*dyad, positions_);
    solution_.dyads.push_back(*dyad);
  }

  ConditionRowsOf<BigFloat> system_;
  std::vector<PositionJets> positions_;
  BurmesterSolution solution_;
};

}  // namespace

PositionJets rounded(const PositionJetsOf<BigFloat>& position) {
  PositionJets result;
  for (std::size_t k = 0; k < position.angle.size(); ++k) {
    result.x.push_back(to_double(position.x[k]));
    result.y.push_back(to_double(position.y[k]));
    result.angle.push_back(to_double(position.angle[k]));
  }
  return result;
}

BurmesterSolution solve_burmester_precisely(std::span<const PositionJetsOf<BigFloat>> positions) {
  int count = 0;
  for (const PositionJetsOf<BigFloat>& position : positions) {
    count += position.order();
  }
  KINESTAT_EXPECTS(count == 5);
  return PreciseSolver(positions).run();
}

}  // namespace kinestat
