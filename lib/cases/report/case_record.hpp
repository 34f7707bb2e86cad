// What reports say of a case.
#pragma once

#include "cases/analysis.hpp"
#include "record/record.hpp"

namespace kinestat {

struct CaseView {
  const Analysis& analysis;
  const CaseAnalysis& one;
};

const Record<CaseView>& case_record();

}  // namespace kinestat
