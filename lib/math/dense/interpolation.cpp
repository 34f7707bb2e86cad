#include "math/dense/interpolation.hpp"

#include <algorithm>

#include "core/contract.hpp"

namespace kinestat {

namespace {

// A row of the equations of a spline: below s[i-1] + middle s[i] + above s[i+1] = right.
struct SplineRow {
  double below = 0.0;
  double middle = 1.0;
  double above = 0.0;
  double right = 0.0;
};

// Second derivatives of both cubics at a point are the same (de Boor, A Practical Guide to Splines,
// chapter IV).
SplineRow row_between(const Secant<double>& a, const Secant<double>& b) {
  return {.below = b.width,
          .middle = 2.0 * (a.width + b.width),
          .above = a.width,
          .right = 3.0 * (b.width * a.slope + a.width * b.slope)};
}

// Each row has its largest entry in the middle, so that no rows are exchanged.
std::vector<double> solve_rows(std::vector<SplineRow> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double share = rows[i].below / rows[i - 1].middle;
    rows[i].middle -= share * rows[i - 1].above;
    rows[i].right -= share * rows[i - 1].right;
  }
  std::vector<double> result(rows.size());
  for (std::size_t i = rows.size(); i-- > 0;) {
    const double next = i + 1 < rows.size() ? rows[i].above * result[i + 1] : 0.0;
    result[i] = (rows[i].right - next) / rows[i].middle;
  }
  return result;
}

// The rows are a circle: what leaves the matrix at its corners is a matrix of rank one, taken out
// and brought back (Sherman and Morrison 1950).
std::vector<double> solve_circle(std::vector<SplineRow> rows) {
  const std::size_t last = rows.size() - 1;
  const double corner_of_first = rows.front().below;
  const double corner_of_last = rows.back().above;
  const double gamma = -rows.front().middle;
  std::vector<SplineRow> unit = rows;
  for (auto* list : {&rows, &unit}) {
    list->front().middle -= gamma;
    list->back().middle -= corner_of_first * corner_of_last / gamma;
  }
  for (std::size_t i = 0; i <= last; ++i) {
    unit[i].right = i == 0 ? gamma : i == last ? corner_of_last : 0.0;
  }
  std::vector<double> result = solve_rows(std::move(rows));
  const std::vector<double> around = solve_rows(std::move(unit));
  const double part = corner_of_first / gamma;
  const double share =
      (result.front() + part * result[last]) / (1.0 + around.front() + part * around[last]);
  for (std::size_t i = 0; i <= last; ++i) {
    result[i] -= share * around[i];
  }
  return result;
}

// Two points that go round: the slopes at both follow from the same two chords.
std::vector<double> periodic_slopes(std::span<const double> at, std::span<const double> values) {
  const std::size_t count = at.size() - 1;
  std::vector<SplineRow> rows;
  for (std::size_t i = 0; i < count; ++i) {
    rows.push_back(
        row_between(secant(at, values, i == 0 ? count - 1 : i - 1), secant(at, values, i)));
  }
  std::vector<double> result;
  if (count == 2) {
    // Neighbours on both sides are the same point.
    const double off = rows[0].below + rows[0].above;
    const double other = rows[1].below + rows[1].above;
    const double determinant = rows[0].middle * rows[1].middle - off * other;
    result = {(rows[0].right * rows[1].middle - off * rows[1].right) / determinant,
              (rows[1].right * rows[0].middle - other * rows[0].right) / determinant};
  } else {
    result = solve_circle(std::move(rows));
  }
  result.push_back(result.front());
  return result;
}

}  // namespace

std::size_t interval_of(std::span<const double> at, double x) {
  const auto behind = std::ranges::upper_bound(at, x);
  const auto i = std::max<std::ptrdiff_t>(behind - at.begin(), 1) - 1;
  return std::min(static_cast<std::size_t>(i), at.size() - 2);
}

std::vector<double> spline_slopes(std::span<const double> at,
                                  std::span<const double> values,
                                  SplineEnds ends) {
  KINESTAT_EXPECTS(at.size() == values.size() && at.size() >= 2);
  if (ends == SplineEnds::periodic) {
    KINESTAT_EXPECTS(at.size() >= 3);
    return periodic_slopes(at, values);
  }
  const std::size_t last = at.size() - 1;
  std::vector<SplineRow> rows(at.size());
  for (std::size_t i = 1; i < last; ++i) {
    rows[i] = row_between(secant(at, values, i - 1), secant(at, values, i));
  }
  if (ends == SplineEnds::natural) {
    rows.front() = {.middle = 2.0, .above = 1.0, .right = 3.0 * secant(at, values, 0).slope};
    rows.back() = {.below = 1.0, .middle = 2.0, .right = 3.0 * secant(at, values, last - 1).slope};
  }
  return solve_rows(std::move(rows));
}

std::vector<double> monotone_slopes(std::span<const double> at,
                                    std::span<const double> values,
                                    bool is_periodic) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < at.size(); ++i) {
    slopes.push_back(monotone_slope(at, values, i));
  }
  if (is_periodic) {
    slopes.front() =
        monotone_slope_between(secant(at, values, at.size() - 2), secant(at, values, 0));
    slopes.back() = slopes.front();
  }
  return slopes;
}

CurvePoint interpolated(std::span<const double> at,
                        std::span<const double> values,
                        std::span<const double> slopes,
                        double x) {
  const std::size_t i = interval_of(at, x);
  const Secant<double> one = secant(at, values, i);
  const double t = (x - at[i]) / one.width;
  if (slopes.empty()) {
    return {.value = values[i] + t * (values[i + 1] - values[i]), .slope = one.slope, .bend = 0.0};
  }
  const double from = slopes[i] - one.slope;
  const double to = slopes[i + 1] - one.slope;
  return {.value = hermite(values[i], one, slopes[i], slopes[i + 1], t),
          .slope = one.slope + from * (1.0 - t) * (1.0 - 3.0 * t) - to * t * (2.0 - 3.0 * t),
          .bend = (from * (6.0 * t - 4.0) + to * (6.0 * t - 2.0)) / one.width};
}

}  // namespace kinestat
