#include "studies/shift/shift_slip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/index.hpp"
#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "dynamics/case_dynamics.hpp"
#include "kinematics/velocity.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "network/bases.hpp"

namespace kinestat {

namespace {

// Which freedoms the equations are written in: input, slip, then those of the engaged elements,
// which rest.
constexpr Eigen::Index kInput = 0;
constexpr Eigen::Index kSlip = 1;

// A sum of products with what rounding may have done to it.
class RoundedSum {
 public:
  void add(double term) {
    sum_ += term;
    terms_ += std::abs(term);
  }

  double value() const { return kinestat::zero_within_bound(sum_, kCancellation * terms_); }

 private:
  double sum_ = 0.0;
  double terms_ = 0.0;
};

// The work of a steady torque on a speed that changes evenly.
double mean(double start, double end) {
  return 0.5 * (start + end);
}

class SlipSolver {
 public:
  SlipSolver(const Mechanism& mechanism,
             const ShiftPlan& plan,
             const ShiftSolution& solution,
             const SlipPlan& asked,
             const Case& loads)
      : mechanism_(mechanism),
        topology_(mechanism.topology),
        plan_(plan),
        solution_(solution),
        asked_(asked),
        loads_(loads) {}

  std::variant<ShiftSlip, SlipObstacle> run() {
    result_.name = asked_.name.text;
    result_.capacity = asked_.capacity;
    const bool is_solved = check_transmission() && find_gears() && find_elements() &&
                           find_motions() && check_loads() && find_start() && check_inertia();
    if (!is_solved) {
      return std::move(obstacle_);
    }
    solve();
    judge_freewheels();
    return std::move(result_);
  }

 private:
  bool refuse(SourceRange where, std::string reason, std::string remedy) {
    obstacle_ = {.name = asked_.name.text,
                 .where = where,
                 .reason = std::move(reason),
                 .remedy = std::move(remedy)};
    return false;
  }

  const std::string& element_name(int element) const {
    const int actuator = plan_.elements[at(element)].actuator;
    return topology_.actuators[at(actuator)].name;
  }

  std::string elements_text(const std::vector<int>& elements) const {
    std::vector<std::string> names;
    for (const int element : elements) {
      names.push_back(fmt::format("'{}'", element_name(element)));
    }
    return names.empty() ? "none" : plain_list(names);
  }

  int freedom_of(int actuator) const { return topology_.actuators[at(actuator)].freedom; }

  bool turns(int actuator) const {
    return topology_.freedoms[at(freedom_of(actuator))].is_rotation;
  }

  bool check_transmission() {
    const bool has_one_each = plan_.inputs.size() == 1 && plan_.outputs.size() == 1;
    if (!has_one_each || !plan_.reacting.empty()) {
      return refuse(asked_.name.where,
                    "it is of one input and one output, and this transmission has more",
                    "leave 'slip' out, or give the transmission without the other machines");
    }
    if (!turns(plan_.inputs.front().actuator) || !turns(plan_.outputs.front())) {
      return refuse(asked_.name.where,
                    "input and output must turn, and one of them slides",
                    "name an actuator of a revolute");
    }
    const auto is_converter = [](const CouplingFriction& one) { return one.converter != nullptr; };
    if (std::ranges::any_of(mechanism_.frictions, is_converter)) {
      return refuse(asked_.name.where,
                    "the torques of its torque converter change with the speeds",
                    "lock the converter, that is, leave it out of the file");
    }
    return true;
  }

