// All columns that a motion could have, whatever its report asks for.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "description/mechanism_description.hpp"
#include "mechanism/motion_plan.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"

namespace kinestat {

struct MotionColumnOffer {
  MotionColumn column;
  MotionReport needs;  ///< a report that has it
};

/// What a column is called, each name as dotted element and quantity: by its own, by the
/// actuator of its freedom, and of a place without "at" or as a position.
std::vector<std::pair<std::string, std::string>> names_of(const MotionColumn& column,
                                                          const Topology& topology);

/// A report of what the word stands for, which must be one of `motion_report_words`.
MotionReport report_of_word(const std::string& word);

/// Adds the words, positions and actions of `some` to `all`.
void unite(MotionReport& all, MotionReport some);

/// Each column once, with what asks for least beside it; those that the case of the plan cannot
/// have are left out. `positions` are those of the freedoms as drawn.
std::vector<MotionColumnOffer> motion_column_offers(
    const MechanismDescription& description,
    const Mechanism& mechanism,
    MotionPlan plan,
    const std::vector<std::optional<double>>& positions);

}  // namespace kinestat
