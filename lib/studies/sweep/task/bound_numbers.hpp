// The numbers of a mechanism that a tape of a sweep takes from it.
#pragma once

#include <span>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "studies/sweep/task/sweep_notes.hpp"

namespace kinestat {

/// What an input that is no parameter is in this mechanism.
double number_of(const SweepInput& input, const Mechanism& mechanism);

/// Whether a mechanism has the freedoms, actions, lossy meshes and flanks of another, each at the
/// same place. Where the axes of two wheels coincide, their teeth have no other flank.
bool has_same_parts(const Mechanism& a, const Mechanism& b);

/// The numbers of one sweep whose states are bound as a whole: those that move, and those that are
/// the same in all samples. A state in which one of the latter is another has no tape.
class BoundNumbers {
 public:
  /// `recorded` is the mechanism with the parameters of the file, which must outlive it; samples
  /// have the same parts.
  BoundNumbers(const Mechanism& recorded, std::span<const Mechanism> samples);

  bool moves(const SweepInput& input) const;

  /// Whether the mechanism of a state has the numbers of the recorded one that do not move, and
  /// neither friction nor cables on pulleys, which come and go with their numbers.
  bool are_kept_by(const Mechanism& mechanism) const;

 private:
  struct Kept {
    SweepInput input;
    double value = 0.0;
  };

  std::vector<SweepInput> moving_;
  std::vector<Kept> kept_;
  const Mechanism* recorded_;
};

}  // namespace kinestat
