#include "studies/shift/shift_state.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "studies/shift/internal/remaining_motion.hpp"

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
      fill_shares();
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
  bool refuse(ShiftClass kind, ShiftCause cause, std::optional<std::size_t> which = {}) {
    state_.kind = kind;
    state_.cause = cause;
    state_.which = which ? static_cast<int>(*which) : -1;
    return false;
  }

  bool is_engaged(std::size_t element) const {
    return std::ranges::find(engaged_, static_cast<int>(element)) != engaged_.end();
  }

  const RateRow& row_of(int element) const {
    return network_.elements[static_cast<std::size_t>(element)];
  }

  void engage() {
    for (const int element : engaged_) {
      if (!left_.prescribe(row_of(element), 0.0)) {
        state_.surplus.push_back(element);
      }
    }
    state_.freedom = left_.count();
    engaged_motion_ = left_;
  }

  bool move_inputs() {
    for (std::size_t i = 0; i < network_.inputs.size(); ++i) {
      const RateRow& row = network_.inputs[i];
      const double speed = plan_.inputs[i].speed;
      if (plan_.is_hybrid()) {
        if (left_.prescribe(row, speed)) {
          state_.moving.push_back(static_cast<int>(i));
        }
        continue;
      }
      if (speed != 0.0 && !left_.changes(row) && state_.moving.empty()) {
        return refuse(ShiftClass::locked_by_elements, ShiftCause::input_held, i);
      }
      if (left_.prescribe(row, speed)) {
        state_.moving.push_back(static_cast<int>(i));
      } else if (const double rate = left_.rate(row).value;
                 std::abs(rate - speed) > kConsistency * std::abs(speed)) {
        return refuse(ShiftClass::locked_by_elements,
                      rate == 0.0 ? ShiftCause::input_held : ShiftCause::inputs_coupled,
                      i);
      }
    }
    state_.idle = left_.count();
    return !plan_.is_hybrid() || !state_.moving.empty() ||
           refuse(ShiftClass::locked_by_elements, ShiftCause::input_held, 0);
  }

  bool outputs_follow() {
    for (std::size_t o = 0; o < network_.outputs.size(); ++o) {
      if (left_.changes(network_.outputs[o])) {
        return refuse(ShiftClass::neutral, ShiftCause::output_free, o);
      }
    }
    return true;
  }

  bool outputs_move() {
    return std::ranges::any_of(network_.outputs,
                               [&](const RateRow& row) { return left_.rate(row).value != 0.0; }) ||
           refuse(ShiftClass::locked_by_elements, ShiftCause::outputs_held);
  }

  bool is_no_tie_up() {
    const bool is_more = static_cast<int>(engaged_.size()) > network_.needed();
    return is_more && !state_.surplus.empty()
               ? refuse(ShiftClass::tie_up,
                        ShiftCause::redundant,
                        static_cast<std::size_t>(state_.surplus.front()))
               : true;
  }

  void fill_rates() {
    for (std::size_t i = 0; i < plan_.inputs.size(); ++i) {
      state_.inputs.push_back(plan_.is_hybrid() ? left_.rate(network_.inputs[i]).zeroed()
                                                : plan_.inputs[i].speed);
    }
    for (const RateRow& row : network_.outputs) {
      state_.outputs.push_back(left_.rate(row).value);
    }
    for (std::size_t e = 0; e < network_.elements.size(); ++e) {
      const RateRow& row = network_.elements[e];
      const bool is_open = !is_engaged(e);
      state_.slips.push_back(is_open && left_.changes(row)
                                 ? std::nullopt
                                 : std::optional(is_open ? left_.rate(row).value : 0.0));
    }
  }

  void fill_shares() {
    find_reactions();
    if (!plan_.has_shares(state_.moving)) {
      return;
    }
    state_.shares.assign(network_.outputs.size(), std::vector<double>(network_.inputs.size(), 0.0));
    for (const int one : state_.moving) {
      RemainingMotion motion = engaged_motion_;
      for (const int other : state_.moving) {
        motion.prescribe(network_.inputs[at(other)], other == one ? 1.0 : 0.0);
      }
      for (std::size_t o = 0; o < network_.outputs.size(); ++o) {
        state_.shares[o][at(one)] = motion.rate(network_.outputs[o]).zeroed();
      }
    }
  }

  // The speeds of what reacts.
  void find_reactions() {
    for (const int other : plan_.reacting) {
      const RateRow& row = network_.others[at(other)];
      ShiftReaction one{.other = other};
      if (!left_.changes(row)) {
        one.rate = left_.rate(row).zeroed();
        one.speed_shares.assign(network_.inputs.size(), 0.0);
        for (const int input : state_.moving) {
          RemainingMotion motion = engaged_motion_;
          for (const int i : state_.moving) {
            motion.prescribe(network_.inputs[at(i)], i == input ? 1.0 : 0.0);
          }
          one.speed_shares[at(input)] = motion.rate(row).zeroed();
        }
      }
      state_.reactions.push_back(std::move(one));
    }
  }

  // An idle motion that moves open elements alone says that their torques do no work on it: one of
  // them follows from the others. (Virtual power.)
  void find_unloaded() {
    for (std::size_t e = 0; e < network_.elements.size(); ++e) {
      if (!is_engaged(e) && left_.prescribe(network_.elements[e], 0.0)) {
        state_.unloaded.push_back(static_cast<int>(e));
      }
    }
    for (std::size_t o = 0; o < network_.others.size(); ++o) {
      if (left_.prescribe(network_.others[o], 0.0)) {
        state_.unloaded_others.push_back(static_cast<int>(o));
      }
    }
  }

  // Rows of what bears an unknown torque: engaged elements, inputs and outputs.
  std::vector<const RateRow*> unknown_rows() const {
    std::vector<const RateRow*> rows;
    for (const int element : engaged_) {
      rows.push_back(&row_of(element));
    }
    for (std::size_t i = 0; i < network_.inputs.size(); ++i) {
      if (!action_of(i)) {
        rows.push_back(&network_.inputs[i]);
      }
    }
    for (const RateRow& output : network_.outputs) {
      rows.push_back(&output);
    }
    return rows;
  }

  // A machine reacts with what the others leave for it to hold: those whose torque is unknown at
  // rest, it may still move.
  void add_reacting(std::vector<const RateRow*>& rows) {
    RemainingMotion motion(network_.net_freedom());
    for (const RateRow* row : rows) {
      motion.prescribe(*row, 0.0);
    }
    for (ShiftReaction& one : state_.reactions) {
      const RateRow& row = network_.others[at(one.other)];
      if (motion.prescribe(row, 0.0)) {
        rows.push_back(&row);
        one.torque_shares.assign(network_.inputs.size(), 0.0);
      } else {
        one.torque = 0.0;
      }
    }
  }

  // Virtual power: in the motion that moves one unknown torque alone, it gives what the known ones
  // take. Empty where the motion of one follows from the others, so that the torque is open.
  void find_torques() {
    std::vector<const RateRow*> rows = unknown_rows();
    const std::size_t first_reacting = rows.size();
    const std::size_t first_output = rows.size() - network_.outputs.size();
    add_reacting(rows);
    std::vector<double> torques;
    std::vector<std::vector<double>> shares;
    for (std::size_t u = 0; u < rows.size(); ++u) {
      RemainingMotion motion(network_.net_freedom());
      for (std::size_t other = 0; other < rows.size(); ++other) {
        if (other != u && !motion.prescribe(*rows[other], 0.0)) {
          return leave_reactions_open();
        }
      }
      if (!motion.prescribe(*rows[u], 1.0) || works_on_rest(motion)) {
        return leave_reactions_open();
      }
      torques.push_back(-power_of_known(motion));
      if (plan_.is_hybrid() && u >= first_output) {
        shares.push_back(shares_in(motion));
      }
    }
    if (!rows.empty()) {
      fill_torques(torques);
    }
    fill_reactions(std::span(torques).subspan(std::min(first_reacting, torques.size())), shares);
  }

  void leave_reactions_open() {
    for (ShiftReaction& one : state_.reactions) {
      one.torque.reset();
      one.torque_shares.clear();
    }
  }

  // What a torque is of those of the inputs, if the motion moves it alone, at unit rate.
  std::vector<double> shares_in(const RemainingMotion& motion) const {
    std::vector<double> shares;
    for (const RateRow& row : network_.inputs) {
      const double rate = motion.rate(row).zeroed();
      shares.push_back(rate == 0.0 ? 0.0 : -rate);
    }
    return shares;
  }

  // Outputs first.
  void fill_reactions(std::span<const double> torques,
                      const std::vector<std::vector<double>>& shares) {
    if (shares.empty()) {
      return;
    }
    const auto outputs = static_cast<std::ptrdiff_t>(network_.outputs.size());
    state_.torque_shares.assign(shares.begin(), shares.begin() + outputs);
    std::size_t next = 0;
    for (ShiftReaction& one : state_.reactions) {
      if (!one.torque_shares.empty()) {
        one.torque_shares = shares[network_.outputs.size() + next];
        one.torque = torques[next++];
      }
    }
  }

  // Whether known torques would drive a motion that no unknown one works on.
  bool works_on_rest(const RemainingMotion& motion) const {
    for (std::size_t i = 0; i < network_.inputs.size(); ++i) {
      if (action_of(i).value_or(0.0) != 0.0 && motion.changes(network_.inputs[i])) {
        return true;
      }
    }
    return false;
  }

  double power_of_known(const RemainingMotion& motion) const {
    BoundedNumber sum;
    for (std::size_t i = 0; i < network_.inputs.size(); ++i) {
      if (const std::optional<double> action = action_of(i)) {
        sum = sum + BoundedNumber{.value = *action, .bound = 0.0} * motion.rate(network_.inputs[i]);
      }
    }
    return sum.zeroed();
  }

  void fill_torques(const std::vector<double>& torques) {
    std::size_t next = 0;
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
    if (plan_.asks_actions || !drives) {
      return plan_.is_hybrid() && !one.action ? std::optional(0.0) : one.action;
    }
    return std::copysign(1.0, one.speed);
  }

  void forget_torques() {
    state_.torques.clear();
    state_.input_torques.clear();
    state_.output_torques.clear();
    for (ShiftReaction& one : state_.reactions) {
      one.torque.reset();
    }
  }

  void check_freewheels() {
    for (std::size_t e = 0; e < plan_.elements.size(); ++e) {
      const int holds = plan_.elements[e].one_way;
      if (holds == 0 || state_.kind != ShiftClass::gear) {
        continue;
      }
      if (!is_engaged(e)) {
        if (holds * state_.slips[e].value_or(0.0) < 0.0) {
          refuse(ShiftClass::tie_up, ShiftCause::freewheel_locks, e);
        }
      } else if (state_.torques.empty()) {
        state_.open_freewheels.push_back(static_cast<int>(e));
      } else if (holds * state_.torques[e] < 0.0) {
        refuse(ShiftClass::neutral, ShiftCause::freewheel_overruns, e);
      }
    }
  }

  const ShiftNetwork& network_;
  const ShiftPlan& plan_;
  std::span<const int> engaged_;
  RemainingMotion left_;
  RemainingMotion engaged_motion_ = left_;  ///< with the elements engaged and no input prescribed
  ShiftState state_;
};

