// What a description asks for that this version does not analyse.
#pragma once

#include <string>
#include <vector>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// A section or a key of the format whose analysis is not there.
struct Unanalysed {
  SourceRange where;
  std::string what;               ///< "section 'shift'"
  std::string hint = {};          ///< what would be analysed instead; may be empty
  bool decides = false;           ///< other answers would be wrong without it, so there are none
  bool can_be_counted = false;    ///< a place that is missing: counts do without
  bool is_closure_error = false;  ///< a finite motion begins by closing it

  std::string message() const {
    return what + (is_closure_error ? "; only 'kinestat motion' closes the gap between them"
                                    : " is not analysed yet");
  }
};

/// In the order of the format. Empty for most files.
std::vector<Unanalysed> find_unanalysed(const MechanismDescription& description);

}  // namespace kinestat