  std::optional<int> find_gear(const Name& name) {
    const std::vector<NamedShiftState>& states = solution_.states;
    const auto found = std::ranges::find(states, name.text, &NamedShiftState::name);
    if (found == states.end() || found->state.kind != ShiftClass::gear) {
      std::vector<std::string> gears;
      for (const NamedShiftState& one : states) {
        if (one.state.kind == ShiftClass::gear) {
          gears.push_back(one.name);
        }
      }
      const std::string guess = did_you_mean(name.text, gears);
      refuse(name.where,
             found == states.end()
                 ? fmt::format("'{}' is not a gear", name.text)
                 : fmt::format("'{}' is not a gear: {}", name.text, found->reason),
             fmt::format("gears are {}{}{}", plain_list(gears), guess.empty() ? "" : "; ", guess));
      return std::nullopt;
    }
    return static_cast<int>(found - states.begin());
  }

  const NamedShiftState& state(int index) const { return solution_.states[at(index)]; }

  bool find_gears() {
    const std::optional<int> to = find_gear(asked_.to);
    if (!to) {
      return false;
    }
    result_.to = *to;
    if (asked_.from) {
      result_.from = find_gear(*asked_.from);
      return result_.from.has_value();
    }
    return true;
  }

  // Which element slips, which opens, and which stay engaged.
  bool find_elements() {
    const std::vector<int> after = state(result_.to).holding();
    if (!result_.from) {
      if (!asked_.element && after.size() != 1) {
        return refuse(asked_.where_capacity,
                      fmt::format("gear '{}' engages {}, and which of them slips is not said",
                                  asked_.to.text,
                                  elements_text(after)),
                      fmt::format("name it: capacity: {{{}: …}}",
                                  after.empty() ? "ELEMENT" : element_name(after.front())));
      }
      result_.slips = asked_.element.value_or(after.empty() ? 0 : after.front());
    } else {
      const std::vector<int> before = state(*result_.from).holding();
      std::vector<int> opens;
      std::vector<int> engages;
      std::ranges::set_difference(before, after, std::back_inserter(opens));
      std::ranges::set_difference(after, before, std::back_inserter(engages));
      if (opens.size() != 1 || engages.size() != 1) {
        return refuse(asked_.to.where,
                      fmt::format("from '{}' to '{}' one element must open and one engage: to be "
                                  "opened are {}, to be engaged {}",
                                  asked_.from->text,
                                  asked_.to.text,
                                  elements_text(opens),
                                  elements_text(engages)),
                      "give the change as several, by way of gears between them");
      }
      result_.opens = opens.front();
      result_.slips = engages.front();
    }
    return check_slipping(after);
  }

  bool check_slipping(const std::vector<int>& after) {
    const bool is_right = !asked_.element || *asked_.element == result_.slips;
    if (!is_right || !std::ranges::binary_search(after, result_.slips)) {
      return refuse(asked_.where_capacity,
                    result_.from ? fmt::format("'{}' engages, not '{}'",
                                               element_name(result_.slips),
                                               element_name(asked_.element.value_or(0)))
                                 : fmt::format("gear '{}' does not engage '{}'",
                                               asked_.to.text,
                                               element_name(result_.slips)),
                    "'capacity' is that of the element that engages");
    }
    if (plan_.elements[at(result_.slips)].one_way != 0) {
      return refuse(asked_.where_capacity,
                    fmt::format("'{}' is a freewheel, which slips without torque",
                                element_name(result_.slips)),
                    "the slip of a change is that of a clutch or brake");
    }
    std::ranges::copy_if(
        after, std::back_inserter(engaged_), [&](int e) { return e != result_.slips; });
    const int left = solution_.net_freedom - static_cast<int>(engaged_.size());
    if (left != 2) {
      return refuse(
          asked_.to.where,
          fmt::format(
              "{} freedoms remain while '{}' slips, and there must be two, those of input and slip",
              left,
              element_name(result_.slips)),
          "lock what is free, or leave out bodies that only turn along with others");
    }
    return true;
  }

