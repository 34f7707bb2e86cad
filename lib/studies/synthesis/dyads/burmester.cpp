#include "studies/synthesis/dyads/burmester.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/synthesis_tolerance.hpp"
#include "math/dense/conic_intersection.hpp"
#include "studies/synthesis/dyads/internal/condition_rows.hpp"
#include "studies/synthesis/dyads/internal/condition_space.hpp"
#include "studies/synthesis/dyads/internal/dyad_point.hpp"

namespace kinestat {

namespace {

Mat3 symmetric_product(const Vec3& a, const Vec3& b) {
  return 0.5 * (a * b.transpose() + b * a.transpose());
}

class Solver {
 public:
  Solver(std::span<const PositionJets> positions, const LastDecimal& decimal)
      : positions_(positions), decimal_(decimal), system_(make_condition_rows(positions)) {}

  BurmesterSolution run() {
    const ConditionSpace space = find_condition_space(system_, positions_);
    loss_ = space.loss;
    solution_.status = space.status;
    solution_.reason = space.reason;
    solution_.reciprocal_condition = space.reciprocal_condition;
    solution_.digits = space.digits;
    if (space.status == BurmesterStatus::solved) {
      intersect(space.space.basis);
      sort_dyads(solution_.dyads);
    }
    return std::move(solution_);
  }

 private:
  void set_family(Degeneracy reason) {
    solution_.status = BurmesterStatus::family;
    solution_.reason = reason;
  }

  void intersect(const MatX& basis) {
    const auto n = [&](Eigen::Index i) { return Vec3(basis.row(i).transpose()); };
    // p h = a u + b v and q h = b u - a v.
    const Mat3 first = symmetric_product(n(4), n(6)) - symmetric_product(n(0), n(2)) -
                       symmetric_product(n(1), n(3));
    const Mat3 second = symmetric_product(n(5), n(6)) - symmetric_product(n(0), n(3)) +
                        symmetric_product(n(1), n(2));
    const ConicIntersection shared = intersect_conics(first, second);
    for (const ConicPoint& point : shared.points) {
      add_point(point, basis);
    }
    if (shared.shared == SharedPart::conic) {
      set_family(Degeneracy::shared_conic);
    } else if (shared.shared == SharedPart::line) {
      set_family(find_line_reason(shared.shared_line, basis));
    }
  }

  void add_point(const ConicPoint& point, const MatX& basis) {
    const Eigen::Matrix<double, 7, 1> x = basis * point.y.real();
    // A double point moves by the root of what moves the conics.
    const double loss = point.multiplicity > 1 ? std::sqrt(loss_) : loss_ * point.condition;
    std::optional<Dyad> dyad = dyad_of(x, system_, positions_[0], loss);
    if (!point.is_real) {
      solution_.imaginary_count += point.multiplicity;
      keep_nearest(dyad, point.y.imag().cwiseAbs().maxCoeff());
      return;
    }
    if (!dyad) {
      set_family(Degeneracy::translation);
      return;
    }
    dyad->digits = digits_of(loss / smallest_denominator(x, dyad->kind));
    if (dyad->length > kLongCrank * system_.length) {
      dyad = find_straight(x, straight_conditions(system_), decimal_, system_, positions_[0])
                 .value_or(*dyad);
    }
    dyad->multiplicity = point.multiplicity;
    dyad->residual = find_residual(*dyad, positions_);
    solution_.dyads.push_back(*dyad);
  }

  void keep_nearest(std::optional<Dyad> dyad, double imaginary) {
    if (dyad && (!solution_.nearest || imaginary < least_imaginary_)) {
      dyad->residual = find_residual(*dyad, positions_);
      solution_.nearest = dyad;
      least_imaginary_ = imaginary;
    }
  }

  // A line of solutions on which h vanishes has its centres, or its circle points, at infinity.
  static Degeneracy find_line_reason(const Vec3& line, const MatX& basis) {
    const Vec3 p = line.unitOrthogonal();
    const Vec3 q = line.cross(p);
    const Eigen::Matrix<double, 7, 1> x = basis * p;
    const Eigen::Matrix<double, 7, 1> y = basis * q;
    if (std::max(std::abs(x[6]), std::abs(y[6])) > kRealPoint) {
      return Degeneracy::shared_line;
    }
    const double circle_points = x.head<2>().norm() + y.head<2>().norm();
    const double centres = x.segment<2>(2).norm() + y.segment<2>(2).norm();
    return centres >= circle_points ? Degeneracy::straight_paths : Degeneracy::sliding_lines;
  }

  std::span<const PositionJets> positions_;
  LastDecimal decimal_;
  ConditionRows system_;
  BurmesterSolution solution_;
  double loss_ = 0.0;
  double least_imaginary_ = 0.0;  // of the nearest dyad
};

}  // namespace

std::string_view word_of(BurmesterStatus status) {
  switch (status) {
    case BurmesterStatus::solved:
      return "solved";
    case BurmesterStatus::family:
      return "family";
    case BurmesterStatus::no_digits:
      return "no_digits";
  }
  return "";
}

BurmesterSolution solve_burmester(std::span<const PositionJets> positions,
                                  const LastDecimal& decimal) {
  KINESTAT_EXPECTS(position_count(positions) == 5);
  return Solver(positions, decimal).run();
}

}  // namespace kinestat
