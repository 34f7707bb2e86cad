// The key `limits` of the section `synthesis`.
#pragma once

#include "description/synthesis_description.hpp"
#include "forms/mapping.hpp"

namespace kinestat {

const Mapping<SynthesisLimits>& synthesis_limits();

}  // namespace kinestat