// Whether the inputs move with `engaged` alone, and all of `open` slip with them in the sense in
// which a freewheel overruns.
bool overruns(const ShiftNetwork& network,
              const ShiftPlan& plan,
              std::span<const int> engaged,
              std::span<const int> open) {
  RemainingMotion left(network.net_freedom());
  for (const int element : engaged) {
    (void)left.prescribe(network.elements[at(element)], 0.0);
  }
  for (std::size_t i = 0; i < network.inputs.size(); ++i) {
    const double speed = plan.inputs[i].speed;
    const bool moves = left.prescribe(network.inputs[i], speed);
    const double rate = left.rate(network.inputs[i]).value;
    if (!moves && !plan.is_hybrid() && std::abs(rate - speed) > kConsistency * std::abs(speed)) {
      return false;
    }
  }
  return std::ranges::all_of(open, [&](int e) {
    const RateRow& row = network.elements[at(e)];
    return !left.changes(row) && plan.elements[at(e)].one_way * left.rate(row).value > 0.0;
  });
}

// Subsets of the engaged freewheels, each once and small ones first, until `is_it` answers yes. No
// more can stay behind, and hold, than there are freedoms.
template <typename IsIt>
std::vector<int> find_freewheels(const ShiftPlan& plan,
                                 std::span<const int> engaged,
                                 int net_freedom,
                                 IsIt is_it) {
  std::vector<int> freewheels;
  std::ranges::copy_if(engaged, std::back_inserter(freewheels), [&plan](int element) {
    return plan.elements[at(element)].one_way != 0;
  });
  const std::size_t held = std::min(freewheels.size(), at(net_freedom));
  for (std::size_t size = std::max<std::size_t>(1, freewheels.size() - held);
       size <= freewheels.size();
       ++size) {
    std::vector<bool> is_chosen(freewheels.size());
    std::fill_n(is_chosen.begin(), size, true);
    do {
      std::vector<int> open;
      std::vector<int> others;
      for (const int element : engaged) {
        const auto found = std::ranges::find(freewheels, element);
        const bool opens = found != freewheels.end() &&
                           is_chosen[static_cast<std::size_t>(found - freewheels.begin())];
        (opens ? open : others).push_back(element);
      }
      if (is_it(others, open)) {
        return open;
      }
    } while (std::prev_permutation(is_chosen.begin(), is_chosen.end()));
  }
  return {};
}

