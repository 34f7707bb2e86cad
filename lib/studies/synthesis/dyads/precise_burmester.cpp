#include "studies/synthesis/dyads/precise_burmester.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/contract.hpp"
#include "core/synthesis_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/dense/conic_intersection.hpp"
#include "studies/synthesis/dyads/bounded_point.hpp"
#include "studies/synthesis/dyads/internal/condition_rows.hpp"
#include "studies/synthesis/dyads/internal/condition_space.hpp"
#include "studies/synthesis/dyads/internal/dyad_point.hpp"
#include "studies/synthesis/dyads/internal/precise_null_space.hpp"
#include "studies/synthesis/dyads/internal/precise_vector.hpp"

namespace kinestat {

namespace {

using Matrix = std::array<PreciseVector, 3>;

double to_double(const BigFloat& x) {
  return static_cast<double>(x);
}

// Symmetric product of two of the seven numbers as a form in the coordinates of the basis.
void add_product(Matrix& form, const PreciseBasis& basis, std::size_t a, std::size_t b, int sign) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      form[i][j] += sign * (basis.vectors[i][a] * basis.vectors[j][b] +
                            basis.vectors[i][b] * basis.vectors[j][a]);
    }
  }
}

Matrix zero_form() {
  Matrix form;
  for (PreciseVector& row : form) {
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

PreciseVector times(const Matrix& form, const PreciseVector& y) {
  PreciseVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = form[i][0] * y[0] + form[i][1] * y[1] + form[i][2] * y[2];
  }
  return result;
}

// Newton on both forms, the step orthogonal to y: it lies in the span of the two gradients' duals.
PreciseVector improved(const Matrix& first, const Matrix& second, PreciseVector y) {
  constexpr int kSteps = 8;
  for (int step = 0; step < kSteps; ++step) {
    const PreciseVector one = times(first, y);
    const PreciseVector other = times(second, y);
    // dy with 2 one.dy = -f, 2 other.dy = -g, y.dy = 0 by Cramer's rule.
    const PreciseVector product = cross(one, other);
    const BigFloat determinant = dot(product, y);
    if (determinant == 0) {
      return y;
    }
    const BigFloat f = -dot(y, one) / 2;
    const BigFloat g = -dot(y, other) / 2;
    const PreciseVector to_one = cross(other, y);
    const PreciseVector to_other = cross(y, one);
    for (std::size_t i = 0; i < 3; ++i) {
      y[i] += (f * to_one[i] + g * to_other[i]) / determinant;
    }
  }
  return y;
}

// How far seven numbers are from meeting the conditions, whose largest entry is 1, and from being
// those of a dyad; their own largest one counts as 1.
double residual_of(const PreciseRow& x, const std::vector<PreciseRow>& conditions) {
  BigFloat size(0);
  for (const BigFloat& one : x) {
    size = std::max(size, BigFloat(abs(one)));
  }
  BigFloat worst(0);
  for (const PreciseRow& condition : conditions) {
    BigFloat sum(0);
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += condition[i] * x[i];
    }
    worst = std::max(worst, BigFloat(abs(sum) / size));
  }
  const BigFloat p = x[4] * x[6] - x[0] * x[2] - x[1] * x[3];
  const BigFloat q = x[5] * x[6] - x[0] * x[3] + x[1] * x[2];
  worst = std::max({worst, BigFloat(abs(p) / (size * size)), BigFloat(abs(q) / (size * size))});
  return to_double(worst);
}

class PreciseSolver {
 public:
  PreciseSolver(std::span<const PositionJetsOf<BigFloat>> positions,
                int digits,
                const LastDecimal& decimal)
      : decimal_(decimal), system_(make_condition_rows(positions, std::pow(10.0, -digits))) {
    for (const PositionJetsOf<BigFloat>& position : positions) {
      positions_.push_back(rounded(position));
    }
    first_ = finite_position(
        {to_double(positions[0].x[0] - system_.x), to_double(positions[0].y[0] - system_.y)},
        positions_[0].angle[0]);
  }

