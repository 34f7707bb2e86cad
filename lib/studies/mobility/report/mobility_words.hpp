// The findings of the mobility pass in words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/mobility/report/mobility_report.hpp"

namespace kinestat {

/// "x", or "(0.6, 0, 0.8)" for a direction that is along no world axis.
std::string direction_words(const Vec3& direction);

/// "couple about x", "force along z", "force along x through (0, 10, 0)", "wrench of pitch 3 mm
/// along …"; empty where no single wrench goes round. A sign is meaningless and left out.
std::string constraint_words(const MobilityAnalysis& analysis, const RedundantConstraint& one);

/// "rotation about x", "translation along (0.6, 0, 0.8)": what a released coupling frees more.
std::string freedom_words(const Twist& twist);

/// Sentences on what the counts have to do with each other and what follows.
std::vector<std::string> mobility_remarks(const MobilityAnalysis& analysis);

}  // namespace kinestat
