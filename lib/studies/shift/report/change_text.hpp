// Changes between gears as text.
#pragma once

#include "cases/analysis.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// What a change asks of the elements, there and back. Empty without any.
TextBlocks change_blocks(const Analysis& analysis);

/// The changes whose slip the file asks for: times, energies, torques. Empty without any.
TextBlocks slip_blocks(const Analysis& analysis);

}  // namespace kinestat
