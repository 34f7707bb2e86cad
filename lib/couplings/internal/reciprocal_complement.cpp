#include "couplings/internal/reciprocal_complement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/tolerance.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

// Coordinates of a screw with the three that carry names of their own first: F before T, ω before
// v. In the plane only those of the plane.
constexpr std::array kSpatial = {0, 1, 2, 3, 4, 5};
constexpr std::array kPlanarWrench = {0, 1, 5};  // Fx, Fy, Tz
constexpr std::array kPlanarTwist = {2, 3, 4};   // wz, vx, vy

template <class Scalar>
double largest_of(const Vec6Of<Scalar>& row) {
  double size = 0.0;
  for (int i = 0; i < 6; ++i) {
    size = std::max(size, std::abs(value_of(row[i])));
  }
  return size;
}

// Gauss-Jordan elimination of the equations row · x = 0 with the last coordinates as pivots, so
// that the free ones, in which the solutions are written, are as early as possible.
template <class Scalar>
class NullSpace {
 public:
  NullSpace(std::vector<Vec6Of<Scalar>> rows, std::vector<int> coordinates)
      : rows_(std::move(rows)), coordinates_(std::move(coordinates)) {
    for (Vec6Of<Scalar>& row : rows_) {
      const double size = largest_of<Scalar>(row);
      for (int i = 0; size > 0.0 && i < 6; ++i) {
        row[i] = row[i] / size;
      }
    }
    for (auto at = coordinates_.rbegin(); at != coordinates_.rend(); ++at) {
      eliminate(*at);
    }
  }

  // Each with its free coordinate, which is 1.
  std::vector<std::pair<int, Vec6Of<Scalar>>> vectors() const {
    std::vector<std::pair<int, Vec6Of<Scalar>>> result;
    for (const int free : coordinates_) {
      if (std::ranges::find(pivots_, free) != pivots_.end()) {
        continue;
      }
      Vec6Of<Scalar> x = Vec6Of<Scalar>::Zero();
      x[free] = 1.0;
      for (std::size_t r = 0; r < pivots_.size(); ++r) {
        x[pivots_[r]] = -rows_[r][free];
      }
      result.emplace_back(free, x);
    }
    return result;
  }

 private:
  void eliminate(int column) {
    const std::size_t done = pivots_.size();
    const auto size = [&](const Vec6Of<Scalar>& row) { return std::abs(value_of(row[column])); };
    const auto best = std::ranges::max_element(
        rows_.begin() + static_cast<std::ptrdiff_t>(done), rows_.end(), {}, size);
    if (best == rows_.end() || size(*best) <= kRankZero) {
      return;
    }
    std::swap(rows_[done], *best);
    pivots_.push_back(column);
    Vec6Of<Scalar>& pivot = rows_[done];
    const Scalar divisor = pivot[column];
    for (int i = 0; i < 6; ++i) {
      pivot[i] = pivot[i] / divisor;
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const Scalar factor = rows_[r][column];
      for (int i = 0; r != done && i < 6; ++i) {
        rows_[r][i] = rows_[r][i] - factor * pivot[i];
      }
    }
  }

  std::vector<Vec6Of<Scalar>> rows_;
  std::vector<int> coordinates_;
  std::vector<int> pivots_;  ///< the column of each of the first rows
};

// Two vectors, and which of their six coordinates leads.
template <class Scalar>
struct Solution {
  int leading = 0;
  Vec3Of<Scalar> first;
  Vec3Of<Scalar> second;
};

// The independent solutions of first · a + second · b = 0 for all pairs (a, b). The second halves
// count in `length`, so that moments compare with forces.
template <class Scalar>
std::vector<Solution<Scalar>> solve(
    const std::vector<std::pair<Vec3Of<Scalar>, Vec3Of<Scalar>>>& pairs,
    double length,
    std::vector<int> coordinates) {
  std::vector<Vec6Of<Scalar>> rows;
  for (const auto& [a, b] : pairs) {
    Vec6Of<Scalar> row;
    row << a, Scalar(length) * b;
    rows.push_back(row);
  }
  std::vector<Solution<Scalar>> result;
  for (const auto& [leading, x] :
       NullSpace<Scalar>(std::move(rows), std::move(coordinates)).vectors()) {
    Vec3Of<Scalar> first = x.template head<3>();
    Vec3Of<Scalar> second = Scalar(length) * x.template tail<3>();
    using std::sqrt;
    const Scalar size = sqrt((leading < 3 ? first : second).squaredNorm());
    for (int i = 0; i < 3; ++i) {
      first[i] = first[i] / size;
      second[i] = second[i] / size;
    }
    result.push_back({.leading = leading, .first = first, .second = second});
  }
  return result;
}

