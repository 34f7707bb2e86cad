#include "studies/duty/duty_solution.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "cases/case_status.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/gears/central_hinge.hpp"
#include "mechanism/gears/planet_load.hpp"
#include "power/efficiency.hpp"
#include "studies/duty/state_finder.hpp"

namespace kinestat {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// Σ n F^p and Σ n. The loads are divided by the largest so far, that no power overflows.
class WearSum {
 public:
  explicit WearSum(const std::optional<double>& exponent) : exponent_(exponent) {}

  void add(double turns, const std::optional<double>& load) {
    turns_ += turns;
    is_open_ = is_open_ || !load;
    if (is_open_) {
      return;
    }
    if (*load > largest_) {
      sum_ *= exponent_ && largest_ > 0.0 ? std::pow(largest_ / *load, *exponent_) : 0.0;
      largest_ = *load;
    }
    sum_ += exponent_ && largest_ > 0.0 ? turns * std::pow(*load / largest_, *exponent_) : 0.0;
  }

  DutyWear wear(double repetitions) const {
    DutyWear result{.revolutions = {},
                    .largest = is_open_ ? std::nullopt : std::optional(largest_),
                    .equivalent = {}};
    if (std::isnan(turns_)) {
      return result;
    }
    result.revolutions = repetitions * turns_;
    if (exponent_ && turns_ > 0.0 && !is_open_) {
      result.equivalent = largest_ * std::pow(sum_ / turns_, 1.0 / *exponent_);
    }
    return result;
  }

 private:
  std::optional<double> exponent_;
  bool is_open_ = false;  ///< the load of some point
  double turns_ = 0.0;
  double largest_ = 0.0;
  double sum_ = 0.0;
};

struct GearSum {
  GearDuty duty;
  bool is_head = true;
  std::size_t mesh = 0;
  double share = 1.0;  ///< of the most loaded of equal planets
  WearSum wear;
};

struct BearingSum {
  BearingDuty duty;
  int freedom = 0;
  std::optional<CentralHinge> central = {};
  double share = 1.0;  ///< likewise
  WearSum wear;
};

class DutySum {
 public:
  DutySum(const Mechanism& mechanism, const DutyPlan& plan, std::span<const Mesh> meshes)
      : mechanism_(mechanism), plan_(plan), energy_of_case_(mechanism.cases.size()) {
    for (const LossyMesh& mesh : mechanism.lossy_meshes) {
      result_.meshes.push_back({.coupling = mesh.coupling});
    }
    list_frictions();
    list_dampers();
    list_gears(meshes);
    list_bearings();
    for (std::size_t a = 0; a < mechanism.topology.actuators.size(); ++a) {
      if (is_shift_element(mechanism.topology, a)) {
        result_.elements.push_back({.actuator = static_cast<int>(a)});
      }
    }
  }

  void add_rest(double duration) {
    result_.points.push_back({.status = DutyStatus::at_rest, .energy = {.duration = duration}});
    result_.at_rest += duration;
    result_.whole.duration += duration;
  }

  void add_unanswered(double duration) {
    result_.points.push_back({.status = DutyStatus::unanswered, .energy = {.duration = duration}});
  }

  void add(const DutyPoint& point, const DutyState& state, std::string_view impossible) {
    DutyPointState one{
        .status = state.drives_from_both_ends ? DutyStatus::both_ends : DutyStatus::solved,
        .energy = {.duration = point.duration},
        .impossible = impossible};
    const double t = point.duration;
    double sum = 0.0;
    double largest = 0.0;
    const auto balance = [&](double power) {
      sum += power;
      largest = std::max(largest, std::abs(power));
    };
    const auto exchange = [&](double power) {
      balance(power);
      (power > 0.0 ? one.energy.given : one.energy.taken) += t * std::abs(power);
    };
    const auto lose = [&](double power) {
      balance(power);
      one.energy.lost -= t * power;
    };
    std::size_t element = 0;
    for (std::size_t a = 0; a < state.actuators.size(); ++a) {
      if (!is_shift_element(mechanism_.topology, a)) {
        exchange(state.actuators[a]);
        continue;
      }
      lose(state.actuators[a]);
      add_element(state, t, result_.elements[element++]);
    }
    std::ranges::for_each(state.loads, exchange);
    for (std::size_t m = 0; m < state.meshes.size(); ++m) {
      lose(state.meshes[m]);
      result_.meshes[m].energy -= t * state.meshes[m];
    }
    for (std::size_t f = 0; f < state.friction.size(); ++f) {
      lose(state.friction[f]);
      result_.frictions[loser_of_[f]].energy -= t * state.friction[f];
    }
    std::ranges::for_each(state.dampers, lose);
    for (DamperLoss& damper : result_.dampers) {
      damper.energy -= state.dampers.empty() ? 0.0 : t * state.dampers[damper.spring];
    }
    one.energy.no_efficiency = state.no_efficiency;
    one.balance_residual = largest == 0.0 ? 0.0 : std::abs(sum) / largest;
    add_wear(state, t);
    add_energy(one.energy, result_.whole);
    add_energy(one.energy, energy_of_case_[point.which]);
    result_.both_ends += state.drives_from_both_ends ? t : 0.0;
    result_.balance_residual = std::max(result_.balance_residual, one.balance_residual);
    result_.points.push_back(one);
  }

