// The kinds of couplings.
#pragma once

#include <span>
#include <string_view>

#include "couplings/kind.hpp"

namespace kinestat {

/// All, in the order of the enumeration.
std::span<const CouplingKind* const> coupling_kinds();

const CouplingKind& kind_of(CouplingType type);

/// Whether the kind has the key.
bool takes(const CouplingKind& kind, CouplingKey key);

/// Whether it is teeth in mesh.
bool has_teeth(CouplingType type);

/// Whether it is teeth between two wheels, each of which may be a planet.
bool joins_wheels(CouplingType type);

/// The word of the file for a type.
std::string_view word_of(CouplingType type);

}  // namespace kinestat
