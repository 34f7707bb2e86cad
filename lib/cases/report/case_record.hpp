// What reports say of a case.
#pragma once

#include "cases/analysis.hpp"
#include "record/record.hpp"

namespace kinestat {

struct CaseView {
  const Mechanism& mechanism;
  const FileUnits& units;
  const CaseAnalysis& one;
  const Analysis* analysis = nullptr;  ///< of which it is a case, for what depends on all
};

const Record<CaseView>& case_record();

}  // namespace kinestat
