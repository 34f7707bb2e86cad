// How pictures are called.
#pragma once

#include <string>
#include <string_view>

#include "cases/analysis.hpp"
#include "description/mechanism_description.hpp"

namespace kinestat {

/// The name of the mechanism or, without one, of its file; "<stdin>" for standard input.
std::string shown_name(const std::string& file, const MechanismDescription& description);

/// "Shift matrix: Ravigneaux transmission".
std::string picture_title(std::string_view what,
                          const std::string& file,
                          const MechanismDescription& description);
std::string picture_title(std::string_view what, const Analysis& analysis);

/// "Power flow, case M1: Ravigneaux transmission".
std::string picture_title_of_case(std::string_view what,
                                  const CaseAnalysis& one,
                                  const Analysis& analysis);

/// "Power flow, case M1" of an analysis that has one case alone; of others without its name.
std::string words_of_cases(std::string_view what, const Analysis& analysis);

/// The same with the name of the mechanism.
std::string picture_title_of_cases(std::string_view what, const Analysis& analysis);

}  // namespace kinestat