std::string name_of(int leading, char first, char second) {
  return {leading < 3 ? first : second, static_cast<char>('x' + leading % 3)};
}

template <class Size>
std::vector<int> list_of(const Size& coordinates) {
  return {coordinates.begin(), coordinates.end()};
}

}  // namespace

template <class Scalar>
std::vector<NamedWrenchOf<Scalar>> reciprocal_wrenches(
    const std::vector<NamedTwistOf<Scalar>>& freedoms, bool is_planar, const Vec3In<Scalar>& at) {
  std::vector<std::pair<Vec3Of<Scalar>, Vec3Of<Scalar>>> pairs;
  double length = 0.0;
  for (const NamedTwistOf<Scalar>& freedom : freedoms) {
    pairs.emplace_back(velocity_at(freedom.screw, at), freedom.screw.angular);
    if (freedom.is_rotation) {
      length = std::max(length, values_of<Scalar>(pairs.back().first).norm());
    }
  }
  length = length > 0.0 ? length : 1.0;
  std::vector<NamedWrenchOf<Scalar>> result;
  const auto coordinates = is_planar ? list_of(kPlanarWrench) : list_of(kSpatial);
  for (const auto& one : solve<Scalar>(pairs, length, coordinates)) {
    const Vec3Of<Scalar> moment = one.second + at.cross(one.first);
    result.push_back({.name = name_of(one.leading, 'R', 'T'),
                      .is_couple = one.leading >= 3,
                      .screw = {.moment = moment, .force = one.first}});
  }
  return result;
}

template <class Scalar>
std::vector<NamedTwistOf<Scalar>> reciprocal_twists(
    const std::vector<NamedWrenchOf<Scalar>>& constraints,
    bool is_planar,
    const Vec3In<Scalar>& at) {
  std::vector<std::pair<Vec3Of<Scalar>, Vec3Of<Scalar>>> pairs;
  double length = 0.0;
  for (const NamedWrenchOf<Scalar>& constraint : constraints) {
    pairs.emplace_back(moment_at(constraint.screw, at), constraint.screw.force);
    if (!constraint.is_couple) {
      length = std::max(length, values_of<Scalar>(pairs.back().first).norm());
    }
  }
  length = length > 0.0 ? length : 1.0;
  std::vector<NamedTwistOf<Scalar>> result;
  const auto coordinates = is_planar ? list_of(kPlanarTwist) : list_of(kSpatial);
  for (const auto& one : solve<Scalar>(pairs, length, coordinates)) {
    const Vec3Of<Scalar> linear = one.second + at.cross(one.first);
    result.push_back({.name = name_of(one.leading, 'w', 'v'),
                      .is_rotation = one.leading < 3,
                      .screw = {.angular = one.first, .linear = linear}});
  }
  return result;
}

template std::vector<NamedWrenchOf<double>> reciprocal_wrenches(
    const std::vector<NamedTwistOf<double>>&, bool, const Vec3In<double>&);
template std::vector<NamedWrenchOf<Dual>> reciprocal_wrenches(
    const std::vector<NamedTwistOf<Dual>>&, bool, const Vec3In<Dual>&);
template std::vector<NamedTwistOf<double>> reciprocal_twists(
    const std::vector<NamedWrenchOf<double>>&, bool, const Vec3In<double>&);
template std::vector<NamedTwistOf<Dual>> reciprocal_twists(const std::vector<NamedWrenchOf<Dual>>&,
                                                           bool,
                                                           const Vec3In<Dual>&);
template std::vector<NamedWrenchOf<ExactInput>> reciprocal_wrenches(
    const std::vector<NamedTwistOf<ExactInput>>&, bool, const Vec3In<ExactInput>&);
template std::vector<NamedTwistOf<ExactInput>> reciprocal_twists(
    const std::vector<NamedWrenchOf<ExactInput>>&, bool, const Vec3In<ExactInput>&);

}  // namespace kinestat
