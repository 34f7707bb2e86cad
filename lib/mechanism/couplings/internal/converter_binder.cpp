#include "mechanism/couplings/internal/converter_binder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/rounding.hpp"
#include "math/numbers/dual.hpp"

namespace kinestat {

namespace {

constexpr Dimension kDensity = {.length = -3, .mass = 1};

template <class Scalar>
class ConverterBinder {
 public:
  ConverterBinder(const CouplingDescription& coupling,
                  EvaluatorOf<Scalar>& evaluator,
                  Diagnostics& found)
      : coupling_(coupling),
        given_(*coupling.characteristic),
        evaluator_(evaluator),
        found_(found) {}

  std::optional<ConverterLawOf<Scalar>> run() {
    const int errors_before = found_.error_count();
    check_stator();
    read_speed_ratios();
    ConverterLawOf<Scalar> result;
    result.is_of_stator = !coupling_.stator_of.empty();
    if (!given_.torque_ratio.empty()) {
      result.torque_ratio = curve("torque_ratio", given_.torque_ratio, QuantityKind::dimensionless);
    }
    result.capacity = given_.lambda.empty()
                          ? curve("pump_torque", given_.pump_torque, QuantityKind::moment)
                          : curve("lambda", given_.lambda, QuantityKind::dimensionless);
    result.scale = given_.lambda.empty() ? per_speed() : per_size();
    if (found_.error_count() == errors_before) {
      check_powers(result);
    }
    return found_.error_count() == errors_before ? std::optional(std::move(result)) : std::nullopt;
  }

 private:
  void refuse(SourceRange where, std::string message, std::string hint) {
    found_.error("E0305", where, std::move(message), std::move(hint));
  }

  void check_stator() {
    const bool has_stator = coupling_.stator || !coupling_.stator_of.empty();
    if (has_stator && given_.torque_ratio.empty()) {
      refuse(given_.where,
             fmt::format("the characteristic of '{}' has a stator and no torque ratio",
                         coupling_.name.text),
             "add 'torque_ratio'; a fluid coupling has no 'stator'");
    }
    if (!has_stator && !given_.torque_ratio.empty()) {
      refuse(given_.torque_ratio.front().where,
             fmt::format("nothing supports the difference of the torques of '{}'",
                         coupling_.name.text),
             "add 'stator:', the body on which the stator reacts; without one it is a fluid "
             "coupling, whose torques are equal: remove 'torque_ratio'");
    }
  }

  void read_speed_ratios() {
    for (const Value& value : given_.speed_ratio) {
      at_.push_back(number(value, QuantityKind::dimensionless));
    }
    for (std::size_t i = 1; i < at_.size(); ++i) {
      if (!(value_of(at_[i - 1]) < value_of(at_[i]))) {
        refuse(given_.speed_ratio[i].where,
               fmt::format("the speed ratios of '{}' do not increase", coupling_.name.text),
               "write the points from stall, 0, to 1");
        return;
      }
    }
  }

  // A list, or one expression.
  CharacteristicCurveOf<Scalar> curve(std::string_view key,
                                      const std::vector<Value>& values,
                                      QuantityKind kind) {
    CharacteristicCurveOf<Scalar> result;
    if (values.size() == 1) {
      const std::array sample = {
          LawVariable<Scalar>{.name = kSpeedRatio, .value = {.value = 0.5, .dimension = {}}}};
      result.law = evaluator_.law(values.front(), kind, sample);
      return result;
    }
    if (values.size() != at_.size()) {
      refuse(values.empty() ? given_.where : values.front().where,
             fmt::format("the characteristic of '{}' has {} speed ratios and {} values of '{}'",
                         coupling_.name.text,
                         at_.size(),
                         values.size(),
                         key),
             fmt::format("give as many values as speed ratios, or one expression of '{}'",
                         kSpeedRatio));
      return result;
    }
    result.at = at_;
    for (const Value& value : values) {
      result.values.push_back(number(value, kind));
    }
    return result;
  }

  Scalar number(const Value& value, QuantityKind kind) {
    return evaluator_.number(value, kind).value_or(Scalar(0.0));
  }

  // 1 / ω² of the speed at which the torque is given.
  Scalar per_speed() {
    const Scalar speed = number(*given_.pump_speed, QuantityKind::angular_velocity);
    if (value_of(speed) == 0.0) {
      refuse(given_.pump_speed->where,
             fmt::format("the torque of '{}' is given at no speed", coupling_.name.text),
             "write the speed of the pump at which it takes that torque, such as 2000 rpm");
      return 1.0;
    }
    return Scalar(1.0) / (speed * speed);
  }

  // ρ D⁵
  Scalar per_size() {
    const auto density = evaluator_.quantity(*given_.density);
    const Scalar diameter = number(*given_.diameter, QuantityKind::length);
    if (density && !is_bare(density->dimension) && density->dimension != kDensity) {
      found_.error("E0309",
                   given_.density->where,
                   "'density' is a mass per volume",
                   "write for example density: 860 kg/m^3");
    }
    const Scalar square = diameter * diameter;
    return (density ? density->value : Scalar(0.0)) * square * square * diameter;
  }

  // A fluid gives no power. Expressions are asked at a few places, tables at their points.
  void check_powers(const ConverterLawOf<Scalar>& law) {
    std::vector<double> places = {0.0, 0.25, 0.5, 0.75, 0.9};
    if (!at_.empty()) {
      places.clear();
      for (const Scalar& one : at_) {
        places.push_back(value_of(one));
      }
      std::erase_if(places, [](double one) { return one >= 1.0; });
    }
    for (const double at : places) {
      const std::optional<Scalar> ratio =
          law.torque_ratio ? law.torque_ratio->value(Scalar(at)) : Scalar(1.0);
      const std::optional<Scalar> capacity = law.capacity.value(Scalar(at));
      if (!ratio || !capacity) {
        continue;
      }
      const double torque = value_of(*capacity);
      const double lost = torque * (1.0 - value_of(*ratio) * at);
      if (lost < -kDataRounding * std::abs(torque)) {
        refuse(given_.where,
               fmt::format("torque converter '{}' would generate power at a speed ratio of {:.6g}: "
                           "torque ratio {:.6g}, efficiency {:.6g}",
                           coupling_.name.text,
                           at,
                           value_of(*ratio),
                           value_of(*ratio) * at),
               "the product of speed ratio and torque ratio is at most 1, and the torque of the "
               "pump is not negative before a speed ratio of 1");
        return;
      }
    }
  }

  const CouplingDescription& coupling_;
  const CharacteristicDescription& given_;
  EvaluatorOf<Scalar>& evaluator_;
  Diagnostics& found_;
  std::vector<Scalar> at_;
};

}  // namespace

template <class Scalar>
std::optional<ConverterLawOf<Scalar>> bind_converter(const CouplingDescription& coupling,
                                                     EvaluatorOf<Scalar>& evaluator,
                                                     Diagnostics& found) {
  return ConverterBinder<Scalar>(coupling, evaluator, found).run();
}

template std::optional<ConverterLaw> bind_converter(const CouplingDescription&,
                                                    Evaluator&,
                                                    Diagnostics&);
template std::optional<ConverterLawOf<Dual>> bind_converter(const CouplingDescription&,
                                                            EvaluatorOf<Dual>&,
                                                            Diagnostics&);

}  // namespace kinestat
