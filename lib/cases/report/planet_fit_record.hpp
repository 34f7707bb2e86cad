// How planets fit, as a report tells it.
#pragma once

#include "mechanism/gears/planet_fit.hpp"
#include "record/record.hpp"
#include "report/in_units.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

const Record<PlanetFit>& planet_fit_record();

/// "4 planets 'planet' can be equally spaced; tip clearance 26 mm", for each.
std::vector<std::string> planet_fit_sentences(const std::vector<PlanetFit>& fits,
                                              const InUnits& in);

/// A line for each, such as "  3 planets 'planet' can stand at equal angles; clearance 0.8 mm".
std::string planet_fit_text(const std::vector<PlanetFit>& fits, const InUnits& in);

}  // namespace kinestat
