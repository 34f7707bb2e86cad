// What a report of a duty says, whole.
#pragma once

#include "description/mechanism_description.hpp"
#include "record/record.hpp"
#include "studies/duty/duty_solution.hpp"

namespace kinestat {

class Diagnostics;

struct DutyReportView {
  const std::string& file;  ///< path as the user gave it
  const MechanismDescription& description;
  const Mechanism& mechanism;
  const DutyPlan& plan;
  const DutySolution& duty;
  const Diagnostics* found;
};

const Record<DutyReportView>& duty_report_record();

std::string_view word_of(DutyStatus status);

}  // namespace kinestat
