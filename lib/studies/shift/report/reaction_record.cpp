#include "studies/shift/report/reaction_record.hpp"

#include "studies/shift/report/shift_parts.hpp"

namespace kinestat {

namespace {

// By the one ratio or the other, whose ends are the actuator and an input.
std::vector<RatioInUnits> shares_of(const Analysis& analysis,
                                    int actuator,
                                    const std::vector<double>& shares,
                                    std::optional<double> Ratios::*given,
                                    RatioInUnits RatiosInUnits::*wanted) {
  const std::vector<ShiftInput>& inputs = analysis.shift->plan.inputs;
  std::vector<RatioInUnits> result;
  for (std::size_t i = 0; i < inputs.size() && !shares.empty(); ++i) {
    Ratios share;
    share.*given = shares[i];
    const RatiosInUnits in_units =
        ratios_in_units(share,
                        {.input = actuator, .output = inputs[i].actuator},
                        analysis.mechanism,
                        analysis.description.units);
    result.push_back(in_units.*wanted);
  }
  return result;
}

}  // namespace

std::vector<RatioInUnits> rate_shares_of(const Analysis& analysis,
                                         int actuator,
                                         const std::vector<double>& shares) {
  return shares_of(analysis, actuator, shares, &Ratios::ratio, &RatiosInUnits::ratio);
}

std::vector<RatioInUnits> torque_shares_of(const Analysis& analysis,
                                           int actuator,
                                           const std::vector<double>& shares) {
  return shares_of(analysis, actuator, shares, &Ratios::torque_ratio, &RatiosInUnits::torque_ratio);
}

int actuator_of(const Analysis& analysis, const ShiftReaction& reaction) {
  return analysis.shift->plan.others[static_cast<std::size_t>(reaction.other)];
}

void write_shares(const Analysis& analysis, const std::vector<RatioInUnits>& shares, Archive& to) {
  to.begin_map();
  for (std::size_t i = 0; i < shares.size(); ++i) {
    to.element(name_of_actuator(analysis, analysis.shift->plan.inputs[i].actuator), {});
    to.number(shares[i].value, shares[i].unit);
  }
  to.end_map();
}

const Record<ReactionView>& reaction_record() {
  using View = ReactionView;
  static const Record<View> record("One machine that reacts.", [](Record<View>& keys) {
    keys.quantity("speed",
                  QuantityKind::angular_velocity,
                  "Its speed; null where it is not determined.",
                  [](const View& v) { return v.reaction.rate; });
    keys.quantity("torque",
                  QuantityKind::moment,
                  "Its torque, tail on head, without losses; null without 'input_action', zero "
                  "where elements hold what it holds elsewhere.",
                  [](const View& v) { return v.reaction.torque; });
    keys.custom("speed_shares",
                map_shape(number_shape(ByContext::rate_ratio, true)),
                "Its speed is the sum of the speeds of the inputs times these.",
                [](const View& v, Archive& to) {
                  write_shares(
                      v.analysis,
                      rate_shares_of(
                          v.analysis, actuator_of(v.analysis, v.reaction), v.reaction.speed_shares),
                      to);
                })
        .not_in_tables();
    keys.custom("torque_shares",
                map_shape(number_shape(ByContext::action_ratio, true)),
                "Its torque is the sum of the torques of the inputs times these; empty where it "
                "carries none.",
                [](const View& v, Archive& to) {
                  write_shares(v.analysis,
                               torque_shares_of(v.analysis,
                                                actuator_of(v.analysis, v.reaction),
                                                v.reaction.torque_shares),
                               to);
                })
        .not_in_tables();
  });
  return record;
}

}  // namespace kinestat
