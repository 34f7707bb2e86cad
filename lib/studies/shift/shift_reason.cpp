#include "studies/shift/shift_reason.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "studies/shift/internal/remaining_motion.hpp"

namespace kinestat {

namespace {

using Names = std::vector<std::string>;

class ReasonWriter {
 public:
  ReasonWriter(const Topology& topology,
               const ShiftNetwork& network,
               const ShiftPlan& plan,
               std::span<const int> engaged,
               const ShiftState& state)
      : topology_(topology), network_(network), plan_(plan), engaged_(engaged), state_(state) {}

  std::string run() const {
    const std::string cause = cause_text();
    const int count = static_cast<int>(engaged_.size());
    const int more = count - network_.needed();
    if (more >= 0 && more <= network_.following(plan_)) {
      return cause;
    }
    const std::string number = fmt::format("engages {} element{} where a gear needs {}",
                                           count == 0 ? "no" : std::to_string(count),
                                           count == 1 ? "" : "s",
                                           network_.needed());
    return cause.empty() ? number : fmt::format("{}: {}", number, cause);
  }

 private:
  std::string cause_text() const {
    switch (state_.cause) {
      case ShiftCause::none:
        return beside_text();
      case ShiftCause::input_held:
        return fmt::format(
            "input '{}' is locked; {}; {}",
            actuator_name(plan_.inputs[static_cast<std::size_t>(state_.which)].actuator),
            held_text(),
            freedoms_text(state_.freedom, false));
      case ShiftCause::inputs_coupled:
        return fmt::format(
            "input '{}' cannot have its speed: the inputs depend on each other; {}",
            actuator_name(plan_.inputs[static_cast<std::size_t>(state_.which)].actuator),
            freedoms_text(state_.freedom, false));
      case ShiftCause::output_free:
        return fmt::format("output '{}' is free: with {} at rest {}; {}",
                           actuator_name(plan_.outputs[static_cast<std::size_t>(state_.which)]),
                           plan_.inputs.size() == 1 ? "the input" : "the inputs",
                           freedoms_text(state_.idle, true),
                           held_text()) +
               converter_text();
      case ShiftCause::outputs_held:
        return fmt::format(
            "{} locked; {}; {}", outputs_text(), held_text(), freedoms_text(state_.freedom, false));
      case ShiftCause::redundant:
        return fmt::format("{}; {}", redundancy_text(), held_text());
      case ShiftCause::freewheel_overruns:
        return freewheel_text("overruns: its torque would be", "holds only a", "one");
      case ShiftCause::freewheel_locks:
        return freewheel_text("locks: its slip would be", "slips only in the", "sense");
    }
    return "";
  }

  // What moves is driven by a fluid if that has a pump which turns with the inputs.
  std::string converter_text() const {
    const Names moving = bodies(motions(true), true);
    for (const CouplingTopology& coupling : topology_.couplings) {
      const bool is_fluid = coupling.type == CouplingType::torque_converter;
      if (is_fluid && std::ranges::count(moving, topology_.body(coupling.head).name) > 0) {
        return fmt::format(
            "; torque converter '{}' drives '{}' without a ratio of speeds: give it as a case with "
            "the speeds of both, and here the gear with its lock-up engaged",
            coupling.name,
            topology_.body(coupling.head).name);
      }
    }
    return {};
  }

  // What a gear leaves free and open.
  std::string beside_text() const {
    std::string text =
        state_.idle == 0 ? "" : fmt::format("besides, {}", freedoms_text(state_.idle, true));
    const auto inputs = static_cast<int>(plan_.inputs.size());
    Names following;
    for (int i = 0; i < inputs && plan_.is_hybrid(); ++i) {
      if (std::ranges::count(state_.moving, i) == 0) {
        following.push_back(actuator_name(plan_.inputs[static_cast<std::size_t>(i)].actuator));
      }
    }
    if (!following.empty()) {
      text += fmt::format(
          "{}the speed of {} follows from that of '{}'",
          text.empty() ? "" : "; ",
          quoted_list(following),
          actuator_name(plan_.inputs[static_cast<std::size_t>(state_.moving.front())].actuator));
    }
    if (!state_.surplus.empty()) {
      text += (text.empty() ? "" : "; ") + redundancy_text();
    }
    if (!state_.overrunning.empty()) {
      text += fmt::format("{}{} {} overrun{}",
                          text.empty() ? "" : "; ",
                          state_.overrunning.size() == 1 ? "freewheel" : "freewheels",
                          names_of(state_.overrunning),
                          state_.overrunning.size() == 1 ? "s" : "");
    }
    if (!state_.open_freewheels.empty()) {
      const bool is_one = state_.open_freewheels.size() == 1;
      text += fmt::format("{}equilibrium does not determine whether {} {} hold{}",
                          text.empty() ? "" : "; ",
                          is_one ? "freewheel" : "freewheels",
                          names_of(state_.open_freewheels),
                          is_one ? "s" : "");
    }
    return text;
  }

