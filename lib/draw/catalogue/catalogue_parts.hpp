// The rows of the catalogue, by what they are of.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "draw/catalogue/catalogue.hpp"

namespace kinestat {

/// Mechanisms and their graphs.
std::span<const PictureKind> drawing_kinds();

/// What cases have, gears among them.
std::span<const PictureKind> case_kinds();

/// Motions, syntheses and comparisons.
std::span<const PictureKind> study_kinds();

/// Why no case that is asked for counts; `what` is "velocities that are solved". Empty if one does.
std::string why_not_in_cases(const PictureSource& source,
                             bool (*counts)(const CaseAnalysis&),
                             std::string_view what);

}  // namespace kinestat