  std::vector<Primary> knowns(double input, double slip) const {
    std::vector<Primary> list = {{.index = freedom_of(plan_.inputs.front().actuator),
                                  .value = input,
                                  .given = {},
                                  .where = {}},
                                 {.index = freedom_of(plan_.elements[at(result_.slips)].actuator),
                                  .value = slip,
                                  .given = {},
                                  .where = {}}};
    for (const int element : engaged_) {
      list.push_back({.index = freedom_of(plan_.elements[at(element)].actuator),
                      .value = 0.0,
                      .given = {},
                      .where = {}});
    }
    return list;
  }

  // The motions of which all others are sums: each freedom at unit rate, the others at rest.
  bool find_motions() {
    const CoordinateBasis basis = motion_basis(mechanism_.geometry, mechanism_.kinematic_order);
    for (std::size_t j = 0; j < 2 + engaged_.size(); ++j) {
      std::vector<Primary> unit = knowns(0.0, 0.0);
      unit[j].value = 1.0;
      motions_.push_back(solve_velocity(mechanism_, basis, unit));
      if (motions_.back().status != SolveStatus::solved) {
        return refuse(asked_.name.where,
                      fmt::format("input and slip of '{}' do not say how the train moves",
                                  element_name(result_.slips)),
                      "lock what is free, or leave out bodies that only turn along with others");
      }
    }
    return true;
  }

  double rate_in(Eigen::Index motion, int actuator) const {
    return motions_[static_cast<std::size_t>(motion)].rates[at(freedom_of(actuator))];
  }

  double output_in(Eigen::Index motion) const { return rate_in(motion, plan_.outputs.front()); }

  // What acts on the freedoms beside the element that slips.
  bool check_loads() {
    if (!mechanism_.springs.empty() || loads_.follows_curves()) {
      return refuse(asked_.name.where,
                    fmt::format("the torques of {} change while the train turns",
                                mechanism_.springs.empty() ? "its curves" : "its springs"),
                    "leave them out: the torques of input and output are steady");
    }
    const std::size_t count = motions_.size();
    std::vector<RoundedSum> sums(count);
    for (std::size_t j = 0; j < count; ++j) {
      const auto motion = static_cast<Eigen::Index>(j);
      sums[j].add(motion == kInput ? asked_.input_action : 0.0);
      sums[j].add(asked_.output_action * output_in(motion));
    }
    for (const Load& load : loads_.loads) {
      for (std::size_t j = 0; j < count; ++j) {
        const Twist& twist = motions_[j].bodies[at(load.acts.body.value)];
        RoundedSum of_force;
        for (Eigen::Index i = 0; i < 3; ++i) {
          of_force.add(load.acts.wrench.force[i] * twist.linear[i]);
          (load.point ? of_force : sums[j]).add(load.acts.wrench.moment[i] * twist.angular[i]);
        }
        if (of_force.value() != 0.0) {
          return refuse(
              load.where,
              fmt::format("load '{}' does work that changes while the train turns", load.name),
              "give the load as a couple about the axis, or leave it out");
        }
      }
    }
    forces_ = VecX::Zero(static_cast<Eigen::Index>(count));
    for (std::size_t j = 0; j < count; ++j) {
      forces_[static_cast<Eigen::Index>(j)] = sums[j].value();
    }
    return true;
  }

  // Slip of the gear before, or of an open train whose output turns as the file says.
  bool find_start() {
    const double speed = asked_.input_speed;
    if (result_.from) {
      const ShiftState& before = state(*result_.from).state;
      const std::optional<double>& slip = before.slips[at(result_.slips)];
      result_.slip = slip.value_or(0.0) * (speed / plan_.inputs.front().speed);
    } else {
      RoundedSum sum;
      sum.add(*asked_.output_speed);
      sum.add(-speed * output_in(kInput));
      result_.slip = output_in(kSlip) == 0.0 ? 0.0 : sum.value() / output_in(kSlip);
    }
    return result_.slip != 0.0 ||
           refuse(asked_.name.where,
                  fmt::format("'{}' does not slip where the change begins",
                              element_name(result_.slips)),
                  "nothing is to be synchronised: check the speeds, and the slips of the table");
  }

