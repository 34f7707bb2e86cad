// The mapping `transmission` of the section `synthesis`.
#pragma once

#include "description/transmission_description.hpp"
#include "forms/mapping.hpp"

namespace kinestat {

const Mapping<TransmissionDescription>& transmission_mapping();

}  // namespace kinestat
