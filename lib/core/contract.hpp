// A broken promise between two parts of the program: our bug, never the user's.
#pragma once

#include <stdexcept>

namespace kinestat {

/// Thrown by KINESTAT_EXPECTS; only `run` catches it, so that one file fails and the batch goes on.
class ContractViolation : public std::logic_error {
 public:
  ContractViolation(const char* condition, const char* file, int line);
};

}  // namespace kinestat

/// Checks a condition that only a bug can break; active in release builds too. The name of the file
/// has no folders, so that the program is the same wherever its sources are.
#define KINESTAT_EXPECTS(condition)                                             \
  do {                                                                          \
    if (!(condition)) {                                                         \
      throw ::kinestat::ContractViolation(#condition, __FILE_NAME__, __LINE__); \
    }                                                                           \
  } while (false)