  // The inertia must not change: then no motion asks for a torque by itself.
  bool check_inertia() {
    const double speed = std::max(std::abs(asked_.input_speed), std::abs(result_.slip));
    for (const auto& [input, slip] :
         {std::array{speed, 0.0}, std::array{0.0, speed}, std::array{speed, speed}}) {
      Case steady;
      steady.motions = knowns(input, slip);
      steady.accelerations.emplace();
      KinematicSolution motion = motions_.front();
      auto moved = find_drawn_motion(mechanism_, steady, motion);
      const auto* known = std::get_if<InertialMotion>(&moved);
      if (known == nullptr) {
        return refuse(asked_.name.where,
                      "how its bodies speed up does not follow from input and slip",
                      "see what 'kinestat analyze' says of a case with 'acceleration'");
      }
      const ReducedEquation reduced =
          find_dynamics(mechanism_, steady, *known, nullptr).reduced.value();
      inertia_ = reduced.inertia;
      if (!reduced.bias.isZero(0.0)) {
        return refuse(asked_.name.where,
                      "the inertia of the mechanism changes while it turns",
                      "it must be that of a train of gears whose bodies turn about their centres "
                      "of mass");
      }
    }
    // Energies are positive where something has inertia in every motion.
    const double det = inertia_(kInput, kInput) * inertia_(kSlip, kSlip) -
                       inertia_(kInput, kSlip) * inertia_(kInput, kSlip);
    const double bound = kCancellation * inertia_(kInput, kInput) * inertia_(kSlip, kSlip);
    return kinestat::zero_within_bound(det, bound) > 0.0 ||
           refuse(asked_.name.where,
                  "input or output has no inertia, so that nothing resists the torques",
                  "give 'inertia' to the bodies of input and output, with what they drive");
  }

  using Pair = Eigen::Vector2d;

  // Accelerations of input and slip under these torques on them.
  Pair accelerations(const Pair& torques) const {
    const Eigen::Matrix2d inertia = inertia_.topLeftCorner<2, 2>();
    return inertia.ldlt().solve(torques);
  }

  void solve() {
    const double sense = std::copysign(1.0, result_.slip);
    const Pair unit = accelerations(Pair::Unit(kSlip));
    const Pair free = accelerations(forces_.head<2>());
    result_.holding_torque =
        kinestat::zero_within_bound(-free[kSlip] / unit[kSlip], kCancellation * asked_.capacity);
    result_.least_capacity = std::max(0.0, -sense * result_.holding_torque);
    const double torque = -sense * asked_.capacity;
    const Pair rates = free + torque * unit;
    result_.slip_rate = kinestat::zero_within_bound(
        rates[kSlip], kCancellation * (std::abs(free[kSlip]) + std::abs(torque * unit[kSlip])));
    result_.peak_power = asked_.capacity * std::abs(result_.slip);
    result_.end =
        sense * result_.slip_rate < 0.0 ? SlipEnd::synchronises : SlipEnd::never_synchronises;
    rates_ = Pair(rates[kInput], result_.slip_rate);
    fill_shafts();
    fill_held();
    if (result_.end == SlipEnd::synchronises) {
      fill_energies();
    }
  }

  // The rate of an actuator that belongs to rates of input and slip.
  double of_actuator(int actuator, double input, double slip) const {
    RoundedSum sum;
    sum.add(input * rate_in(kInput, actuator));
    sum.add(slip * rate_in(kSlip, actuator));
    return sum.value();
  }

