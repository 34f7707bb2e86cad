#include "studies/sensitivity/reported_value.hpp"

#include <algorithm>
#include <iterator>

#include "core/tolerance.hpp"
#include "mechanism/label_kind.hpp"
#include "statics/completed_actions.hpp"
#include "studies/sensitivity/internal/value_path.hpp"

namespace kinestat {

namespace {

using Found = std::optional<ReportedValue>;

PathParts split(std::string_view path) {
  PathParts parts;
  while (true) {
    const std::size_t slash = path.find('/');
    parts.emplace_back(path.substr(0, slash));
    if (slash == std::string_view::npos) {
      return parts;
    }
    path.remove_prefix(slash + 1);
  }
}

std::string joined(const PathParts& parts) {
  std::string path;
  for (const std::string& part : parts) {
    path += (path.empty() ? "" : "/") + part;
  }
  return path;
}

// Empty if one is open, or a convention.
std::optional<Dual> sum_of_actions(const DualCase& values, const std::vector<int>& actuators) {
  std::optional<Dual> sum = Dual(0.0);
  for (const int i : actuators) {
    const auto& actuator = values.topology().actuators[static_cast<std::size_t>(i)];
    const auto one = values.real_magnitude(static_cast<std::size_t>(actuator.action));
    sum = sum && one ? std::optional(*sum + *one) : std::nullopt;
  }
  return sum;
}

// Of a case with inputs and one output (Cazangi 2008, eqs. 5.1 and 5.2).
Found find_ratio(const DualCase& values, const std::string& name) {
  const Case& which = values.which();
  if (which.inputs.empty() || which.outputs.size() != 1) {
    return std::nullopt;
  }
  const Topology& topology = values.topology();
  const auto& in = topology.actuators[static_cast<std::size_t>(which.inputs.front())];
  const auto& out = topology.actuators[static_cast<std::size_t>(which.outputs.front())];
  if (name == "ratio" && values.motion() != nullptr) {
    const auto fast = static_cast<std::size_t>(in.freedom);
    const auto slow = static_cast<std::size_t>(out.freedom);
    return quotient(values.rate(fast),
                    kind_of(topology.freedoms[fast]),
                    values.rate(slow),
                    kind_of(topology.freedoms[slow]));
  }
  if (name == "torque_ratio" && values.action() != nullptr) {
    const auto given = sum_of_actions(values, which.inputs);
    const auto taken = sum_of_actions(values, which.outputs);
    if (given && taken) {
      return quotient(*given,
                      kind_of(topology.actions[static_cast<std::size_t>(in.action)]),
                      *taken,
                      kind_of(topology.actions[static_cast<std::size_t>(out.action)]));
    }
  }
  return std::nullopt;
}

Found find_formula(const DualCase& values, const PathParts& parts) {
  const bool has_rates = values.motion() != nullptr;
  const bool has_actions = values.action() != nullptr;
  if (parts.size() == 1) {
    return find_ratio(values, parts[0]);
  }
  if (parts[0] == "kinematics" && has_rates) {
    return find_kinematic_value(values, parts);
  }
  if (parts[0] == "statics" && has_actions) {
    return find_static_value(values, parts);
  }
  return parts[0] == "power" && has_rates && has_actions ? find_power_value(values, parts)
                                                         : std::nullopt;
}

// Slopes towards actions that are rounding of others, as of passive constraints that do no work on
// a motion: the value would seem to depend on them.
void drop_rounding(const DualCase& values, Dual& value) {
  if (values.action() == nullptr || value.derivatives.empty()) {
    return;
  }
  const VecX scales = action_scales(values.mechanism());
  const auto first = static_cast<Eigen::Index>(values.topology().freedoms.size());
  Eigen::Map<VecX> all(value.derivatives.data(), std::ssize(value.derivatives));
  Eigen::Ref<VecX> slopes = all.segment(first, scales.size());
  const VecX sizes = slopes.cwiseAbs().cwiseProduct(scales);
  const double largest = sizes.size() == 0 ? 0.0 : sizes.maxCoeff();
  for (Eigen::Index a = 0; a < slopes.size(); ++a) {
    slopes[a] = sizes[a] <= kCancellation * largest ? 0.0 : slopes[a];
  }
}

Found find_at(const DualCase& values, const PathParts& parts) {
  Found result = find_formula(values, parts);
  if (result) {
    result->name = joined(parts);
    drop_rounding(values, result->value);
  }
  return result;
}

bool is_primary(const std::vector<Primary>& primaries, int index) {
  return std::ranges::find(primaries, index, &Primary::index) != primaries.end();
}

// Those of the ratios that the case has.
std::vector<std::string> ratio_names(const DualCase& values) {
  std::vector<std::string> names = {"ratio", "torque_ratio"};
  std::erase_if(names, [&](const auto& name) { return !find_reported_value(values, name); });
  return names;
}

}  // namespace

std::optional<ReportedValue> find_reported_value(const DualCase& values, std::string_view name) {
  const PathParts parts = split(name);
  Found result = find_at(values, parts);
  if (!result && parts.size() == 1) {
    result = find_at(values, {"kinematics", "freedoms", parts[0]});
  }
  if (!result && parts.size() == 1) {
    result = find_at(values, {"statics", "actions", parts[0]});
  }
  return result;
}

bool is_completed(const DualCase& values, const ReportedValue& value) {
  const std::size_t first = values.topology().freedoms.size();
  return values.action() != nullptr &&
         std::ranges::any_of(values.action()->completion.actions, [&](int action) {
           return derivative(value.value, first + static_cast<std::size_t>(action)) != 0.0;
         });
}

std::vector<std::string> reported_value_names(const DualCase& values) {
  std::vector<std::string> names = ratio_names(values);
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
  if (values.topology().actuators.empty()) {
    return reported_value_names(values);
  }
  std::vector<std::string> names = ratio_names(values);
  const Topology& topology = values.topology();
  for (const ActuatorTopology& actuator : topology.actuators) {
    // Several actuators may drive one freedom.
    const std::string& rate = topology.freedom_name(actuator.freedom);
    if (values.motion() != nullptr && !is_primary(values.which().motions, actuator.freedom) &&
        std::ranges::find(names, rate) == names.end()) {
      names.push_back(rate);
    }
    if (values.action() != nullptr && !is_primary(values.which().actions, actuator.action) &&
        values.action()->magnitudes[static_cast<std::size_t>(actuator.action)]) {
      names.push_back(topology.action_name(actuator.action));
    }
  }
  return names;
}

}  // namespace kinestat
