#include "sensitivity/reported_value.hpp"

#include <algorithm>
#include <array>

namespace kinestat {

namespace {

using Parts = std::vector<std::string>;
using Found = std::optional<ReportedValue>;

Parts split(std::string_view path) {
  Parts parts;
  while (true) {
    const std::size_t slash = path.find('/');
    parts.emplace_back(path.substr(0, slash));
    if (slash == std::string_view::npos) {
      return parts;
    }
    path.remove_prefix(slash + 1);
  }
}

std::string joined(const Parts& parts) {
  std::string path;
  for (const std::string& part : parts) {
    path += (path.empty() ? "" : "/") + part;
  }
  return path;
}

template <class Items>
std::optional<std::size_t> index_of(const Items& items, const std::string& name) {
  const auto at = std::ranges::find_if(items, [&](const auto& item) { return item.name == name; });
  return at == items.end() ? std::nullopt
                           : std::optional(static_cast<std::size_t>(at - items.begin()));
}

template <class Name>
std::optional<std::size_t> index_where(std::size_t count, const std::string& text, Name name) {
  for (std::size_t i = 0; i < count; ++i) {
    if (name(static_cast<int>(i)) == text) {
      return i;
    }
  }
  return std::nullopt;
}

// Finds the formula of a path.
class Formula {
 public:
  explicit Formula(const DualCase& values)
      : values_(values), topology_(values.topology()), origin_(of_origin(values)) {}

  Found find(const Parts& parts) const {
    Found result;
    if (parts.size() == 1) {
      result = ratio(parts[0]);
    } else if (parts[0] == "kinematics" && values_.motion() != nullptr) {
      result = kinematics(parts);
    } else if (parts[0] == "statics" && values_.action() != nullptr) {
      result = statics(parts);
    } else if (parts[0] == "power" && has_power()) {
      result = power_at(parts);
    }
    if (result) {
      result->name = joined(parts);
    }
    return result;
  }

 private:
  static Vec3Of<Dual> of_origin(const DualCase& values) {
    return values.mechanism().geometry.origin.cast<Dual>();
  }

  bool has_power() const {
    return values_.motion() != nullptr && values_.action() != nullptr &&
           values_.action()->status == SolveStatus::solved;
  }

  static Found as(ValueKind kind, const std::optional<Dual>& value) {
    return value ? Found({.name = {}, .kind = kind, .per = std::nullopt, .value = *value})
                 : std::nullopt;
  }

  ValueKind rate_kind(std::size_t freedom) const {
    return topology_.freedoms[freedom].is_rotation ? ValueKind::angular_velocity
                                                   : ValueKind::velocity;
  }

  ValueKind action_kind(std::size_t action) const {
    return topology_.actions[action].is_couple ? ValueKind::moment : ValueKind::force;
  }

  std::optional<Dual> sum_of_actions(const std::vector<int>& actuators) const {
    std::optional<Dual> sum = Dual(0.0);
    for (const int i : actuators) {
      const auto& actuator = topology_.actuators[static_cast<std::size_t>(i)];
      const auto one = values_.magnitude(static_cast<std::size_t>(actuator.action));
      sum = sum && one ? std::optional(*sum + *one) : std::nullopt;
    }
    return sum;
  }

  // Of a case with inputs and one output (Cazangi 2008, eqs. 5.1 and 5.2).
  Found ratio(const std::string& name) const {
    const Case& which = values_.which();
    if (which.inputs.empty() || which.outputs.size() != 1) {
      return std::nullopt;
    }
    const auto& in = topology_.actuators[static_cast<std::size_t>(which.inputs.front())];
    const auto& out = topology_.actuators[static_cast<std::size_t>(which.outputs.front())];
    if (name == "ratio" && values_.motion() != nullptr) {
      const auto fast = static_cast<std::size_t>(in.freedom);
      const auto slow = static_cast<std::size_t>(out.freedom);
      return quotient(values_.rate(fast), rate_kind(fast), values_.rate(slow), rate_kind(slow));
    }
    if (name == "torque_ratio" && values_.action() != nullptr) {
      const auto given = sum_of_actions(which.inputs);
      const auto taken = sum_of_actions(which.outputs);
      if (given && taken) {
        return quotient(*given,
                        action_kind(static_cast<std::size_t>(in.action)),
                        *taken,
                        action_kind(static_cast<std::size_t>(out.action)));
      }
    }
    return std::nullopt;
  }

