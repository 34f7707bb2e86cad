// What was found of a mechanism, in sentences.
#pragma once

#include <string>
#include <vector>

#include "pages/file_page.hpp"

namespace kinestat {

/// From the whole to the parts: bodies, couplings and mobility; cases with their ratios and
/// efficiencies; gears; synthesised linkages. Six significant digits, units of the file. Empty for
/// a file of which nothing is known.
std::vector<std::string> summary_sentences(const FilePage& page);

}  // namespace kinestat
