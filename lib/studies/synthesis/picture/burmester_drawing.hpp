// The plane of a synthesis task: positions, poles, curves of circle and centre points, dyads.
#pragma once

#include <cstddef>

#include "draw/picture.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// How long the longer side of the plane is [px].
inline constexpr double kBurmesterSize = 560.0;

/// One task of an analysis, in the fixed frame and to scale, moving points as they lie in the first
/// position. Of four positions the curves of circle points and centre points; of five those of the
/// first four and of the four that leave out another one, which meet in the Burmester points. The
/// positions are segments that begin in the origin of the moving frame and point along its x axis.
/// Of the best linkage both cranks and the coupler are drawn in the first position. A stretch of
/// the curve of circle points is grey and dashed where the dyad, beside the first dyad of that
/// linkage, has a defect or breaks a limit; the legend names the reasons.
Picture draw_burmester(const SynthesisAnalysis& analysis,
                       std::size_t task,
                       double size = kBurmesterSize);

}  // namespace kinestat
