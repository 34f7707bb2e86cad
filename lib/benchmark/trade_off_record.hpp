// What is reported of accuracy against cost.
#pragma once

#include "benchmark/trade_off.hpp"
#include "record/record.hpp"

namespace kinestat {

/// Why a side has no results, or "measured": "too_large".
std::string_view word_of(NoProblem reason);

const Record<TradeOff>& trade_off_record();

}  // namespace kinestat
