// What a comparison says, as a table and as JSON.
#pragma once

#include <string>

#include "record/record.hpp"
#include "report/text_blocks.hpp"
#include "studies/compare/compare.hpp"

namespace kinestat {

/// The places that differ, at most the first 50, and the count of values. Two numbers have so many
/// digits that three of them show the difference.
TextBlocks comparison_blocks(const ReportComparison& comparison);

struct ComparisonView {
  const ReportComparison& comparison;
  const std::string& a;  ///< paths of the reports
  const std::string& b;
};

const Record<ComparisonView>& comparison_record();

/// All differences; `a` and `b` are the paths of the reports.
std::string comparison_json(const ReportComparison& comparison,
                            const std::string& a,
                            const std::string& b);

}  // namespace kinestat
