// What must agree in what several commands say of one mechanism, whatever it is.
#pragma once

#include <string>

#include "report/json_values.hpp"

namespace kinestat::fuzz {

/// Ends the process where a rate or an action of two reports differs by more than their evidence
/// allows. `other` is the report with more digits or exact numbers, or, if `is_fast`, in doubles
/// without bounds.
void check_accuracies(const Json& automatic, const Json& other, bool is_fast);

/// Every number of the table is one of the report.
void check_table(const Json& report, const std::string& csv);

/// The rates and actions of the text are those of the report, with the digits it shows.
void check_text(const Json& report, const std::string& text);

/// A motion that begins where the mechanism is drawn begins as analysed.
void check_first_row(const Json& report, const Json& motion);

/// A row of a sweep, whose one state is the file as it is, says what is analysed.
void check_sweep_row(const Json& report, const Json& row);

}  // namespace kinestat::fuzz
