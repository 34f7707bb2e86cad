#include "studies/benchmark/solve_problem.hpp"

#include <algorithm>
#include <utility>

#include "math/dense/dense_methods.hpp"
#include "math/elimination/elimination.hpp"
#include "math/elimination/exact_elimination.hpp"
#include "network/bases.hpp"
#include "network/network_matrices.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// Rotations have moments, translations have none; forces and couples likewise.
Twist scaled(const Twist& screw, double scale) {
  return screw.angular.isZero(0.0)
             ? screw
             : Twist{.angular = screw.angular, .linear = scale * screw.linear};
}

Wrench scaled(const Wrench& screw, double scale) {
  return screw.force.isZero(0.0) ? screw
                                 : Wrench{.moment = scale * screw.moment, .force = screw.force};
}

Twist moved(const Twist& screw, const Vec3& by) {
  return {.angular = screw.angular, .linear = screw.linear + by.cross(screw.angular)};
}

Wrench moved(const Wrench& screw, const Vec3& by) {
  return {.moment = screw.moment + by.cross(screw.force), .force = screw.force};
}

template <class Change>
void change_screws(Geometry& geometry, std::vector<BodyWrench>& loads, const Change& change) {
  for (Twist& screw : geometry.motions) {
    screw = change(screw);
  }
  for (Wrench& screw : geometry.actions) {
    screw = change(screw);
  }
  for (BodyWrench& load : loads) {
    load.wrench = change(load.wrench);
  }
}

// Screws, loads and the coordinates to write them in.
struct Form {
  Geometry geometry;
  std::vector<BodyWrench> loads;
  CoordinateBasis basis;
};

class ProblemMaker {
 public:
  ProblemMaker(const Mechanism& mechanism,
               const Case& which,
               ProblemSide side,
               const Extreme& extreme)
      : mechanism_(mechanism),
        is_motion_(side == ProblemSide::motion),
        primaries_(is_motion_ ? which.motions : which.actions) {
    near_.geometry = mechanism.geometry;
    near_.loads = wrenches_of(which.loads);
    const double scale = extreme.scale;
    change_screws(
        near_.geometry, near_.loads, [&](const auto& screw) { return scaled(screw, scale); });
    near_.geometry.length *= scale;
    near_.basis = is_motion_ ? motion_basis(near_.geometry, mechanism.kinematic_order)
                             : action_basis(near_.geometry, mechanism.static_order, near_.loads);
    far_ = near_;
    far_.basis.unit.setOnes();
    move_away(extreme.distance * near_.geometry.length);
  }

  ProblemAnswer make() {
    if (primaries_.empty() && (is_motion_ || near_.loads.empty())) {
      return {.reason = NoProblem::not_asked, .problem = {}};
    }
    if (unknown_count() > kLargestProblem) {
      return {.reason = NoProblem::too_large, .problem = {}};
    }
    const NoProblem reason = fill_near();
    if (reason != NoProblem::none) {
      return {.reason = reason, .problem = {}};
    }
    fill_far();
    return {.reason = NoProblem::none, .problem = std::move(problem_)};
  }

 private:
  const Topology& topology() const { return mechanism_.topology; }

  int magnitude_count() const {
    return is_motion_ ? topology().freedom_count() : topology().action_count();
  }

  int unknown_count() const { return magnitude_count() - static_cast<int>(primaries_.size()); }

  int column(int magnitude) const {
    return is_motion_ ? velocity_column(topology(), near_.basis, magnitude) : magnitude;
  }

  double unit(int magnitude) const {
    return is_motion_ ? rate_unit(topology(), near_.basis, magnitude)
                      : action_unit(topology(), near_.basis, magnitude);
  }

  bool is_primary(int magnitude) const {
    return std::ranges::any_of(primaries_,
                               [&](const Primary& one) { return one.index == magnitude; });
  }

  SparseMatrix system(const Form& form) const {
    return is_motion_ ? velocity_system(topology(), form.geometry, form.basis)
                      : action_system(topology(), form.geometry, form.basis);
  }

  std::vector<double> right_of(const Form& form) const {
    return is_motion_ ? std::vector<double>()
                      : load_vector(topology().body_count(), form.basis, form.loads);
  }

