#include "studies/synthesis/dyads/few_positions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/contract.hpp"
#include "core/rounding.hpp"
#include "core/synthesis_tolerance.hpp"
#include "core/tolerance.hpp"
#include "core/types.hpp"
#include "studies/synthesis/dyads/bounded_point.hpp"
#include "studies/synthesis/dyads/internal/condition_rows.hpp"
#include "studies/synthesis/dyads/internal/condition_space.hpp"
#include "studies/synthesis/dyads/internal/dyad_point.hpp"

namespace kinestat {

namespace {

using ConditionRow = std::array<double, 7>;

// A polynomial in u and v up to the third degree: coefficient [i][j] of u^i v^j.
struct Polynomial {
  std::array<std::array<double, 4>, 4> of{};

  static Polynomial linear(double one, double u, double v) {
    Polynomial result;
    result.of[0][0] = one;
    result.of[1][0] = u;
    result.of[0][1] = v;
    return result;
  }

  Polynomial operator*(const Polynomial& other) const {
    Polynomial result;
    for (std::size_t i = 0; i < 16; ++i) {
      result.add_shifted(other, i / 4, i % 4, of[i / 4][i % 4]);
    }
    return result;
  }

  // Adds a multiple of the other times u^i v^j; what exceeds the third degree is never there.
  void add_shifted(const Polynomial& other, std::size_t i, std::size_t j, double factor) {
    for (std::size_t k = 0; k < 16; ++k) {
      if (i + k / 4 < 4 && j + k % 4 < 4) {
        of[i + k / 4][j + k % 4] += factor * other.of[k / 4][k % 4];
      }
    }
  }

  Polynomial& add(const Polynomial& other, double factor) {
    for (std::size_t i = 0; i < 16; ++i) {
      of[i / 4][i % 4] += factor * other.of[i / 4][i % 4];
    }
    return *this;
  }
};

// The three coefficients of (a, b, 1) for a given circle point, or of (u, v, 1) for a given centre:
// linear in the coordinates of what is given.
using LinearRow = std::array<std::array<double, 3>, 3>;

LinearRow row_for_circle_point(const ConditionRow& r) {
  return {{{r[2], r[4], -r[5]}, {r[3], r[5], r[4]}, {r[6], r[0], r[1]}}};
}

LinearRow row_for_centre(const ConditionRow& r) {
  return {{{r[0], r[4], r[5]}, {r[1], -r[5], r[4]}, {r[6], r[2], r[3]}}};
}

Polynomial polynomial_of(const std::array<double, 3>& c) {
  return Polynomial::linear(c[0], c[1], c[2]);
}

// With the sign of its odd permutations.
Polynomial determinant(const std::array<LinearRow, 3>& rows, double odd) {
  Polynomial sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Polynomial first = polynomial_of(rows[0][i]);
    sum.add(first * (polynomial_of(rows[1][j]) * polynomial_of(rows[2][k])), 1.0);
    sum.add(first * (polynomial_of(rows[1][k]) * polynomial_of(rows[2][j])), odd);
  }
  return sum;
}

// The entries by their sizes, each larger by as much as it may be off.
LinearRow majorant(LinearRow row, double error) {
  for (auto& polynomial : row) {
    for (double& entry : polynomial) {
      entry = std::abs(entry) + error;
    }
  }
  return row;
}

// How far the coefficients of a sum of products of rows may be off, given what that sum is of rows
// whose entries and signs are all positive: without their errors and with them.
Polynomial bounds_of(const Polynomial& sizes, Polynomial with_errors) {
  constexpr double kRoundings = 32.0;
  with_errors.add(sizes, -1.0);
  return with_errors.add(sizes, kRoundings * kEpsilon);
}

// What rounding may have done to each entry of a condition.
double error_of(const ConditionRows& system, std::size_t row) {
  return kDataRounding / kEpsilon * system.noise[row];
}

PlaneCubic cubic_of(const std::array<LinearRow, 3>& rows, const ConditionRows& system) {
  std::array<LinearRow, 3> sizes{};
  std::array<LinearRow, 3> with_errors{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    sizes[i] = majorant(rows[i], 0.0);
    with_errors[i] = majorant(rows[i], error_of(system, i));
  }
  const auto& p = determinant(rows, -1.0).of;
  const auto& off = bounds_of(determinant(sizes, 1.0), determinant(with_errors, 1.0)).of;
  PlaneCubic cubic{.centre = Point(system.x, system.y), .length = system.length};
  cubic.k = {0.5 * (p[3][0] + p[1][2]), 0.5 * (p[0][3] + p[2][1])};
  cubic.q = {p[2][0], p[1][1], p[0][2]};
  cubic.l = {p[1][0], p[0][1]};
  cubic.c = p[0][0];
  cubic.bounds = {.k = {0.5 * (off[3][0] + off[1][2]), 0.5 * (off[0][3] + off[2][1])},
                  .q = {off[2][0], off[1][1], off[0][2]},
                  .l = {off[1][0], off[0][1]},
                  .c = off[0][0]};
  return cubic.settled_about(cubic.centre, cubic.length);  // divides by the largest coefficient
}

Vec3 values_at(const LinearRow& row, const Point& z) {
  Vec3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[static_cast<Eigen::Index>(i)] = row[i][0] + row[i][1] * z.real() + row[i][2] * z.imag();
  }
  return result;
}

