#include "shift/shift_state.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/dense_solve.hpp"
#include "shift/internal/remaining_motion.hpp"

namespace kinestat {

namespace {

class StateSolver {
 public:
  StateSolver(const ShiftNetwork& network, const ShiftPlan& plan, std::span<const int> engaged)
      : network_(network), plan_(plan), engaged_(engaged), left_(network.net_freedom()) {}

  ShiftState run() {
    engage();
    if (move_inputs() && outputs_follow() && outputs_move() && is_no_tie_up()) {
      fill_rates();
      find_unloaded();
      find_torques();
      check_freewheels();
      if (!plan_.asks_actions) {
        forget_torques();
      }
    }
    return std::move(state_);
  }

 private:
  bool refuse(ShiftClass kind, ShiftCause cause, Eigen::Index which = -1) {
    state_.kind = kind;
    state_.cause = cause;
    state_.which = static_cast<int>(which);
    return false;
  }

  bool is_engaged(int element) const {
    return std::ranges::find(engaged_, element) != engaged_.end();
  }

  void engage() {
    for (const int element : engaged_) {
      if (!left_.prescribe(network_.elements.row(element), 0.0)) {
        state_.surplus.push_back(element);
      }
    }
    state_.freedom = left_.count();
  }

  bool move_inputs() {
    for (Eigen::Index i = 0; i < network_.inputs.rows(); ++i) {
      const double speed = plan_.inputs[static_cast<std::size_t>(i)].speed;
      if (speed != 0.0 && !left_.changes(network_.inputs.row(i)) && state_.moving.empty()) {
        return refuse(ShiftClass::locked, ShiftCause::input_held, i);
      }
      if (left_.prescribe(network_.inputs.row(i), speed)) {
        state_.moving.push_back(static_cast<int>(i));
      } else if (std::abs(left_.rate(network_.inputs.row(i)) - speed) >
                 kConsistency * std::abs(speed)) {
        const bool is_held = left_.rate(network_.inputs.row(i)) == 0.0;
        return refuse(
            ShiftClass::locked, is_held ? ShiftCause::input_held : ShiftCause::inputs_coupled, i);
      }
    }
    state_.idle = left_.count();
    return true;
  }

  bool outputs_follow() {
    for (Eigen::Index o = 0; o < network_.outputs.rows(); ++o) {
      if (left_.changes(network_.outputs.row(o))) {
        return refuse(ShiftClass::neutral, ShiftCause::output_free, o);
      }
    }
    return true;
  }

  bool outputs_move() {
    for (Eigen::Index o = 0; o < network_.outputs.rows(); ++o) {
      if (left_.rate(network_.outputs.row(o)) != 0.0) {
        return true;
      }
    }
    return refuse(ShiftClass::locked, ShiftCause::outputs_held);
  }

  bool is_no_tie_up() {
    const bool is_more = static_cast<int>(engaged_.size()) > network_.needed();
    return is_more && !state_.surplus.empty()
               ? refuse(ShiftClass::tie_up, ShiftCause::redundant, state_.surplus.front())
               : true;
  }

  void fill_rates() {
    for (const ShiftInput& input : plan_.inputs) {
      state_.inputs.push_back(input.speed);
    }
    for (Eigen::Index o = 0; o < network_.outputs.rows(); ++o) {
      state_.outputs.push_back(left_.rate(network_.outputs.row(o)));
    }
    for (Eigen::Index e = 0; e < network_.elements.rows(); ++e) {
      const bool is_open = !is_engaged(static_cast<int>(e));
      state_.slips.push_back(
          is_open && left_.changes(network_.elements.row(e))
              ? std::nullopt
              : std::optional(is_open ? left_.rate(network_.elements.row(e)) : 0.0));
    }
  }

  // An idle motion that moves open elements alone says that their torques do no work on it: one of
  // them follows from the others. (Virtual power.)
  void find_unloaded() {
    for (Eigen::Index e = 0; e < network_.elements.rows(); ++e) {
      if (!is_engaged(static_cast<int>(e)) && left_.prescribe(network_.elements.row(e), 0.0)) {
        state_.unloaded.push_back(static_cast<int>(e));
      }
    }
    for (Eigen::Index o = 0; o < network_.others.rows(); ++o) {
      if (left_.prescribe(network_.others.row(o), 0.0)) {
        state_.unloaded_others.push_back(static_cast<int>(o));
      }
    }
  }

