// How the values of cases move with parameters, in the forms of a report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "report/report_forms.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// One parameter of the file; numbers in its unit there.
struct SensitivityParameter {
  std::string name;
  std::string unit;  ///< empty for a bare number
  double value = 0.0;
};

/// One value of a case and its derivatives, in the units of the file.
struct SensitivityValue {
  std::string name;
  std::string unit;
  double value = 0.0;
  /// What completes the actions of which it is made, where equilibrium leaves these open.
  IndeterminateChoice completed_by = IndeterminateChoice::report;
  /// One a parameter, in `unit` per its unit; empty where there is none.
  std::vector<std::optional<double>> derivatives;
};

struct CaseSensitivity {
  std::string label;
  std::vector<SensitivityValue> values;
};

/// "rad/s per mm"; a bare parameter leaves the unit of the value.
std::string derivative_unit(const SensitivityValue& value, const SensitivityParameter& parameter);

/// p/v dv/dp: by how many per cent the value moves if the parameter moves by one. Empty for a value
/// of zero or without derivative.
std::optional<double> relative_sensitivity(const SensitivityValue& value,
                                           const SensitivityParameter& parameter,
                                           std::optional<double> derivative);

/// The values of one case, each with a table of its parameters, the strongest first.
TextBlocks sensitivity_blocks(const CaseSensitivity& one,
                              const std::vector<SensitivityParameter>& parameters);

/// JSON `cases.<label>.sensitivity.<value>.by.<parameter>`; tables with the strongest parameter
/// first.
FileReport make_sensitivity_report(const std::string& file,
                                   const MechanismDescription& description,
                                   const std::vector<SensitivityParameter>& parameters,
                                   const std::vector<CaseSensitivity>& cases,
                                   const ReportForms& forms,
                                   const Diagnostics& found);

}  // namespace kinestat
