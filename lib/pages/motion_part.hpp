// The finite motion of a file: its drawing, tables and curves.
#pragma once

#include "pages/section_writer.hpp"

namespace kinestat {

/// Of a file that asks for a motion without getting one, that there is none.
void add_motion_part(SectionWriter& section);

}  // namespace kinestat
