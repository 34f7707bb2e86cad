#include "synthesis/burmester.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/conic_intersection.hpp"
#include "math/null_space.hpp"
#include "synthesis/internal/condition_rows.hpp"
#include "synthesis/internal/dyad_point.hpp"

namespace kinestat {

namespace {

MatX matrix_of(const ConditionRows& system) {
  MatX matrix(static_cast<Eigen::Index>(system.rows.size()), 7);
  for (std::size_t i = 0; i < system.rows.size(); ++i) {
    for (std::size_t j = 0; j < 7; ++j) {
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = system.rows[i][j];
    }
  }
  return matrix;
}

// What rounding of the positions moves the null space by.
double find_loss(const NullSpace& space, const std::vector<double>& noise) {
  double loss = kEpsilon;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    loss += noise[i] * space.inverse.col(static_cast<Eigen::Index>(i)).norm();
  }
  return loss;
}

double digits_of(double loss) {
  constexpr double kMost = 16.0;
  return std::isnan(loss) ? 0.0 : std::clamp(-std::log10(loss), 0.0, kMost);
}

Mat3 symmetric_product(const Vec3& a, const Vec3& b) {
  return 0.5 * (a * b.transpose() + b * a.transpose());
}

class Solver {
 public:
  explicit Solver(std::span<const PositionJets> positions)
      : positions_(positions), system_(make_condition_rows(positions)) {}

  BurmesterSolution run() {
    const NullSpace space = find_null_space(matrix_of(system_));
    loss_ = find_loss(space, system_.noise);
    solution_.flatness = space.flatness();
    solution_.digits = digits_of(loss_);
    if (!(loss_ < kUselessLoss)) {
      find_why_flat(space);
      return std::move(solution_);
    }
    intersect(space.basis);
    return std::move(solution_);
  }

 private:
  // Rows that depend on each other leave a clear gap in the singular values, and rounding is far
  // below them; positions that close in on each other leave neither.
  void find_why_flat(const NullSpace& space) {
    const VecX& values = space.singular_values;
    double smallest_counted = values[0];
    for (const double value : values) {
      smallest_counted = value > kRankZero * values[0] ? value : smallest_counted;
    }
    const bool is_repeated = std::ranges::any_of(system_.rows, [](const auto& row) {
      return std::ranges::all_of(row, [](double entry) { return entry == 0.0; });
    });
    const bool is_noisy =
        std::ranges::any_of(system_.noise, [](double noise) { return noise > kNoisyRow; });
    const bool is_clear = smallest_counted > kClearGap * values[0] &&
                          values[values.size() - 1] < kCancellation * values[0];
    if (is_repeated) {
      set_family(Degeneracy::repeated_position);
    } else if (!is_noisy && is_clear) {
      set_family(is_translation() ? Degeneracy::translation : Degeneracy::dependent);
    } else {
      solution_.status = BurmesterStatus::no_digits;
    }
  }

  bool is_translation() const {
    return std::ranges::all_of(positions_, [&](const PositionJets& position) {
      const bool stands =
          std::ranges::all_of(position.angle.begin() + 1, position.angle.end(), [](double rate) {
            return std::abs(rate) < kSameAngle;
          });
      return stands && std::abs(position.angle[0] - positions_[0].angle[0]) < kSameAngle;
    });
  }

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
    solution_.shared_gap = shared.gap;
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
    if (!point.is_real) {
      solution_.imaginary_count += point.multiplicity;
      return;
    }
    const Eigen::Matrix<double, 7, 1> x = basis * point.y.real();
    std::optional<Dyad> dyad = dyad_of(x, system_, positions_[0]);
    if (!dyad) {
      set_family(Degeneracy::translation);
      return;
    }
    dyad->multiplicity = point.multiplicity;
    // A double point moves by the root of what moves the conics.
    const double loss = point.multiplicity > 1 ? std::sqrt(loss_) : loss_ * point.condition;
    dyad->digits = digits_of(loss / smallest_denominator(x, dyad->kind));
    dyad->residual = find_residual(*dyad, positions_);
    solution_.dyads.push_back(*dyad);
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
  ConditionRows system_;
  BurmesterSolution solution_;
  double loss_ = 0.0;
};

}  // namespace

std::string_view word_of(Degeneracy reason) {
  switch (reason) {
    case Degeneracy::none:
      return "none";
    case Degeneracy::translation:
      return "translation";
    case Degeneracy::repeated_position:
      return "repeated_position";
    case Degeneracy::dependent:
      return "dependent_positions";
    case Degeneracy::straight_paths:
      return "straight_paths";
    case Degeneracy::sliding_lines:
      return "sliding_lines";
    case Degeneracy::shared_line:
      return "shared_line";
    case Degeneracy::shared_conic:
      return "shared_conic";
  }
  return "";
}

BurmesterSolution solve_burmester(std::span<const PositionJets> positions) {
  KINESTAT_EXPECTS(position_count(positions) == 5);
  return Solver(positions).run();
}

}  // namespace kinestat
