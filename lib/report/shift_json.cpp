#include "report/shift_json.hpp"

#include <cstdint>

#include "core/contract.hpp"
#include "report/gear_values.hpp"

namespace kinestat {

namespace {

class ShiftWriter {
 public:
  explicit ShiftWriter(const Analysis& analysis)
      : analysis_(analysis),
        topology_(analysis.mechanism.topology),
        plan_(analysis.shift->plan),
        solution_(analysis.shift->solution) {}

  Json run() const {
    Json result = object_of(8);
    result["possibilities"] = static_cast<std::int64_t>(solution_.possibilities);
    result["net_freedom"] = solution_.net_freedom;
    result["engaged"] = solution_.needed;
    result["states"] = object_of(solution_.states.size());
    for (std::size_t s = 0; s < solution_.states.size(); ++s) {
      result["states"][solution_.states[s].name] = state_json(s);
    }
    result["span"] = number(solution_.table.span);
    result["equal_ratios"] = Json::array();
    for (const std::vector<int>& group : solution_.table.equal_ratios) {
      Json names = Json::array();
      for (const int state : group) {
        names.push_back(name_of(state));
      }
      result["equal_ratios"].push_back(std::move(names));
    }
    result["changes"] = Json::array();
    for (const GearChange& change : solution_.table.changes) {
      Json entry = object_of(4);
      entry["from"] = name_of(change.from);
      entry["to"] = name_of(change.to);
      entry["opens"] = change.opens < 0 ? Json(nullptr) : Json(element_name(change.opens));
      entry["engages"] = change.engages < 0 ? Json(nullptr) : Json(element_name(change.engages));
      result["changes"].push_back(std::move(entry));
    }
    return result;
  }

 private:
  const std::string& name_of(int state) const {
    return solution_.states[static_cast<std::size_t>(state)].name;
  }

  const std::string& actuator_name(int actuator) const {
    return topology_.actuators[static_cast<std::size_t>(actuator)].name;
  }

  const std::string& element_name(int element) const {
    return actuator_name(plan_.elements[static_cast<std::size_t>(element)].actuator);
  }

  Json state_json(std::size_t index) const {
    const NamedShiftState& one = solution_.states[index];
    Json result = object_of(16);
    result["engaged"] = Json::array();
    for (const int element : one.engaged) {
      result["engaged"].push_back(element_name(element));
    }
    result["class"] = word_of(one.state.kind);
    result["reason"] = one.reason;
    result["freedom"] = one.state.freedom;
    if (one.state.kind == ShiftClass::gear) {
      add_gear(index, result);
    } else {
      result["ratio"] = nullptr;
    }
    return result;
  }

  // One output has its value, several a value each by name.
  Json by_output(const std::vector<std::optional<double>>& values) const {
    if (values.size() == 1) {
      return number(values.front());
    }
    Json result = object_of(values.size());
    for (std::size_t o = 0; o < values.size(); ++o) {
      result[actuator_name(plan_.outputs[o])] = number(values[o]);
    }
    return result;
  }

  void add_gear(std::size_t index, Json& result) const {
    const NamedShiftState& one = solution_.states[index];
    const GearValues values = gear_values(analysis_, index);
    for (const std::string& reason : values.reasons) {
      if (!reason.empty()) {
        const std::string before = result["reason"];
        result["reason"] = before.empty() ? reason : before + "; " + reason;
      }
    }
    result["ratio"] = by_output(values.ratios);
    result["step"] = number(values.step);
    result["torque_ratio"] = by_output(values.torque_ratios);
    const std::optional<double>& first = values.ratios.front();
    result["direction"] = !first ? Json(nullptr) : Json(*first > 0.0 ? "forward" : "reverse");
    result["efficiency"] = efficiency_json(*find_gear_case(analysis_, one));
    result["recirculation"] = number(values.recirculation);
    result["elements"] = object_of(plan_.elements.size());
    for (std::size_t e = 0; e < plan_.elements.size(); ++e) {
      Json& element = result["elements"][element_name(static_cast<int>(e))];
      element["torque"] = number(values.torques[e]);
      element["slip"] = number(values.slips[e]);
    }
    result["worst_bearing"] = loaded_json(values.bearing);
    result["worst_mesh"] = loaded_json(values.mesh);
  }

  static Json efficiency_json(const CaseAnalysis& one) {
    const TransmissionEfficiency* lossy = one.efficiency ? &*one.efficiency : nullptr;
    Json result = object_of(4);
    result["carrier"] = lossy ? number(lossy->carrier.value) : Json(nullptr);
    result["carrier_backward"] = lossy ? number(lossy->carrier_backward.value) : Json(nullptr);
    result["absolute"] = lossy ? number(lossy->absolute.value) : Json(nullptr);
    result["friction"] = one.power ? number(one.power->efficiency) : Json(nullptr);
    return result;
  }

  static Json loaded_json(const std::optional<LoadedCoupling>& loaded) {
    if (!loaded) {
      return nullptr;
    }
    Json result = object_of(2);
    result["coupling"] = loaded->name;
    result["force"] = number(loaded->force);
    return result;
  }

  const Analysis& analysis_;
  const Topology& topology_;
  const ShiftPlan& plan_;
  const ShiftSolution& solution_;
};

}  // namespace

Json shift_json(const Analysis& analysis) {
  KINESTAT_EXPECTS(analysis.shift.has_value());
  return ShiftWriter(analysis).run();
}

}  // namespace kinestat
