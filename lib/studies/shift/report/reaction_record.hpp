// What reports say of the machines that react in a gear.
#pragma once

#include <vector>

#include "cases/analysis.hpp"
#include "cases/report/ratio_in_units.hpp"
#include "record/record.hpp"

namespace kinestat {

/// In the units of the file, for each input: speed and torque of an actuator per those of it.
std::vector<RatioInUnits> rate_shares_of(const Analysis& analysis,
                                         int actuator,
                                         const std::vector<double>& shares);
std::vector<RatioInUnits> torque_shares_of(const Analysis& analysis,
                                           int actuator,
                                           const std::vector<double>& shares);

/// The actuator of a reaction.
int actuator_of(const Analysis& analysis, const ShiftReaction& reaction);

struct ReactionView {
  const Analysis& analysis;
  const ShiftReaction& reaction;
};

const Record<ReactionView>& reaction_record();

/// A number for each input, by its name.
void write_shares(const Analysis& analysis, const std::vector<RatioInUnits>& shares, Archive& to);

}  // namespace kinestat
