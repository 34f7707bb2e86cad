#include "studies/synthesis/dyads/internal/condition_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract.hpp"
#include "core/synthesis_tolerance.hpp"
#include "math/numbers/big_float.hpp"

namespace kinestat {

namespace {

template <class Scalar>
double size_of(const Scalar& x, const Scalar& y) {
  return std::hypot(static_cast<double>(x), static_cast<double>(y));
}

template <class Scalar>
class RowMaker {
 public:
  RowMaker(std::span<const PositionJetsOf<Scalar>> positions, double unit)
      : positions_(positions), unit_(unit) {}

  ConditionRowsOf<Scalar> run() {
    find_origin();
    for (const PositionJetsOf<Scalar>& position : positions_) {
      displacements_.push_back(displacement_jets(positions_[0], position, system_.x, system_.y));
    }
    system_.length = Scalar(find_length());
    system_.radius /= static_cast<double>(system_.length);
    for (std::size_t j = 0; j < positions_.size(); ++j) {
      add_rows(j);
    }
    return std::move(system_);
  }

 private:
  void find_origin() {
    Scalar x(0);
    Scalar y(0);
    for (const PositionJetsOf<Scalar>& position : positions_) {
      x += position.x[0];
      y += position.y[0];
    }
    system_.x = x / static_cast<double>(positions_.size());
    system_.y = y / static_cast<double>(positions_.size());
    double radius = 0.0;
    for (const PositionJetsOf<Scalar>& position : positions_) {
      radius = std::max(
          radius, size_of(Scalar(position.x[0] - system_.x), Scalar(position.y[0] - system_.y)));
    }
    system_.radius = radius;
  }

  // The least lever arm D / (1 - E) of all rows, but not below the spread of the positions. Higher
  // derivatives count only where the lower ones leave nothing to go by.
  double find_length() const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    double lever = std::min(least_lever(0), least_lever(1));
    for (std::size_t k = 2; k < 5 && lever == kNone; ++k) {
      lever = least_lever(k);
    }
    if (lever == kNone) {
      return system_.radius > 0.0 ? system_.radius : 1.0;
    }
    const double bounded =
        system_.radius > 0.0 ? std::min(lever, kLongestLever * system_.radius) : lever;
    return std::max(bounded, system_.radius);
  }

  // Over all positions that have a derivative k; infinite if none moves and turns.
  double least_lever(std::size_t k) const {
    double lever = std::numeric_limits<double>::infinity();
    for (const DisplacementJetsOf<Scalar>& d : displacements_) {
      if (k >= d.x.size()) {
        continue;
      }
      const double turn = k == 0 ? size_of(d.versine, d.sine[0]) : size_of(d.cosine[k], d.sine[k]);
      const double shift = size_of(d.x[k], d.y[k]);
      lever = turn > 0.0 && shift > 0.0 ? std::min(lever, shift / turn) : lever;
    }
    return lever;
  }

  // Rounding of what is given for position j and the first, relative to the system's units.
  double rounding(std::size_t j) const {
    const PositionJetsOf<Scalar>& one = positions_[0];
    const PositionJetsOf<Scalar>& other = positions_[j];
    const double length = static_cast<double>(system_.length);
    const double places = (size_of(one.x[0], one.y[0]) + size_of(other.x[0], other.y[0])) / length;
    const double angles =
        std::abs(static_cast<double>(one.angle[0])) + std::abs(static_cast<double>(other.angle[0]));
    return unit_ * (places + angles * (1.0 + system_.radius));
  }

  void add_rows(std::size_t j) {
    using std::abs;
    DisplacementJetsOf<Scalar> d = displacements_[j];
    for (std::size_t k = 0; k < d.x.size(); ++k) {
      d.x[k] /= system_.length;
      d.y[k] /= system_.length;
    }
    for (std::size_t k = j == 0 ? 1 : 0; k < d.x.size(); ++k) {
      std::array<Scalar, 7> row = condition_row(d, k);
      Scalar largest(0);
      for (const Scalar& entry : row) {
        largest = std::max(largest, Scalar(abs(entry)));
      }
      // The first position has no displacement; its derivatives feel the centre only through E.
      const double turns = k == 0 ? 1.0 : size_of(d.cosine[k], d.sine[k]);
      // A displacement within rounding is none: the position is there twice.
      const double size = k == 0 && static_cast<double>(largest) <= 0.5 * rounding(j)
                              ? 0.0
                              : static_cast<double>(largest);
      system_.noise.push_back(size > 0.0 ? unit_ + rounding(j) * turns / size : 1.0);
      system_.slopes.push_back(size > 0.0 ? std::max(turns, 1.0) / size : 1.0);
      for (Scalar& entry : row) {
        entry = size > 0.0 ? Scalar(entry / largest) : Scalar(0);
      }
      system_.rows.push_back(row);
    }
  }

  std::span<const PositionJetsOf<Scalar>> positions_;
  double unit_;
  std::vector<DisplacementJetsOf<Scalar>> displacements_;
  ConditionRowsOf<Scalar> system_;
};

}  // namespace

template <class Scalar>
ConditionRowsOf<Scalar> make_condition_rows(std::span<const PositionJetsOf<Scalar>> positions,
                                            double unit) {
  KINESTAT_EXPECTS(!positions.empty());
  return RowMaker<Scalar>(positions, unit).run();
}

template ConditionRowsOf<double> make_condition_rows(
    std::span<const PositionJetsOf<double>> positions, double unit);
template ConditionRowsOf<BigFloat> make_condition_rows(
    std::span<const PositionJetsOf<BigFloat>> positions, double unit);

}  // namespace kinestat
