// Parts of the record of a shift table.
#pragma once

#include <string>

#include "cases/analysis.hpp"
#include "record/record.hpp"
#include "studies/shift/gear_limits.hpp"

namespace kinestat {

const std::string& name_of_actuator(const Analysis& analysis, int actuator);

/// Of an index into ShiftPlan::elements.
const std::string& name_of_element(const Analysis& analysis, int element);

/// What a gear takes of one limit.
const Record<LimitUse>& limit_record();

/// A change between two gears of the table.
struct ChangeView {
  const Analysis& analysis;
  const GearChange& change;

  const std::string& state(int index) const;

  /// "M1 - M2"
  std::string name() const;
};

const Record<ChangeView>& change_record();

/// The numbers of the former alone.
const Record<ChangeView>& change_number_record();

}  // namespace kinestat
