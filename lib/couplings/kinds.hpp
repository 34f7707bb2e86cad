// The kinds of couplings.
#pragma once

#include <span>
#include <string_view>

#include "couplings/kind.hpp"

namespace kinestat {

/// All, in the order of the enumeration.
std::span<const CouplingKind* const> coupling_kinds();

const CouplingKind& kind_of(CouplingType type);

/// The word of the file for a type.
std::string_view word_of(CouplingType type);

}  // namespace kinestat
