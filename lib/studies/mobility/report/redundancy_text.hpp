// What is redundant and which releases would remove it, for people.
#pragma once

#include <string>

#include "studies/mobility/report/mobility_report.hpp"

namespace kinestat {

/// The self-stresses in space and, where the mechanism has one, in its plane or in the least order
/// that holds its motions; then the advice. Only for a mechanism with places.
std::string redundancies_text(const MobilityAnalysis& analysis);

}  // namespace kinestat
