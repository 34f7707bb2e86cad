// What is said of a dyad that the file gives and that the positions do not have.
#pragma once

#include <cstddef>
#include <span>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "studies/synthesis/dyads/given_dyad.hpp"

namespace kinestat {

/// An error at the point that is wrong, or at the dyad that lacks one, with what to write instead.
void add_fault(const CompletedDyad& completed,
               std::size_t dyad,
               std::span<const PositionJets> positions,
               const MechanismDescription& description,
               Diagnostics& found);

}  // namespace kinestat
