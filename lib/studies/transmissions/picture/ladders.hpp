// The ladders that a search for transmissions has found.
#pragma once

#include <string>

#include "draw/chart.hpp"
#include "draw/picture.hpp"
#include "studies/transmissions/report/transmission_analysis.hpp"

namespace kinestat {

/// The listed ladders, the best on top, each as a row: sizes of its ratios on one logarithmic axis,
/// and what the best transmission of each asks: beside it or, so that the picture fits a telephone,
/// below. There must be one.
enum class LadderForm { broad, narrow };

Picture draw_ladders(const TransmissionAnalysis& analysis, LadderForm form = LadderForm::broad);

/// All that were found: the largest torque of an element, the largest speed of a shaft and the
/// unevenness of the steps over the mean efficiency, with those that no other beats in both.
Figure trade_off_figure(const TransmissionAnalysis& analysis);

}  // namespace kinestat
