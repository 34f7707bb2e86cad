#include "cases/analysis_findings.hpp"

#include <algorithm>

#include "cases/case_findings.hpp"

namespace kinestat {

namespace {

// What is wrong with a mesh is so in every case.
bool is_reported(const CaseFinding& one, const Diagnostics& found) {
  return std::ranges::any_of(found.items(), [&](const Diagnostic& other) {
    return other.code == one.code && other.where == one.where && other.message == one.message;
  });
}

}  // namespace

void add_findings(const Analysis& analysis, Diagnostics& found) {
  for (const CaseAnalysis& one : analysis.cases) {
    const CaseFindings of_case = find_case_findings(judged_file(analysis), one);
    for (const CaseFinding& finding : of_case.items()) {
      if (!is_reported(finding, found)) {
        add(finding, found);
      }
    }
  }
}

}  // namespace kinestat
