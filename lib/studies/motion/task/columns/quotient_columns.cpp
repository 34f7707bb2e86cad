#include "studies/motion/task/columns/quotient_columns.hpp"

#include <cmath>

#include "core/contract.hpp"
#include "expression/unit_quotient.hpp"

namespace kinestat {

namespace {

using OfCase = std::function<std::optional<double>(const CaseAnalysis&)>;

// Action of the output over that of the input; in a case without actions the ratio of their rates,
// which in SI is the same number by virtual power.
std::optional<double> mechanical_advantage(const CaseAnalysis& one) {
  if (one.action) {
    return one.ratios->advantage;
  }
  const std::optional<double> ratio = one.ratios->ratio;
  return ratio ? std::optional(std::abs(*ratio)) : std::nullopt;
}

std::optional<QuotientParts> rates_of(const CaseAnalysis& one, int input, int output) {
  if (!one.motion || one.motion->rates.empty()) {
    return std::nullopt;
  }
  const std::vector<double>& rates = one.motion->rates;
  return QuotientParts{.dividend = rates[static_cast<std::size_t>(input)],
                       .divisor = rates[static_cast<std::size_t>(output)]};
}

// That of all inputs together by its share of that of the output.
std::optional<QuotientParts> actions_of(const CaseAnalysis& one, int output) {
  const std::optional<double>& share = one.ratios->torque_ratio;
  if (!share) {
    return std::nullopt;
  }
  const double action = one.action->magnitudes[static_cast<std::size_t>(output)].value_or(0.0);
  return QuotientParts{.dividend = action, .divisor = *share * action};
}

class QuotientList {
 public:
  QuotientList(const FileUnits& units, const Mechanism& mechanism, const Case& which)
      : units_(units),
        topology_(mechanism.topology),
        input_(actuator(which.inputs.front())),
        output_(actuator(which.outputs.front())) {}

  MotionReading ratio() const {
    MotionReading reading =
        quotient("ratio", rate_kind(input_), rate_kind(output_), [](const CaseAnalysis& one) {
          return one.ratios->ratio;
        });
    reading.is_of_motion = true;
    reading.parts =
        solved<QuotientParts>([in = input_.freedom, out = output_.freedom](
                                  const CaseAnalysis& one) { return rates_of(one, in, out); });
    return reading;
  }

  MotionReading advantage() const {
    MotionReading reading = quotient(
        "mechanical_advantage", action_kind(output_), action_kind(input_), mechanical_advantage);
    reading.is_size = true;
    reading.parts = solved<QuotientParts>([in = input_, out = output_](const CaseAnalysis& one) {
      return one.action ? actions_of(one, out.action) : rates_of(one, in.freedom, out.freedom);
    });
    return reading;
  }

 private:
  const ActuatorTopology& actuator(int index) const {
    return topology_.actuators[static_cast<std::size_t>(index)];
  }

  bool turns(const ActuatorTopology& one) const {
    return topology_.freedoms[static_cast<std::size_t>(one.freedom)].is_rotation;
  }

  QuantityKind rate_kind(const ActuatorTopology& one) const {
    return turns(one) ? QuantityKind::angular_velocity : QuantityKind::velocity;
  }

  QuantityKind action_kind(const ActuatorTopology& one) const {
    return turns(one) ? QuantityKind::moment : QuantityKind::force;
  }

  template <class Value>
  static std::function<std::optional<Value>(const MotionPosition&)> solved(
      std::function<std::optional<Value>(const CaseAnalysis&)> of_case) {
    return [of_case = std::move(of_case)](const MotionPosition& at) {
      return at.solved && at.solved->ratios ? of_case(*at.solved) : std::nullopt;
    };
  }

  MotionReading quotient(const std::string& quantity,
                         QuantityKind above,
                         QuantityKind below,
                         const OfCase& of_case) const {
    const double factor = above == below ? 1.0 : units_.factor(below) / units_.factor(above);
    const std::string unit =
        above == below ? "" : unit_quotient(units_.text(above), units_.text(below));
    return {.column = {.element = output_.name, .quantity = quantity, .unit = unit},
            .kind = QuantityKind::dimensionless,
            .value = [value = solved(of_case),
                      factor](const MotionPosition& at) -> std::optional<double> {
              const std::optional<double> found = value(at);
              return found ? std::optional(*found * factor) : std::nullopt;
            }};
  }

  const FileUnits& units_;
  const Topology& topology_;
  const ActuatorTopology& input_;
  const ActuatorTopology& output_;
};

}  // namespace

std::vector<MotionReading> quotient_readings(const FileUnits& units,
                                             const Mechanism& mechanism,
                                             const MotionPlan& plan) {
  std::vector<MotionReading> readings;
  if (!plan.report.ratio && !plan.report.mechanical_advantage) {
    return readings;
  }
  KINESTAT_EXPECTS(plan.which >= 0);
  const QuotientList list(units, mechanism, mechanism.cases[static_cast<std::size_t>(plan.which)]);
  if (plan.report.ratio) {
    readings.push_back(list.ratio());
  }
  if (plan.report.mechanical_advantage) {
    readings.push_back(list.advantage());
  }
  return readings;
}

}  // namespace kinestat
