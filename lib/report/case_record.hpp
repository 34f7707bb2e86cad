// What reports say of a case.
#pragma once

#include "record/record.hpp"
#include "report/analysis.hpp"

namespace kinestat {

struct CaseView {
  const Analysis& analysis;
  const CaseAnalysis& one;
};

const Record<CaseView>& case_record();

}  // namespace kinestat