  void fill_shafts() {
    const int output = plan_.outputs.front();
    result_.input = {.start = asked_.input_speed, .acceleration = rates_[kInput], .end = {}};
    result_.output = {.start = of_actuator(output, asked_.input_speed, result_.slip),
                      .acceleration = of_actuator(output, rates_[kInput], rates_[kSlip]),
                      .end = {}};
    // Of input and output: the slip that turns the output alone, and the input alone.
    const double by_slip = output_in(kSlip);
    const Eigen::Matrix2d& M = inertia_.topLeftCorner<2, 2>();
    if (by_slip == 0.0) {
      result_.input_inertia = M(kInput, kInput);
      return;
    }
    Eigen::Matrix2d shares;
    shares << 1.0, 0.0, -output_in(kInput) / by_slip, 1.0 / by_slip;
    const Eigen::Matrix2d of_shafts = shares.transpose() * M * shares;
    result_.input_inertia = of_shafts(0, 0);
    result_.output_inertia = of_shafts(1, 1);
    result_.shared_inertia = of_shafts(0, 1);
  }

  // What keeps an engaged element at rest: M q'' = Q + T in its row.
  void fill_held() {
    for (std::size_t e = 0; e < engaged_.size(); ++e) {
      const auto row = static_cast<Eigen::Index>(e) + 2;
      RoundedSum sum;
      sum.add(inertia_(row, kInput) * rates_[kInput]);
      sum.add(inertia_(row, kSlip) * rates_[kSlip]);
      sum.add(-forces_[row]);
      result_.held.push_back({.element = engaged_[e], .torque = sum.value()});
    }
  }

  void fill_energies() {
    const double time = -result_.slip / result_.slip_rate;
    const Pair start(asked_.input_speed, result_.slip);
    const Pair end(asked_.input_speed + rates_[kInput] * time, 0.0);
    const double energy = 0.5 * result_.peak_power * time;
    const double work = time * (forces_[kInput] * mean(start[kInput], end[kInput]) +
                                forces_[kSlip] * mean(start[kSlip], end[kSlip]));
    const Eigen::Matrix2d inertia = inertia_.topLeftCorner<2, 2>();
    const double before = 0.5 * start.dot(inertia * start);
    const double after = 0.5 * end.dot(inertia * end);
    const double largest = std::max({std::abs(work), energy, before, after});
    result_.time = time;
    result_.energy = energy;
    result_.work = work;
    result_.kinetic_energy_change = after - before;
    result_.residual = std::abs(after - before - (work - energy)) / largest;
    result_.input.end = end[kInput];
    result_.output.end = of_actuator(plan_.outputs.front(), end[kInput], 0.0);
  }

  // One that stays engaged holds one sense of torque; the one that opens must overrun.
  void judge_freewheels() {
    for (const HeldElement& one : result_.held) {
      if (plan_.elements[at(one.element)].one_way * one.torque < 0.0) {
        result_.wrong_freewheel = one.element;
      }
    }
    if (result_.opens) {
      const ShiftElement& one = plan_.elements[at(*result_.opens)];
      if (one.one_way * of_actuator(one.actuator, rates_[kInput], rates_[kSlip]) < 0.0) {
        result_.wrong_freewheel = result_.opens;
      }
    }
  }

  const Mechanism& mechanism_;
  const Topology& topology_;
  const ShiftPlan& plan_;
  const ShiftSolution& solution_;
  const SlipPlan& asked_;
  const Case& loads_;
  std::vector<int> engaged_;  ///< elements that stay engaged
  std::vector<KinematicSolution> motions_;
  VecX forces_;
  MatX inertia_;
  Pair rates_ = Pair::Zero();
  ShiftSlip result_;
  SlipObstacle obstacle_;
};

}  // namespace

bool ShiftSlip::holds() const {
  return std::abs(holding_torque) <= capacity * (1.0 + kSameValue);
}

std::variant<ShiftSlip, SlipObstacle> find_shift_slip(const Mechanism& mechanism,
                                                      const ShiftPlan& plan,
                                                      const ShiftSolution& solution,
                                                      const SlipPlan& slip,
                                                      const Case& loads) {
  return SlipSolver(mechanism, plan, solution, slip, loads).run();
}

}  // namespace kinestat