  DutySolution take() {
    const double times = plan_.repetitions;
    scale(times, result_.whole);
    for (std::size_t c = 0; c < energy_of_case_.size(); ++c) {
      if (energy_of_case_[c].duration > 0.0) {
        scale(times, energy_of_case_[c]);
        result_.cases.push_back({.which = c, .energy = energy_of_case_[c]});
      }
    }
    for (auto* losses : {&result_.meshes, &result_.frictions}) {
      for (CouplingLoss& loss : *losses) {
        loss.energy *= times;
      }
    }
    for (DamperLoss& damper : result_.dampers) {
      damper.energy *= times;
    }
    for (const GearSum& gear : gears_) {
      result_.gears.push_back(gear.duty);
      result_.gears.back().wear = gear.wear.wear(times);
    }
    for (const BearingSum& bearing : bearings_) {
      result_.bearings.push_back(bearing.duty);
      result_.bearings.back().wear = bearing.wear.wear(times);
    }
    for (ElementDuty& element : result_.elements) {
      element.engaged *= times;
      element.lost *= times;
    }
    result_.at_rest *= times;
    result_.both_ends *= times;
    return std::move(result_);
  }

 private:
  // What the stator of a torque converter gives counts with what its pump loses to the turbine.
  void list_frictions() {
    for (const CouplingFriction& friction : mechanism_.frictions) {
      const auto first = std::ranges::find_if(result_.frictions, [&](const CouplingLoss& one) {
        const CouplingTopology& other = mechanism_.topology.coupling(one.coupling);
        return friction.converter && friction.converter->is_of_stator &&
               other.tail == friction.converter->pump && other.head == friction.converter->turbine;
      });
      loser_of_.push_back(static_cast<std::size_t>(first - result_.frictions.begin()));
      if (first == result_.frictions.end()) {
        result_.frictions.push_back({.coupling = friction.coupling});
      }
    }
  }

  void list_dampers() {
    for (std::size_t i = 0; i < mechanism_.springs.size(); ++i) {
      if (mechanism_.springs[i].damping != 0.0) {
        result_.dampers.push_back({.spring = i});
      }
    }
  }

  void list_gears(std::span<const Mesh> meshes) {
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const CouplingTopology& coupling = mechanism_.topology.coupling(meshes[m].coupling);
      for (const bool is_head : {false, true}) {
        const BodyId gear = is_head ? coupling.head : coupling.tail;
        if (meshes[m].carrier && gear != meshes[m].carrier) {
          gears_.push_back({.duty = {.mesh = meshes[m].coupling,
                                     .gear = gear,
                                     .planets = planets_of(mechanism_, coupling),
                                     .wear = {}},
                            .is_head = is_head,
                            .mesh = m,
                            .share = most_loaded_share(mechanism_, coupling),
                            .wear = WearSum(plan_.gear_exponent)});
        }
      }
    }
  }

  void list_bearings() {
    const Topology& topology = mechanism_.topology;
    const std::vector<std::optional<CentralHinge>> central = find_central_hinges(mechanism_);
    for (int e = 0; e < topology.coupling_count(); ++e) {
      const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
      const CouplingKind& kind = kind_of(coupling.type);
      const bool is_of_cable =
          std::ranges::find(mechanism_.contacts, CouplingId{e}, &CableContact::slips) !=
          mechanism_.contacts.end();
      if (!kind.is_hinge || kind.engages || coupling.action_count == 0 || is_of_cable) {
        continue;
      }
      bearings_.push_back({.duty = {.bearing = CouplingId{e},
                                    .planets = planets_of(mechanism_, coupling),
                                    .wear = {}},
                           .freedom = coupling.first_freedom,
                           .central = central[static_cast<std::size_t>(e)],
                           .share = most_loaded_share(mechanism_, coupling),
                           .wear = WearSum(plan_.bearing_exponent)});
    }
  }

