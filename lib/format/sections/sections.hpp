// The sections of a mechanism file, each declared once.
#pragma once

#include "description/mechanism_description.hpp"
#include "format/mapping.hpp"

namespace kinestat {

const Mapping<MotionDescription>& motion_section();

/// The sections as the keys of the file.
const Mapping<MechanismDescription>& file_sections();

}  // namespace kinestat