  // Along those axes alone in which all screws keep to the coordinates of the basis.
  void move_away(double distance) {
    Vec3 by = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = near_.geometry.length * Vec3::Unit(axis);
      if (stays_in_basis(step)) {
        by[axis] = distance;
      }
    }
    change_screws(far_.geometry, far_.loads, [&](const auto& screw) { return moved(screw, by); });
  }

  bool stays_in_basis(const Vec3& step) const {
    const auto holds = [&](const auto& screw) {
      return near_.basis.holds(moved(screw, step).coordinates());
    };
    return is_motion_ ? std::ranges::all_of(near_.geometry.motions, holds)
                      : std::ranges::all_of(near_.geometry.actions, holds) &&
                            std::ranges::all_of(near_.loads, [&](const BodyWrench& load) {
                              return holds(load.wrench);
                            });
  }

  NoProblem fill_near() {
    problem_.matrix = system(near_);
    problem_.right = right_of(near_);
    fill_columns();
    if (problem_.secondary.empty()) {
      return NoProblem::no_unknowns;
    }
    const Elimination factors(problem_.matrix, problem_.last);
    if (!factors.free_columns().empty()) {
      return NoProblem::open;
    }
    if (!factors.is_consistent(problem_.known, problem_.right)) {
      return NoProblem::dependent;
    }
    keep(factors.pivot_rows());
    fill_exact();
    return NoProblem::none;
  }

  // Of redundant equations, which the rounding of their numbers makes contradict each other. Dense
  // methods, which may take others, come no nearer to the solution than that rounding.
  void keep(const std::vector<int>& rows) {
    SparseMatrix& matrix = problem_.matrix;
    std::vector<int> place(static_cast<std::size_t>(matrix.rows), -1);
    std::vector<double> right;
    for (const int row : rows) {
      place[static_cast<std::size_t>(row)] = static_cast<int>(right.size());
      right.push_back(problem_.right.empty() ? 0.0 : problem_.right[static_cast<std::size_t>(row)]);
    }
    for (SparseEntry& entry : matrix.entries) {
      entry.row = place[static_cast<std::size_t>(entry.row)];
    }
    std::erase_if(matrix.entries, [](const SparseEntry& entry) { return entry.row < 0; });
    matrix.rows = static_cast<int>(rows.size());
    problem_.right = problem_.right.empty() ? std::vector<double>() : right;
  }

  void fill_exact() {
    const ExactElimination elimination(exact_matrix(problem_.matrix), problem_.last);
    const std::vector<Rational> known(problem_.known.begin(), problem_.known.end());
    const std::vector<Rational> right(problem_.right.begin(), problem_.right.end());
    const ExactSolution solution = elimination.solve(known, right);
    for (const int c : problem_.secondary) {
      problem_.exact.push_back(solution.x[static_cast<std::size_t>(c)]);
    }
  }

  void fill_columns() {
    for (const Primary& one : primaries_) {
      problem_.last.push_back(column(one.index));
      problem_.known.push_back(one.value / unit(one.index));
    }
    std::vector<double> units;
    for (int m = 0; m < magnitude_count(); ++m) {
      if (!is_primary(m)) {
        problem_.secondary.push_back(column(m));
        units.push_back(unit(m));
      }
    }
    problem_.units = Eigen::Map<const VecX>(units.data(), static_cast<Eigen::Index>(units.size()));
  }

  void fill_far() {
    if (is_motion_) {
      fill_circuits();
    } else {
      fill_bodies();
    }
  }

  // Rows are chosen where the equations are written well.
  void fill_bodies() {
    const std::vector<int> rows =
        independent_rows(system(near_).dense()(Eigen::all, problem_.secondary));
    const MatX all = system(far_).dense();
    const std::vector<double> loads = right_of(far_);
    VecX right = loads.empty() ? VecX(VecX::Zero(all.rows()))
                               : VecX(Eigen::Map<const VecX>(loads.data(), all.rows()));
    for (const Primary& one : primaries_) {
      right -= one.value * all.col(one.index);
    }
    problem_.dense = all(rows, problem_.secondary);
    problem_.dense_right = right(rows);
  }

  void fill_circuits() {
    std::vector<std::string> names;
    for (const Primary& one : primaries_) {
      names.push_back(topology().freedom_name(one.index));
    }
    const std::vector<int> rows = independent_rows(partition_of(M_N(near_), names).front().value);
    const std::vector<LabelledMatrix> parts = partition_of(M_N(far_), names);
    VecX known(static_cast<Eigen::Index>(names.size()));
    for (Eigen::Index i = 0; i < known.size(); ++i) {
      const auto place =
          std::ranges::find(names, parts[1].columns[static_cast<std::size_t>(i)]) - names.begin();
      known[i] = primaries_[static_cast<std::size_t>(place)].value;
    }
    const VecX right = -(parts[1].value * known);
    problem_.dense = parts[0].value(rows, order_of(parts[0].columns));
    problem_.dense_right = right(rows);
  }

  LabelledMatrix M_N(const Form& form) const {
    return motion_matrices(topology(), form.geometry, mechanism_.graph, form.basis).back();
  }

  // Where the secondary freedoms, in the order of the file, stand among the columns of M_NS.
  std::vector<int> order_of(const std::vector<std::string>& columns) const {
    std::vector<int> order;
    for (int f = 0; f < topology().freedom_count(); ++f) {
      const auto at = std::ranges::find(columns, topology().freedom_name(f));
      if (at != columns.end()) {
        order.push_back(static_cast<int>(at - columns.begin()));
      }
    }
    return order;
  }

  const Mechanism& mechanism_;
  bool is_motion_ = true;
  std::vector<Primary> primaries_;
  Form near_;
  Form far_;
  SolveProblem problem_;
};

}  // namespace

ProblemAnswer make_problem(const Mechanism& mechanism,
                           const Case& which,
                           ProblemSide side,
                           const Extreme& extreme) {
  return ProblemMaker(mechanism, which, side, extreme).make();
}

}  // namespace kinestat