  void add_element(const DutyState& state, double t, ElementDuty& element) const {
    const ActuatorTopology& one =
        mechanism_.topology.actuators[static_cast<std::size_t>(element.actuator)];
    const double rate = state.rates[static_cast<std::size_t>(one.freedom)];
    const double torque = std::abs(state.actions[static_cast<std::size_t>(one.action)].value());
    element.engaged += rate == 0.0 && torque > 0.0 ? t : 0.0;
    element.largest = std::max(element.largest, torque);
    element.lost -= t * state.actuators[static_cast<std::size_t>(element.actuator)];
  }

  void add_wear(const DutyState& state, double t) {
    for (GearSum& gear : gears_) {
      const MeshState& mesh = state.teeth[gear.mesh];
      const GearState& one = gear.is_head ? mesh.head : mesh.tail;
      gear.wear.add(one.speed * t / kTurn, shared(one.torque, gear.share));
    }
    for (BearingSum& bearing : bearings_) {
      const double rate = state.rates[static_cast<std::size_t>(bearing.freedom)];
      const std::optional<Vec3> force =
          borne_force(bearing.central, bearing.duty.bearing, [&](CouplingId coupling) {
            return state.forces[static_cast<std::size_t>(coupling.value)];
          });
      bearing.wear.add(std::abs(rate) * t / kTurn,
                       shared(force ? std::optional(force->norm()) : std::nullopt, bearing.share));
    }
  }

  static std::optional<double> shared(const std::optional<double>& load, double share) {
    return load ? std::optional(*load * share) : std::nullopt;
  }

  static void add_energy(const DutyEnergy& one, DutyEnergy& to) {
    to.duration += one.duration;
    to.given += one.given;
    to.taken += one.taken;
    to.lost += one.lost;
    if (to.no_efficiency.empty()) {
      to.no_efficiency = one.no_efficiency;
    }
  }

  static void scale(double factor, DutyEnergy& energy) {
    energy.duration *= factor;
    energy.given *= factor;
    energy.taken *= factor;
    energy.lost *= factor;
  }

  const Mechanism& mechanism_;
  const DutyPlan& plan_;
  std::vector<std::size_t> loser_of_;  ///< of each friction: index into result_.frictions
  std::vector<DutyEnergy> energy_of_case_;
  std::vector<GearSum> gears_;
  std::vector<BearingSum> bearings_;
  DutySolution result_;
};

}  // namespace

std::optional<double> DutyEnergy::efficiency() const {
  return given > 0.0 && no_efficiency.empty() ? std::optional(taken / given) : std::nullopt;
}

DutySolution solve_duty(const Mechanism& mechanism,
                        const DutyPlan& plan,
                        const OnPointAnalysis& on_analysis) {
  const std::vector<Mesh> meshes = find_meshes(mechanism.topology, mechanism.geometry);
  DutySum sum(mechanism, plan, meshes);
  std::map<std::size_t, StateFinder> finders;
  std::vector<UnansweredCase> unanswered;
  std::size_t now = 0;
  std::string_view impossible;
  const OnAnalysis look = [&](const CaseAnalysis& analysis) {
    impossible = impossible_status(mechanism, analysis);
    if (on_analysis) {
      on_analysis(now, analysis);
    }
  };
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    const DutyPoint& point = plan.points[i];
    if (std::ranges::all_of(point.motions, [](double motion) { return motion == 0.0; })) {
      sum.add_rest(point.duration);
      continue;
    }
    StateFinder& finder =
        finders.try_emplace(point.which, mechanism, point.which, meshes, look).first->second;
    impossible = {};
    now = i;
    if (const std::optional<DutyState> state = finder.find(point)) {
      sum.add(point, *state, impossible);
      continue;
    }
    sum.add_unanswered(point.duration);
    const auto at = std::ranges::find(unanswered, point.which, &UnansweredCase::which);
    if (at == unanswered.end()) {
      unanswered.push_back(
          {.which = point.which, .first = i, .count = 1, .analysis = finder.take_unanswered()});
    } else {
      ++at->count;
    }
  }
  DutySolution result = sum.take();
  result.unanswered = std::move(unanswered);
  return result;
}

}  // namespace kinestat
