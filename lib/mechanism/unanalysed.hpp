// Parts of a description that this version does not analyse.
#pragma once

#include <string>
#include <vector>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// A section or key of the format that is not analysed.
struct Unanalysed {
  SourceRange where;
  std::string what;               ///< "section 'shift'"; of a missing place a whole sentence
  std::string hint = {};          ///< what would be analysed instead; may be empty
  bool decides = false;           ///< answers without it would be wrong, so there are none
  bool can_be_counted = false;    ///< a missing place, which mobility counts do not need
  bool is_closure_error = false;  ///< a gap, which a finite motion closes before it starts

  std::string message() const {
    if (can_be_counted) {
      return what;
    }
    return what + (is_closure_error ? "; only 'kinestat motion' closes the gap between them"
                                    : " is not analysed yet");
  }
};

/// Finds these parts, in the order of the format. There are none in most files.
std::vector<Unanalysed> find_unanalysed(const MechanismDescription& description);

}  // namespace kinestat