  BurmesterSolution run() {
    const auto basis = find_precise_null_space(system_.rows);
    if (!basis) {
      return solve_burmester(positions_, decimal_);
    }
    solution_.reciprocal_condition = basis->reciprocal_condition;
    loss_ = std::ranges::max(system_.noise) / basis->reciprocal_condition;
    solution_.digits = digits_of(loss_);
    if (!(loss_ < kUselessLoss)) {
      solution_.status = BurmesterStatus::no_digits;
      return std::move(solution_);
    }
    Matrix first = zero_form();
    add_product(first, *basis, 4, 6, 1);
    add_product(first, *basis, 0, 2, -1);
    add_product(first, *basis, 1, 3, -1);
    Matrix second = zero_form();
    add_product(second, *basis, 5, 6, 1);
    add_product(second, *basis, 0, 3, -1);
    add_product(second, *basis, 1, 2, 1);
    const ConicIntersection shared = intersect_conics(rounded_form(first), rounded_form(second));
    if (shared.shared != SharedPart::none) {
      return solve_burmester(positions_, decimal_);
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
                 const PreciseBasis& basis) {
    if (!point.is_real) {
      solution_.imaginary_count += point.multiplicity;
      return;
    }
    PreciseVector y = {
        BigFloat(point.y[0].real()), BigFloat(point.y[1].real()), BigFloat(point.y[2].real())};
    y = point.multiplicity == 1 ? improved(first, second, y) : y;
    PreciseRow x;
    for (std::size_t i = 0; i < 7; ++i) {
      x[i] = basis.vectors[0][i] * y[0] + basis.vectors[1][i] * y[1] + basis.vectors[2][i] * y[2];
    }
    add_dyad(x, point);
  }

  // The differences from the origin of the system were taken with all digits.
  void add_dyad(const PreciseRow& x, const ConicPoint& point) {
    ConditionRows frame;
    frame.length = to_double(system_.length);
    Eigen::Matrix<double, 7, 1> values;
    for (std::size_t i = 0; i < 7; ++i) {
      values[static_cast<Eigen::Index>(i)] = to_double(x[i]);
    }
    const double loss = point.multiplicity > 1 ? std::sqrt(loss_) : loss_ * point.condition;
    std::optional<Dyad> dyad = dyad_of(values, frame, first_, loss);
    if (!dyad) {
      return;
    }
    dyad->digits = digits_of(std::max(loss, kEpsilon) / smallest_denominator(values, dyad->kind));
    if (dyad->length > kLongCrank * frame.length) {
      dyad = find_straight(values, straight_conditions(system_), decimal_, frame, first_)
                 .value_or(*dyad);
    }
    const BoundedPoint centre =
        dyad->bounded_centre_point() +
        BoundedPoint::within({to_double(system_.x), to_double(system_.y)}, {0.0, 0.0});
    dyad->centre_point = centre.zeroed();
    dyad->centre_bound = centre.bound();
    dyad->multiplicity = point.multiplicity;
    dyad->residual =
        dyad->deviation > 0.0 ? find_residual(*dyad, positions_) : residual_of(x, system_.rows);
    solution_.dyads.push_back(*dyad);
  }

  LastDecimal decimal_;
  ConditionRowsOf<BigFloat> system_;
  std::vector<PositionJets> positions_;
  PositionJets first_;  // relative to the origin of the system
  BurmesterSolution solution_;
  double loss_ = 0.0;
};

}  // namespace

PositionJets rounded(const PositionJetsOf<BigFloat>& position) {
  PositionJets result;
  result.is_directed = position.is_directed;
  for (std::size_t k = 0; k < position.angle.size(); ++k) {
    result.x.push_back(to_double(position.x[k]));
    result.y.push_back(to_double(position.y[k]));
    result.angle.push_back(to_double(position.angle[k]));
  }
  return result;
}

BurmesterSolution solve_burmester_precisely(std::span<const PositionJetsOf<BigFloat>> positions,
                                            int digits,
                                            const LastDecimal& decimal) {
  KINESTAT_EXPECTS(digits >= kLeastDigits && digits <= kMostDigits);
  int count = 0;
  for (const PositionJetsOf<BigFloat>& position : positions) {
    count += position.order();
  }
  KINESTAT_EXPECTS(count == 5);
  return PreciseSolver(positions, digits, decimal).run();
}

}  // namespace kinestat
