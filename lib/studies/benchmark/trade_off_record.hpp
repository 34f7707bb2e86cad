// What is reported of accuracy against cost.
#pragma once

#include "record/record.hpp"
#include "studies/benchmark/trade_off.hpp"

namespace kinestat {

/// Why a side has no results, or "measured": "too_large".
std::string_view word_of(NoProblem reason);

const Record<TradeOff>& trade_off_record();

}  // namespace kinestat
