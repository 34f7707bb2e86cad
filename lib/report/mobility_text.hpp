// The mobility of one file for people.
#pragma once

#include <string>

#include "report/mobility_report.hpp"

namespace kinestat {

std::string mobility_text(const MobilityAnalysis& analysis);

}  // namespace kinestat
