#include "studies/synthesis/dyads/internal/straight_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/contract.hpp"
#include "studies/synthesis/dyads/internal/precise_vector.hpp"

namespace kinestat {

namespace {

class StraightFitter {
 public:
  StraightFitter(std::span<const PreciseRow> rows,
                 std::span<const double> allowances,
                 FarPoint far,
                 const StraightDyad& start)
      : rows_(rows),
        allowances_(allowances),
        far_(far),
        at_{BigFloat(start.finite.real()), BigFloat(start.finite.imag())},
        normal_{BigFloat(start.normal.real()), BigFloat(start.normal.imag())} {
    normalise();
  }

  StraightDyad run() {
    constexpr int kSteps = 8;
    for (int i = 0; i < kSteps && step(); ++i) {
    }
    StraightDyad result{.finite = rounded(at_),
                        .normal = rounded(normal_),
                        .misses = {},
                        .uncertainty = uncertainty_};
    const PreciseRow x = seven_of(at_, normal_);
    for (const PreciseRow& row : rows_) {
      result.misses.push_back(static_cast<double>(dot(row, x)));
    }
    return result;
  }

 private:
  using Pair = std::array<BigFloat, 2>;

  static Point rounded(const Pair& p) {
    return {static_cast<double>(p[0]), static_cast<double>(p[1])};
  }

  // (u, v, a, b, p, q, h), in which p and q are linear in either point.
  PreciseRow seven_of(const Pair& finite, const Pair& normal) const {
    const Pair& z = far_ == FarPoint::centre ? finite : normal;
    const Pair& w = far_ == FarPoint::centre ? normal : finite;
    PreciseRow x;
    x.fill(BigFloat(0));
    const std::size_t at = far_ == FarPoint::centre ? 2 : 0;
    x[at] = normal[0];
    x[at + 1] = normal[1];
    x[4] = w[0] * z[0] + w[1] * z[1];
    x[5] = w[1] * z[0] - w[0] * z[1];
    return x;
  }

  // Changes of the seven numbers with either coordinate of the finite point, which only p and q
  // have in them, and with the turn of the normal.
  std::array<PreciseRow, 3> derivatives() const {
    std::array<PreciseRow, 3> result;
    for (std::size_t i = 0; i < 2; ++i) {
      result[i] = seven_of({BigFloat(i == 0 ? 1 : 0), BigFloat(i == 0 ? 0 : 1)}, normal_);
      for (std::size_t j = 0; j < 4; ++j) {
        result[i][j] = BigFloat(0);
      }
    }
    result[2] = seven_of(at_, {-normal_[1], normal_[0]});
    return result;
  }

  // The normal equations, weighted: square * step = right.
  struct Equations {
    std::array<PreciseVector, 3> square{};
    PreciseVector right{};
  };

  Equations equations() const {
    Equations result;
    const PreciseRow x = seven_of(at_, normal_);
    const std::array<PreciseRow, 3> changes = derivatives();
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const BigFloat weight = 1 / (BigFloat(allowances_[r]) * allowances_[r]);
      PreciseVector slope;
      for (std::size_t i = 0; i < 3; ++i) {
        slope[i] = dot(rows_[r], changes[i]);
      }
      const BigFloat miss = dot(rows_[r], x);
      for (std::size_t i = 0; i < 3; ++i) {
        result.right[i] -= weight * slope[i] * miss;
        for (std::size_t j = 0; j < 3; ++j) {
          result.square[i][j] += weight * slope[i] * slope[j];
        }
      }
    }
    return result;
  }

  // False where the conditions leave the step open. By Cramer; the matrix is symmetric, so that its
  // rows are its columns.
  bool step() {
    const auto [square, right] = equations();
    const PreciseVector one = cross(square[1], square[2]);
    const PreciseVector two = cross(square[2], square[0]);
    const PreciseVector three = cross(square[0], square[1]);
    const BigFloat divisor = dot(square[0], one);
    if (divisor == 0) {
      return false;
    }
    at_[0] += dot(right, one) / divisor;
    at_[1] += dot(right, two) / divisor;
    const BigFloat turn = dot(right, three) / divisor;
    normal_ = {normal_[0] - turn * normal_[1], normal_[1] + turn * normal_[0]};
    normalise();
    // The root of the trace of the inverse.
    uncertainty_ = std::sqrt(static_cast<double>((one[0] + two[1] + three[2]) / divisor));
    return true;
  }

  void normalise() {
    const BigFloat size = sqrt(normal_[0] * normal_[0] + normal_[1] * normal_[1]);
    normal_[0] /= size;
    normal_[1] /= size;
  }

  std::span<const PreciseRow> rows_;
  std::span<const double> allowances_;
  FarPoint far_;
  Pair at_;
  Pair normal_;
  double uncertainty_ = 0.0;
};

}  // namespace

bool StraightDyad::is_within(std::span<const double> allowances) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < misses.size(); ++i) {
    sum += (misses[i] / allowances[i]) * (misses[i] / allowances[i]);
  }
  return sum <= static_cast<double>(misses.size());
}

double StraightDyad::deviation(std::span<const double> slopes) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < misses.size(); ++i) {
    largest = std::max(largest, std::abs(misses[i]) / slopes[i]);
  }
  return largest;
}

StraightDyad fit_straight(std::span<const PreciseRow> rows,
                          std::span<const double> allowances,
                          FarPoint far,
                          StraightDyad start) {
  KINESTAT_EXPECTS(rows.size() == allowances.size());
  return StraightFitter(rows, allowances, far, start).run();
}

}  // namespace kinestat
