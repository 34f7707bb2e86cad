// A proof that a rank modulo a prime is no less than that of the fractions themselves.
#pragma once

#include <cstdint>
#include <vector>

#include "math/elimination/internal/field_elimination.hpp"
#include "math/elimination/internal/modular_field.hpp"

namespace kinestat {

/// What the proof needs to know of an entry a: |a| or a little more, and its denominator; 0 where
/// that has more than 60 bits.
struct EntrySize {
  int row = 0;
  int column = 0;
  double size = 0.0;
  std::uint64_t denominator = 1;
};

/// Whether each free column has a vector of small fractions x, 1 there and 0 at the other free
/// columns, with A x = 0: then A has no larger rank than modulo the prime p. An equation that holds
/// modulo p holds if its sum, times all denominators, is smaller than p. `elimination` must have no
/// columns that come last. False proves nothing; so it is for more than a few free columns.
bool null_vectors_hold(const FieldElimination<ModularField>& elimination,
                       const std::vector<EntrySize>& entries,
                       int columns);

}  // namespace kinestat