// What the others make where engaged freewheels overrun: a gear, if any of these let one be; or
// else what is left where an input that they would hold moves on.
std::optional<ShiftState> solve_overrunning(const ShiftNetwork& network,
                                            const ShiftPlan& plan,
                                            std::span<const int> engaged,
                                            ShiftCause cause) {
  std::optional<ShiftState> state;
  const auto is_gear = [&](const std::vector<int>& others, const std::vector<int>&) {
    state = StateSolver(network, plan, others).run();
    return state->kind == ShiftClass::gear;
  };
  const auto lets_go = [&](const std::vector<int>& others, const std::vector<int>& freewheels) {
    state = StateSolver(network, plan, others).run();
    return overruns(network, plan, others, freewheels);
  };
  std::vector<int> open = find_freewheels(plan, engaged, network.net_freedom(), is_gear);
  if (open.empty() && cause == ShiftCause::input_held) {
    open = find_freewheels(plan, engaged, network.net_freedom(), lets_go);
  }
  if (open.empty()) {
    return std::nullopt;
  }
  state->overrunning = open;
  if (state->kind == ShiftClass::neutral) {
    state->cause = ShiftCause::freewheel_overruns;
    state->which = open.front();
  }
  return state;
}

}  // namespace

ShiftState solve_shift_state(const ShiftNetwork& network,
                             const ShiftPlan& plan,
                             std::span<const int> engaged) {
  ShiftState state = StateSolver(network, plan, engaged).run();
  const bool may_overrun =
      state.cause == ShiftCause::input_held || state.cause == ShiftCause::outputs_held ||
      state.cause == ShiftCause::freewheel_overruns || state.cause == ShiftCause::freewheel_locks;
  if (may_overrun) {
    return solve_overrunning(network, plan, engaged, state.cause).value_or(std::move(state));
  }
  return state;
}

}  // namespace kinestat