  static Found quotient(const Dual& a, ValueKind of_a, const Dual& b, ValueKind of_b) {
    if (b.value == 0.0) {
      return std::nullopt;
    }
    return Found({.name = {}, .kind = of_a, .per = of_b, .value = a / b});
  }

  // One component of a vector at the last part of a path.
  static Found component(const Parts& parts,
                         const std::vector<std::pair<ValueKind, Vec3Of<Dual>>>& vectors) {
    const std::string& last = parts.back();
    const auto i = static_cast<std::size_t>(last.size() == 1 ? last[0] - '0' : -1);
    if (i >= 3 * vectors.size()) {
      return std::nullopt;
    }
    const auto& [kind, vector] = vectors[i / 3];
    return as(kind, vector[static_cast<Eigen::Index>(i % 3)]);
  }

  Found kinematics(const Parts& parts) const {
    using enum ValueKind;
    if (parts.size() == 3 && parts[1] == "freedoms") {
      const auto f = index_where(
          topology_.freedoms.size(), parts[2], [&](int i) { return topology_.freedom_name(i); });
      return f ? as(rate_kind(*f), values_.rate(*f)) : std::nullopt;
    }
    const auto b = parts[1] == "bodies" && parts.size() == 5 ? index_of(topology_.bodies, parts[2])
                                                             : std::nullopt;
    if (!b) {
      return std::nullopt;
    }
    const TwistOf<Dual> twist = values_.body_twist(*b);
    const Vec3Of<Dual> at = values_.reference(*b);
    if (parts[3] == "twist") {
      const TwistOf<Dual> world = about_world(twist, origin_);
      return component(parts, {{angular_velocity, world.angular}, {velocity, world.linear}});
    }
    if (parts[3] == "angular") {
      return component(parts, {{angular_velocity, twist.angular}});
    }
    if (parts[3] == "linear") {
      return component(parts, {{velocity, velocity_at(twist, at - origin_)}});
    }
    return parts[3] == "at" ? component(parts, {{length, at}}) : std::nullopt;
  }

  Found statics(const Parts& parts) const {
    using enum ValueKind;
    if (parts.size() == 3 && parts[1] == "actions") {
      const auto a = index_where(
          topology_.actions.size(), parts[2], [&](int i) { return topology_.action_name(i); });
      return a ? as(action_kind(*a), values_.magnitude(*a)) : std::nullopt;
    }
    const auto e = parts[1] == "couplings" && parts.size() == 5
                       ? index_of(topology_.couplings, parts[2])
                       : std::nullopt;
    const auto wrench = e ? values_.coupling_wrench(*e) : std::nullopt;
    if (!wrench) {
      return std::nullopt;
    }
    const Vec3Of<Dual> at = values_.point(*e);
    if (parts[3] == "wrench") {
      const WrenchOf<Dual> world = about_world(*wrench, origin_);
      return component(parts, {{moment, world.moment}, {force, world.force}});
    }
    if (parts[3] == "moment") {
      return component(parts, {{moment, moment_at(*wrench, at - origin_)}});
    }
    if (parts[3] == "force") {
      return component(parts, {{force, wrench->force}});
    }
    return parts[3] == "at" ? component(parts, {{length, at}}) : std::nullopt;
  }

