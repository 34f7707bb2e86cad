#include "math/elimination/elimination_tape.hpp"

#include "math/elimination/internal/elimination_recorder.hpp"

namespace kinestat {

std::optional<std::vector<TapeNumber>> record_elimination(const TapedMatrix& matrix,
                                                          std::span<const TapedUnknown> known,
                                                          std::span<const int> wanted,
                                                          LaneRecorder& recorder) {
  EliminationRecorder elimination(matrix, known, recorder);
  return elimination.run() ? std::optional(elimination.substitute(wanted)) : std::nullopt;
}

}  // namespace kinestat