// The conditions of the other point of a dyad, each with what rounding of the positions does to it.
struct Conditions {
  std::vector<Vec3> rows;
  std::vector<double> errors;

  Conditions(const ConditionRows& system, const Point& point, DyadPoint which) {
    for (std::size_t i = 0; i < system.rows.size(); ++i) {
      const LinearRow row = which == DyadPoint::circle_point ? row_for_circle_point(system.rows[i])
                                                             : row_for_centre(system.rows[i]);
      rows.push_back(values_at(row, point));
      errors.push_back(system.noise[i] * (1.0 + std::abs(point)));
    }
  }
};

// What conditions leave over, with its error as a share of it.
struct CommonSolution {
  Vec3 vector = Vec3::Zero();
  double error = 1.0;
};

// Of all pairs of rows the longest product, which is that of the two that differ most.
CommonSolution common_solution(const Conditions& all) {
  CommonSolution best;
  for (std::size_t i = 0; i < all.rows.size(); ++i) {
    for (std::size_t j = i + 1; j < all.rows.size(); ++j) {
      const Vec3& one = all.rows[i];
      const Vec3& other = all.rows[j];
      const Vec3 product = one.cross(other);
      if (product.norm() > best.vector.norm()) {
        const double error = all.errors[i] * other.norm() + all.errors[j] * one.norm();
        best = {.vector = product, .error = error / product.norm()};
      }
    }
  }
  return best;
}

using DyadCoordinates = Eigen::Matrix<double, 7, 1>;

// A dyad whose circle point and centre are given as (x, y, h).
DyadCoordinates seven_of(const Vec3& circle, const Vec3& centre) {
  const Point z(circle[0], circle[1]);
  const Point w(centre[0], centre[1]);
  const Point product = z * std::conj(w);
  DyadCoordinates x;
  x << z.real() * centre[2], z.imag() * centre[2], w.real() * circle[2], w.imag() * circle[2],
      product.real(), -product.imag(), circle[2] * centre[2];
  return x;
}

Point in_system(const ConditionRows& system, const Point& point) {
  return (point - Point(system.x, system.y)) / system.length;
}

// The dyad of seven numbers with an error, as a share of the largest of them.
std::optional<Dyad> dyad_with_digits(const DyadCoordinates& x,
                                     const ConditionRows& system,
                                     std::span<const PositionJets> positions,
                                     double error) {
  std::optional<Dyad> dyad = dyad_of(x, system, positions[0], error);
  if (dyad) {
    dyad->digits = digits_of(error / smallest_denominator(x, dyad->kind));
    dyad->residual = find_residual(*dyad, positions);
  }
  return dyad;
}

// Solutions with h = 0 and one of the two points at infinity: the null vector of three equations
// for four of the seven numbers.
std::optional<Dyad> find_infinite(const ConditionRows& system,
                                  std::span<const PositionJets> positions,
                                  const std::array<std::size_t, 4>& columns) {
  MatX matrix(3, 4);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          system.rows[i][columns[j]];
    }
  }
  const NullSpace space = find_null_space(matrix);
  if (space.reciprocal_condition() < kRankZero) {
    return std::nullopt;
  }
  DyadCoordinates x = DyadCoordinates::Zero();
  for (std::size_t j = 0; j < 4; ++j) {
    x[static_cast<Eigen::Index>(columns[j])] = space.basis(static_cast<Eigen::Index>(j), 0);
  }
  return dyad_with_digits(x, system, positions, find_loss(space, system.noise));
}

}  // namespace