  Found power_at(const Parts& parts) const {
    if (parts.size() == 2 && parts[1] == "input") {
      return as(ValueKind::power, input_power());
    }
    if (parts.size() != 3) {
      return std::nullopt;
    }
    if (parts[1] == "actuators") {
      const auto i = index_of(topology_.actuators, parts[2]);
      return i ? as(ValueKind::power, actuator_power(*i)) : std::nullopt;
    }
    const auto e = index_of(topology_.couplings, parts[2]);
    const auto wrench = e ? values_.coupling_wrench(*e) : std::nullopt;
    if (!wrench) {
      return std::nullopt;
    }
    if (parts[1] == "couplings") {
      const auto head = static_cast<std::size_t>(topology_.couplings[*e].head.value);
      return as(ValueKind::power, power(*wrench, values_.body_twist(head)));
    }
    return parts[1] == "supplied" ? as(ValueKind::power, power(*wrench, values_.coupling_twist(*e)))
                                  : std::nullopt;
  }

  Dual actuator_power(std::size_t i) const {
    const ActuatorTopology& actuator = topology_.actuators[i];
    return *values_.magnitude(static_cast<std::size_t>(actuator.action)) *
           values_.rate(static_cast<std::size_t>(actuator.freedom));
  }

  // Of the inputs, else of all actuators that drive, as find_power has it.
  Dual input_power() const {
    Dual sum(0.0);
    for (std::size_t i = 0; i < topology_.actuators.size(); ++i) {
      const auto& inputs = values_.which().inputs;
      const bool is_input = std::ranges::find(inputs, static_cast<int>(i)) != inputs.end();
      const Dual one = actuator_power(i);
      if (inputs.empty() ? one.value > 0.0 : is_input) {
        sum = sum + one;
      }
    }
    return sum;
  }

  const DualCase& values_;
  const Topology& topology_;
  Vec3Of<Dual> origin_;
};

bool is_primary(const std::vector<Primary>& primaries, int index) {
  return std::ranges::find(primaries, index, &Primary::index) != primaries.end();
}

}  // namespace

std::optional<ReportedValue> find_reported_value(const DualCase& values, std::string_view name) {
  const Formula formula(values);
  const Parts parts = split(name);
  Found result = formula.find(parts);
  if (!result && parts.size() == 1) {
    result = formula.find({"kinematics", "freedoms", parts[0]});
  }
  if (!result && parts.size() == 1) {
    result = formula.find({"statics", "actions", parts[0]});
  }
  return result;
}

std::vector<std::string> reported_value_names(const DualCase& values) {
  std::vector<std::string> names;
  for (const char* name : {"ratio", "torque_ratio"}) {
    if (find_reported_value(values, name)) {
      names.emplace_back(name);
    }
  }
  const Topology& topology = values.topology();
  for (int f = 0; values.motion() != nullptr && f < topology.freedom_count(); ++f) {
    names.push_back(topology.freedom_name(f));
  }
  for (int a = 0; values.action() != nullptr && a < topology.action_count(); ++a) {
    if (values.action()->magnitudes[static_cast<std::size_t>(a)]) {
      names.push_back(topology.action_name(a));
    }
  }
  return names;
}

std::vector<std::string> usual_value_names(const DualCase& values) {
  std::vector<std::string> names;
  for (const char* name : {"ratio", "torque_ratio"}) {
    if (find_reported_value(values, name)) {
      names.emplace_back(name);
    }
  }
  const Topology& topology = values.topology();
  for (const ActuatorTopology& actuator : topology.actuators) {
    if (values.motion() != nullptr && !is_primary(values.which().motions, actuator.freedom)) {
      names.push_back(topology.freedom_name(actuator.freedom));
    }
    if (values.action() != nullptr && !is_primary(values.which().actions, actuator.action) &&
        values.action()->magnitudes[static_cast<std::size_t>(actuator.action)]) {
      names.push_back(topology.action_name(actuator.action));
    }
  }
  return names;
}

}  // namespace kinestat