  std::string redundancy_text() const {
    const bool are_all = state_.surplus.size() + state_.overrunning.size() == engaged_.size();
    return fmt::format(
        "{} {} from slipping, so that {} not determined",
        are_all ? "the train itself already keeps" : "the other elements already keep",
        names_of(state_.surplus),
        are_all && state_.surplus.size() == 1 ? "its torque is" : "their torques are");
  }

  std::string freewheel_text(std::string_view event,
                             std::string_view allowed,
                             std::string_view noun) const {
    const ShiftElement& element = plan_.elements[static_cast<std::size_t>(state_.which)];
    const bool is_positive = element.one_way > 0;
    return fmt::format("freewheel '{}' {} {}, and it {} {} {}",
                       actuator_name(element.actuator),
                       event,
                       is_positive ? "negative" : "positive",
                       allowed,
                       is_positive ? "positive" : "negative",
                       noun);
  }

  const std::string& actuator_name(int actuator) const {
    return topology_.actuators[static_cast<std::size_t>(actuator)].name;
  }

  std::string outputs_text() const {
    Names names;
    for (const int output : plan_.outputs) {
      names.push_back(actuator_name(output));
    }
    return names.size() == 1 ? fmt::format("output '{}' is", names.front())
                             : fmt::format("outputs {} are", plain_list(names));
  }

  std::string names_of(const std::vector<int>& elements) const {
    Names names;
    for (const int element : elements) {
      names.push_back(actuator_name(plan_.elements[static_cast<std::size_t>(element)].actuator));
    }
    return names.size() == 1 ? fmt::format("'{}'", names.front()) : plain_list(names);
  }

  // The motions that the engaged elements leave; with inputs at rest those of them that do not need
  // the inputs.
  RemainingMotion motions(bool has_inputs_at_rest) const {
    RemainingMotion left(network_.net_freedom());
    for (const int element : engaged_) {
      if (!std::ranges::binary_search(state_.overrunning, element)) {
        (void)left.prescribe(network_.elements[static_cast<std::size_t>(element)], 0.0);
      }
    }
    for (std::size_t i = 0; has_inputs_at_rest && i < network_.inputs.size(); ++i) {
      (void)left.prescribe(network_.inputs[i], 0.0);
    }
    return left;
  }

  // The bodies that move in any of these motions, or those that do not.
  Names bodies(const RemainingMotion& left, bool that_move) const {
    Names names;
    for (int b = 1; b < topology_.body_count(); ++b) {
      bool moves = false;
      for (int row = network_.order * (b - 1); row < network_.order * b; ++row) {
        moves = moves || left.changes(network_.bodies[static_cast<std::size_t>(row)]);
      }
      if (moves == that_move) {
        names.push_back(topology_.bodies[static_cast<std::size_t>(b)].name);
      }
    }
    return names;
  }

  std::string held_text() const {
    const Names names = bodies(motions(false), false);
    return names.empty()
               ? "no body is locked"
               : fmt::format(
                     "locked bod{}: {}", names.size() == 1 ? "y" : "ies", plain_list(names));
  }

  std::string freedoms_text(int count, bool has_inputs_at_rest) const {
    if (count == 0) {
      return "no freedom remains";
    }
    const Names names = bodies(motions(has_inputs_at_rest), true);
    return count == 1 ? fmt::format("one freedom remains, moving {}", plain_list(names))
                      : fmt::format("{} freedoms remain, moving {}", count, plain_list(names));
  }

  const Topology& topology_;
  const ShiftNetwork& network_;
  const ShiftPlan& plan_;
  std::span<const int> engaged_;
  const ShiftState& state_;
};

}  // namespace

std::string reason_of(const Topology& topology,
                      const ShiftNetwork& network,
                      const ShiftPlan& plan,
                      std::span<const int> engaged,
                      const ShiftState& state) {
  return ReasonWriter(topology, network, plan, engaged, state).run();
}

}  // namespace kinestat
