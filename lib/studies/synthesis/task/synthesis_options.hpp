// How the synthesis tasks of a file are solved.
#pragma once

#include <cstdint>
#include <optional>

#include "core/digit_limits.hpp"

namespace kinestat {

/// Which linkages become mechanism files.
enum class WrittenLinkages {
  usable,  ///< without defect and within the limits
  all
};

struct SynthesisOptions {
  std::optional<int> digits;  ///< of the positions as typed, before what the files say
  WrittenLinkages written = WrittenLinkages::usable;
  bool verifies = false;   ///< moves every linkage as a mechanism, not only those that are written
  std::uint64_t jobs = 0;  ///< threads of a selection; 0: as many as the machine has cores
};

}  // namespace kinestat
