// How planets fit, as a report tells it.
#pragma once

#include "mechanism/gears/planet_fit.hpp"
#include "record/record.hpp"
#include "report/in_units.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

const Record<PlanetFit>& planet_fit_record();

/// A line for each, such as "  3 planets 'planet' can stand at equal angles; clearance 0.8 mm".
std::string planet_fit_text(const std::vector<PlanetFit>& fits, const InUnits& in);

}  // namespace kinestat
