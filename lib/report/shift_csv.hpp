// The states of a transmission as a tidy table.
#pragma once

#include <string>

#include "report/analysis.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// The rows of the key `shift` of a report, with a header: `case` is the state, `status` its class;
/// an engaged element has the quantity "engaged".
std::string shift_csv(const Analysis& analysis, const Json& shift);

}  // namespace kinestat
