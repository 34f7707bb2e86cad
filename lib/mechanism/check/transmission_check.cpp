#include <string>

#include <fmt/format.h>

#include "mechanism/check/section_checks.hpp"

namespace kinestat {

namespace {

constexpr NumberRule number_rule(const NumberRange& range, std::string_view allowed) {
  return {.kind = QuantityKind::dimensionless, .range = range, .allowed = allowed};
}

constexpr NumberRule kSetCount = number_rule(kSets, "a whole number from 0 to 4");
constexpr NumberRule kElementCount = number_rule(kShiftElements, "a whole number from 0 to 7");
constexpr NumberRule kEngagedCount = number_rule(kEngagedElements, "a whole number from 1 to 4");
constexpr NumberRule kNoneOrOne = number_rule(kAtMostOne, "0 or 1");
constexpr NumberRule kGearCount = number_rule(kForwardGears, "a whole number from 2 to 20");
constexpr NumberRule kRatio = number_rule(kAboveZero, "a number above 0");
constexpr NumberRule kSetRatio =
    number_rule(kStationaryRatio,
                "teeth of the ring by those of the sun, above 1 and up to 10, for example 2.4");
constexpr NumberRule kToothCount = number_rule(kSetTeeth, "a whole number from 6 to 1000");
constexpr NumberRule kPlanetCount = number_rule(kPlanets, "a whole number from 1 to 64");
constexpr NumberRule kShare = number_rule(kLostShare, "a fraction from 0 to below 1");
constexpr NumberRule kLeastEfficiency = number_rule(kKeptShare, "a fraction above 0 and at most 1");
constexpr NumberRule kNumber = number_rule(kNotNegativeWhole, "a whole number, not negative");

class TransmissionCheck {
 public:
  TransmissionCheck(const SectionContext& context, const TransmissionDescription& task)
      : context_(context), task_(task) {}

  void run() {
    check(task_.sets.simple, kSetCount, "simple", "sets");
    check(task_.sets.double_planet, kSetCount, "double_planet", "sets");
    context_.number(task_.elements.all, kElementCount, "'elements' of 'transmission'");
    check(task_.elements.clutches, kElementCount, "clutches", "elements");
    check(task_.elements.brakes, kElementCount, "brakes", "elements");
    context_.number(task_.engaged, kEngagedCount, "'engaged' of 'transmission'");
    context_.number(task_.free_shafts, kNoneOrOne, "'free_shafts' of 'transmission'");
    check(task_.gears.forward, kGearCount, "forward", "gears");
    check(task_.gears.reverse, kNoneOrOne, "reverse", "gears");
    check_range(task_.ratios.first, "first");
    check_range(task_.ratios.last, "last");
    check_range(task_.ratios.spread, "spread");
    check_range(task_.ratios.step, "step");
    check_range(task_.ratios.reverse, "reverse");
    check_stationary(task_.stationary_ratio.simple, "simple");
    check_stationary(task_.stationary_ratio.double_planet, "double_planet");
    if (task_.teeth) {
      check_teeth(*task_.teeth);
    }
    check(task_.limits.element_torque, kRatio, "element_torque", "limits");
    check(task_.limits.element_slip, kRatio, "element_slip", "limits");
    check(task_.limits.shaft_speed, kRatio, "shaft_speed", "limits");
    check(task_.limits.planet_speed, kRatio, "planet_speed", "limits");
    check(task_.limits.efficiency, kLeastEfficiency, "efficiency", "limits");
    check(task_.limits.rotating_clutches, kElementCount, "rotating_clutches", "limits");
    check(task_.limits.hollow_shafts, kNumber, "hollow_shafts", "limits");
    check(task_.losses.simple, kShare, "simple", "losses");
    check(task_.losses.double_planet, kShare, "double_planet", "losses");
    if (task_.structures) {
      check(task_.structures->from, kNumber, "from", "structures");
      check(task_.structures->to, kNumber, "to", "structures");
    }
  }

 private:
  void check(const std::optional<Value>& value,
             const NumberRule& rule,
             std::string_view key,
             std::string_view of) const {
    context_.number(value, rule, fmt::format("'{}' of '{}'", key, of));
  }

  void check_range(const std::optional<ValueRange>& range, std::string_view key) const {
    check_ends(range, kRatio, key, "ratios");
  }

  void check_ends(const std::optional<ValueRange>& range,
                  const NumberRule& rule,
                  std::string_view key,
                  std::string_view of) const {
    if (range) {
      for (const Value& end : range->ends) {
        check(end, rule, key, of);
      }
    }
  }

  void check_teeth(const WantedTeeth& teeth) const {
    check_ends(teeth.sun, kToothCount, "sun", "teeth");
    check_ends(teeth.ring, kToothCount, "ring", "teeth");
    check(teeth.planet, kToothCount, "planet", "teeth");
    for (const Value& count : teeth.planets) {
      check(count, kPlanetCount, "planets", "teeth");
    }
  }

  void check_stationary(const std::optional<StationaryRange>& range, std::string_view kind) const {
    if (!range) {
      return;
    }
    const std::string of = fmt::format("{}' of 'stationary_ratio", kind);
    check(range->from, kSetRatio, "from", of);
    check(range->to, kSetRatio, "to", of);
    for (const Value& value : range->values) {
      check(value, kSetRatio, "values", of);
    }
  }

  const SectionContext& context_;
  const TransmissionDescription& task_;
};

}  // namespace

void check_transmission(const SectionContext& context, const TransmissionDescription& task) {
  TransmissionCheck(context, task).run();
}

}  // namespace kinestat