FourPositionCurves find_curves(std::span<const PositionJets> positions) {
  KINESTAT_EXPECTS(position_count(positions) == 4);
  const ConditionRows system = make_condition_rows(positions);
  const ConditionSpace space = find_condition_space(system, positions);
  FourPositionCurves result;
  result.status = space.status;
  result.reason = space.reason;
  result.reciprocal_condition = space.reciprocal_condition;
  result.digits = space.digits;
  const Degeneracy translation = find_degeneracy(positions);
  if (space.status == BurmesterStatus::solved && translation != Degeneracy::none) {
    result.status = BurmesterStatus::family;
    result.reason = translation;
  }
  if (result.status != BurmesterStatus::solved) {
    return result;
  }
  std::array<LinearRow, 3> of_circle_points{};
  std::array<LinearRow, 3> of_centres{};
  for (std::size_t i = 0; i < 3; ++i) {
    of_circle_points[i] = row_for_circle_point(system.rows[i]);
    of_centres[i] = row_for_centre(system.rows[i]);
  }
  result.circle_points = cubic_of(of_circle_points, system);
  result.centre_points = cubic_of(of_centres, system);
  result.slider = find_infinite(system, positions, {2, 3, 4, 5});
  result.inverted_slider = find_infinite(system, positions, {0, 1, 4, 5});
  return result;
}

std::optional<Dyad> find_dyad(std::span<const PositionJets> positions,
                              const Point& point,
                              DyadPoint which) {
  const ConditionRows system = make_condition_rows(positions);
  const Point given = in_system(system, point);
  const CommonSolution found = common_solution({system, given, which});
  if (!(found.error < kUselessLoss)) {
    return std::nullopt;
  }
  const Vec3 finite(given.real(), given.imag(), 1.0);
  const DyadCoordinates x = which == DyadPoint::circle_point ? seven_of(finite, found.vector)
                                                             : seven_of(found.vector, finite);
  return dyad_with_digits(x, system, positions, found.error);
}

std::optional<PlaneLine> find_partner_line(std::span<const PositionJets> positions,
                                           const Point& point,
                                           DyadPoint which) {
  KINESTAT_EXPECTS(position_count(positions) == 2);
  const ConditionRows system = make_condition_rows(positions);
  const Conditions conditions(system, in_system(system, point), which);
  const Vec3& row = conditions.rows[0];
  const double size = std::hypot(row[0], row[1]);
  if (!(conditions.errors[0] < kUselessLoss * size)) {
    return std::nullopt;
  }
  const Point normal(row[0] / size, row[1] / size);
  return PlaneLine{.normal = normal,
                   .offset = dot(normal, {system.x, system.y}) - system.length * row[2] / size};
}

std::optional<Dyad> make_crank(std::span<const PositionJets> positions,
                               const Point& circle_point,
                               const Point& centre_point) {
  const ConditionRows system = make_condition_rows(positions);
  const Point z = in_system(system, circle_point);
  const Point w = in_system(system, centre_point);
  const double error = std::ranges::max(system.noise);
  return dyad_with_digits(
      seven_of({z.real(), z.imag(), 1.0}, {w.real(), w.imag(), 1.0}), system, positions, error);
}

std::optional<Circle> find_straight_path_circle(std::span<const PositionJets> positions) {
  KINESTAT_EXPECTS(position_count(positions) == 3);
  const ConditionRows system = make_condition_rows(positions);
  const LinearRow one = row_for_circle_point(system.rows[0]);
  const LinearRow other = row_for_circle_point(system.rows[1]);
  // The centre is at infinity: the coefficients of a and b are proportional.
  const auto product = [](const LinearRow& r, const LinearRow& t, double sign) {
    Polynomial sum = polynomial_of(r[0]) * polynomial_of(t[1]);
    return sum.add(polynomial_of(r[1]) * polynomial_of(t[0]), sign);
  };
  const auto with_error = [&](const LinearRow& row, std::size_t i) {
    return majorant(row, error_of(system, i));
  };
  const auto& p = product(one, other, -1.0).of;
  const auto& off = bounds_of(product(majorant(one, 0.0), majorant(other, 0.0), 1.0),
                              product(with_error(one, 0), with_error(other, 1), 1.0))
                        .of;
  const double leading = 0.5 * (p[2][0] + p[0][2]);
  if (!(std::abs(leading) > kRankZero)) {
    return std::nullopt;
  }
  const auto coefficient = [&](std::size_t i, std::size_t j) {
    return BoundedNumber{.value = p[i][j], .bound = off[i][j]};
  };
  const BoundedNumber whole = coefficient(2, 0) + coefficient(0, 2);  // twice the leading one
  const BoundedPoint middle = {.x = exactly(0.0) - coefficient(1, 0) / whole,
                               .y = exactly(0.0) - coefficient(0, 1) / whole};
  const BoundedNumber square = dot(middle, middle) - exactly(2.0) * coefficient(0, 0) / whole;
  const BoundedPoint centre =
      BoundedPoint::within({system.x, system.y}, {0.0, 0.0}) + exactly(system.length) * middle;
  return Circle{.centre = centre.zeroed(),
                .radius = system.length * std::sqrt(std::max(square.zeroed(), 0.0))};
}

}  // namespace kinestat
