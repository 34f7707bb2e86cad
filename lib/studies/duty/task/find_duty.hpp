// A duty as a file asks for it: the section, its table, and what is wrong with points.
#pragma once

#include <optional>
#include <string>

#include "cases/findings/case_findings.hpp"
#include "core/diagnostic.hpp"
#include "studies/duty/duty_solution.hpp"

namespace kinestat {

struct FoundDuty {
  DutyPlan plan;
  DutySolution solution;
};

/// Of the section `duty` and of the table that it names beside `path`; of `table` alone, a path,
/// unless that is empty. Adds what is wrong with points that have no answer. Empty iff an error was
/// added before anything was solved, as where a file has neither.
std::optional<FoundDuty> find_duty(const std::string& path,
                                   const std::string& table,
                                   const JudgedFile& file,
                                   Diagnostics& found);

}  // namespace kinestat
