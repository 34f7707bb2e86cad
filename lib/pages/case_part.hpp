// The cases or gears of a file: a choice of them, a panel for each, and all side by side.
#pragma once

#include "pages/section_writer.hpp"

namespace kinestat {

/// Nothing if there are none. The file must have an analysis.
void add_case_part(SectionWriter& section);

}  // namespace kinestat