  // Rows of what bears an unknown torque, and what the known torques do in each motion.
  void find_torques() {
    const Eigen::Index motions = network_.net_freedom();
    VecX work = VecX::Zero(motions);
    std::vector<Eigen::RowVectorXd> unknown;
    for (const int element : engaged_) {
      unknown.push_back(network_.elements.row(element));
    }
    for (Eigen::Index i = 0; i < network_.inputs.rows(); ++i) {
      const std::optional<double> action = action_of(static_cast<std::size_t>(i));
      if (action) {
        work -= *action * network_.inputs.row(i).transpose();
      } else {
        unknown.push_back(network_.inputs.row(i));
      }
    }
    for (Eigen::Index o = 0; o < network_.outputs.rows(); ++o) {
      unknown.push_back(network_.outputs.row(o));
    }
    const auto count = static_cast<Eigen::Index>(unknown.size());
    if (count == 0 || count > motions) {
      return;
    }
    MatX powers(motions, count);
    for (Eigen::Index u = 0; u < count; ++u) {
      powers.col(u) = unknown[static_cast<std::size_t>(u)].transpose();
    }
    // Idle motions have no torque that works on them, so that there are more equations.
    const std::optional<VecX> torques =
        count == motions
            ? solve_dense(powers, work)
            : solve_dense(powers.transpose() * powers, VecX(powers.transpose() * work));
    if (torques && (powers * *torques - work).norm() <= kConsistency * work.norm()) {
      fill_torques(*torques);
    }
  }

  void fill_torques(const VecX& torques) {
    Eigen::Index next = 0;
    state_.torques.assign(plan_.elements.size(), 0.0);
    for (const int element : engaged_) {
      state_.torques[static_cast<std::size_t>(element)] = torques[next++];
    }
    for (std::size_t i = 0; i < plan_.inputs.size(); ++i) {
      const std::optional<double> action = action_of(i);
      state_.input_torques.push_back(action ? *action : torques[next++]);
    }
    for (std::size_t o = 0; o < plan_.outputs.size(); ++o) {
      state_.output_torques.push_back(torques[next++]);
    }
  }

  // The action of an input. Where the file gives none, the first one that moves is taken to drive,
  // so that torques have a sense.
  std::optional<double> action_of(std::size_t input) const {
    const ShiftInput& one = plan_.inputs[input];
    const auto driver = std::ranges::find_if(
        plan_.inputs, [](const ShiftInput& each) { return each.speed != 0.0; });
    const bool drives = driver == plan_.inputs.begin() + static_cast<std::ptrdiff_t>(input);
    return plan_.asks_actions || !drives ? one.action
                                         : std::optional(std::copysign(1.0, one.speed));
  }

  void forget_torques() {
    state_.torques.clear();
    state_.input_torques.clear();
    state_.output_torques.clear();
  }

  // What is smaller than rounding of the largest has no sign.
  static double sign_of(double value, double largest) {
    return std::abs(value) <= kRankZero * largest ? 0.0 : (value > 0.0 ? 1.0 : -1.0);
  }

  void check_freewheels() {
    double most_torque = 0.0;
    for (const double torque : state_.torques) {
      most_torque = std::max(most_torque, std::abs(torque));
    }
    double most_slip = 0.0;
    for (const std::optional<double>& slip : state_.slips) {
      most_slip = std::max(most_slip, std::abs(slip.value_or(0.0)));
    }
    for (std::size_t e = 0; e < plan_.elements.size(); ++e) {
      const int holds = plan_.elements[e].one_way;
      if (holds == 0 || state_.kind != ShiftClass::gear) {
        continue;
      }
      const auto element = static_cast<Eigen::Index>(e);
      if (!is_engaged(static_cast<int>(e))) {
        if (state_.slips[e] && holds * sign_of(*state_.slips[e], most_slip) < 0.0) {
          refuse(ShiftClass::tie_up, ShiftCause::freewheel_engages, element);
        }
      } else if (state_.torques.empty()) {
        state_.open_freewheels.push_back(static_cast<int>(e));
      } else if (holds * sign_of(state_.torques[e], most_torque) < 0.0) {
        refuse(ShiftClass::neutral, ShiftCause::freewheel_lets_go, element);
      }
    }
  }

  const ShiftNetwork& network_;
  const ShiftPlan& plan_;
  std::span<const int> engaged_;
  RemainingMotion left_;
  ShiftState state_;
};

}  // namespace

ShiftState solve_shift_state(const ShiftNetwork& network,
                             const ShiftPlan& plan,
                             std::span<const int> engaged) {
  return StateSolver(network, plan, engaged).run();
}

}  // namespace kinestat
