// The scheme of a gear train along its axes, as a section: wheels, shafts, elements.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "cases/analysis.hpp"
#include "draw/picture.hpp"

namespace kinestat {

class GearSections;

struct GearSchemeOptions {
  /// Index into Analysis::cases: its engaged elements are filled.
  std::optional<std::size_t> which = {};
  GearSections* sections = nullptr;  ///< of this analysis: several schemes of it share them
};

/// Wheels are strokes at their radii, in columns along the axis; planets carry their pin, carriers
/// and shafts are lines, clutches are two plates, brakes a plate against the hatched housing,
/// inputs and outputs arrows. Radii are to scale where all axes of a train lie in one plane; where
/// planets mesh with each other beside it, the half section is unrolled, and radii differ as little
/// as possible.
///
/// Where shafts stand beside the main axis, the section is developed: each axis has a height of its
/// own, wheels are drawn on both sides of it, those in mesh touch or, with axes between them, are
/// joined by a broken line. A cross fixes a wheel to its shaft, an idler has a bearing. Planets
/// stay in half section about their axis. Empty where why_no_gear_scheme has a reason.
std::optional<Picture> draw_gear_scheme(const Analysis& analysis,
                                        const GearSchemeOptions& options = {});

/// Why there is none, or empty: no gears with parallel axes, or what no section shows
/// (why_no_scheme_train), or no way for its shafts.
std::string why_no_gear_scheme(const Analysis& analysis, GearSections* sections = nullptr);

}  // namespace kinestat
