#include "run/sensitivity.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "cases/chosen_case.hpp"
#include "cases/findings/case_findings.hpp"
#include "cases/solve_cases.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "expression/parameters.hpp"
#include "expression/unit_quotient.hpp"
#include "files/each_file.hpp"
#include "files/parameter_names.hpp"
#include "mechanism/bind/derivatives.hpp"
#include "studies/sensitivity/adjoint.hpp"
#include "studies/sensitivity/moving_load_slopes.hpp"
#include "studies/sensitivity/report/sensitivity_report.hpp"

namespace kinestat {

namespace {

// A parameter that takes part, with its unit.
struct Variable {
  int index = 0;  ///< in the description
  SensitivityParameter shown;
  double factor = 1.0;  ///< SI per unit
};

// The unit of a value as text, and SI per unit.
std::pair<std::string, double> unit_of(const ReportedValue& value, const FileUnits& units) {
  if (!value.per) {
    return {units.text(value.kind), units.factor(value.kind)};
  }
  return {
      value.kind == *value.per ? "" : unit_quotient(units.text(value.kind), units.text(*value.per)),
      units.factor(value.kind) / units.factor(*value.per)};
}

// A pulley where cables have friction, or would with other numbers: their derivatives are not
// known.
const CableStation* cable_with_friction(const MechanismDescription& description) {
  for (const CableDescription& cable : description.cables) {
    for (const CableStation& station : cable.over) {
      if (station.eta || (station.friction && station.slip)) {
        return &station;
      }
    }
  }
  return nullptr;
}

void warn_of_cables(const Analysis& analysis, Diagnostics& found) {
  const CableStation* cable = cable_with_friction(analysis.description);
  const bool has_actions = std::ranges::any_of(
      analysis.cases, [](const CaseAnalysis& one) { return one.action.has_value(); });
  if (cable != nullptr && has_actions) {
    found.warning("W0302",
                  cable->where,
                  "derivatives of actions are not analysed yet where cables have friction",
                  "compare two analyses with --set");
  }
}

bool follows_curves(const CaseAnalysis& one, const Mechanism& mechanism) {
  return one.which.follows_curves() ||
         (!one.springs.empty() && std::ranges::any_of(mechanism.springs, [](const Spring& spring) {
           return spring.force.law != nullptr;
         }));
}

void warn_of_curves(const Analysis& analysis, Diagnostics& found) {
  const auto one = std::ranges::find_if(analysis.cases, [&](const CaseAnalysis& each) {
    return follows_curves(each, analysis.mechanism);
  });
  if (one != analysis.cases.end()) {
    found.warning("W0302",
                  one->which.where,
                  "derivatives of actions are not analysed yet in cases that follow curves",
                  "compare two analyses with --set");
  }
}

class SensitivityJob {
 public:
  SensitivityJob(const Analysis& analysis, const SensitivityChoice& choice, Diagnostics& found)
      : analysis_(analysis), choice_(choice), found_(found) {}

  // Empty iff an error was added.
  std::optional<FoundSensitivity> run() {
    const int errors_before = found_.error_count();
    choose_parameters();
    check_case();
    if (found_.error_count() > errors_before) {
      return std::nullopt;
    }
    std::vector<int> indices;
    std::vector<SensitivityParameter> shown;
    for (const Variable& one : variables_) {
      indices.push_back(one.index);
      shown.push_back(one.shown);
    }
    const MechanismDerivatives derivatives =
        bind_derivatives(analysis_.description, analysis_.mechanism, indices);
    const AdjointBases bases = find_adjoint_bases(analysis_.mechanism, derivatives);
    std::vector<CaseSensitivity> cases;
    for (std::size_t c = 0; c < analysis_.cases.size(); ++c) {
      const CaseAnalysis& one = analysis_.cases[c];
      if (choice_.case_label.empty() || choice_.case_label == one.which.label) {
        cases.push_back({.label = one.which.label, .values = differentiate(c, bases, derivatives)});
      }
    }
    check_answered();
    if (found_.error_count() > errors_before) {
      return std::nullopt;
    }
    return FoundSensitivity{.parameters = std::move(shown), .cases = std::move(cases)};
  }

 private:
  void choose_parameters() {
    const MechanismDescription& description = analysis_.description;
    const std::vector<std::string> names = parameter_names(description);
    for (const std::string& name : choice_.parameters) {
      if (std::ranges::find(names, name) == names.end()) {
        found_.error("E0101",
                     {},
                     fmt::format("--by '{}': there is no such parameter", printable(name)),
                     parameter_hint(name, description));
      }
    }
    if (names.empty() && choice_.parameters.empty()) {
      found_.error("E0101",
                   {},
                   "the file has no parameters to vary",
                   "give the numbers of interest names under 'parameters:'");
    }
    const ParameterTable table = evaluate_parameters(parameters_of(description)).table;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool takes_part =
          choice_.parameters.empty() ||
          std::ranges::find(choice_.parameters, names[i]) != choice_.parameters.end();
      const Quantity* value = takes_part ? table.find(names[i]) : nullptr;
      if (value != nullptr) {
        const NamedUnit unit = description.units.unit_of(value->dimension);
        variables_.push_back({.index = static_cast<int>(i),
                              .shown = {.name = names[i],
                                        .unit = unit.text,
                                        .value = unit.scale.written_from_si(value->value)},
                              .factor = unit.scale.factor()});
      }
    }
  }

  void check_case() {
    std::vector<std::string> labels;
    for (const CaseAnalysis& one : analysis_.cases) {
      labels.push_back(one.which.label);
    }
    if (labels.empty()) {
      found_.error("E0101", {}, "the file has no cases to differentiate", "add a case: help cases");
    } else if (!choice_.case_label.empty() &&
               std::ranges::find(labels, choice_.case_label) == labels.end()) {
      refuse_case(choice_.case_label, labels, found_);
    }
  }

  std::vector<SensitivityValue> differentiate(std::size_t case_index,
                                              const AdjointBases& drawn_bases,
                                              const MechanismDerivatives& common) {
    const CaseAnalysis& one = analysis_.cases[case_index];
    const bool has_rates =
        one.motion && one.motion->status == SolveStatus::solved && !has_found_slip(one);
    Mechanism mechanism = analysis_.mechanism;
    MechanismDerivatives derivatives = common;
    const bool has_moving_loads = one.which.has_inertia() || !one.springs.empty();
    const bool has_actions =
        one.action && !has_found_slip(one) && !follows_curves(one, mechanism) &&
        !one.action->magnitudes.empty() && cable_with_friction(analysis_.description) == nullptr &&
        (!has_moving_loads || take_moving_loads(case_index, has_rates, mechanism, derivatives));
    load_coast_flanks(one.coast_flanks, mechanism.geometry);
    load_coast_flanks(one.coast_flanks, derivatives.geometry);
    const DualCase values(mechanism,
                          case_index,
                          has_rates ? &*one.motion : nullptr,
                          has_actions ? &*one.action : nullptr,
                          derivatives);
    const AdjointBases bases = one.coast_flanks.empty() && !has_moving_loads
                                   ? drawn_bases
                                   : find_adjoint_bases(mechanism, derivatives);
    CaseAdjoint adjoint(values, bases);
    std::vector<SensitivityValue> result;
    for (const std::string& name :
         choice_.values.empty() ? usual_value_names(values) : choice_.values) {
      if (const auto value = find_value(values, name)) {
        result.push_back(in_file_units(*value, name, adjoint));
        if (is_completed(values, *value)) {
          result.back().completed_by = one.action->completion.by;
        }
        answered_.insert(name);
      }
    }
    if (known_names_.empty()) {
      known_names_ = reported_value_names(values);
    }
    return result;
  }

  // Springs and forces of inertia become loads of the case; false where it is told why their
  // derivatives are not known.
  bool take_moving_loads(std::size_t case_index,
                         bool has_rates,
                         Mechanism& mechanism,
                         MechanismDerivatives& derivatives) {
    const CaseAnalysis& one = analysis_.cases[case_index];
    const DualCase values(
        mechanism, case_index, has_rates ? &*one.motion : nullptr, nullptr, derivatives);
    auto found = moving_load_slopes(values, one.dynamics ? &*one.dynamics : nullptr);
    if (const auto* obstacle = std::get_if<LoadSlopeObstacle>(&found)) {
      found_.warning(
          "W0302",
          one.which.where,
          obstacle->coupling
              ? fmt::format("derivatives of actions are not analysed yet in case '{}', since how "
                            "coupling '{}' moves its bodies on has none",
                            printable(one.which.label),
                            mechanism.topology.coupling(*obstacle->coupling).name)
              : fmt::format("derivatives of actions are not analysed yet in case '{}', whose "
                            "velocities leave accelerations open",
                            printable(one.which.label)),
          "compare two analyses with --set");
      return false;
    }
    mechanism.cases[case_index].loads = one.which.loads;
    std::ranges::move(std::get<std::vector<WrenchOf<Dual>>>(found),
                      std::back_inserter(derivatives.cases[case_index].loads));
    return true;
  }

  // Its motion follows from a search, and not from the equations of the case alone.
  static bool has_found_slip(const CaseAnalysis& one) {
    return one.converter_search && one.converter_search->which;
  }

  static bool is_of_mesh_losses(const std::string& name) {
    return name.find("power/losses/") != std::string::npos ||
           name.find("power/efficiency/carrier") != std::string::npos ||
           name.find("power/efficiency/absolute") != std::string::npos;
  }

  static std::optional<ReportedValue> find_value(const DualCase& values, const std::string& name) {
    const std::string_view path = name.starts_with('/') ? std::string_view(name).substr(1) : name;
    const std::string prefix = fmt::format("cases/{}/", values.which().label);
    return find_reported_value(values,
                               path.starts_with(prefix) ? path.substr(prefix.size()) : path);
  }

  // A value may be missing in some cases, but not in all.
  void check_answered() {
    for (const std::string& name : choice_.values) {
      if (!answered_.contains(name)) {
        found_.error(
            "E0101",
            {},
            fmt::format("--of '{}': no case has such a value with derivatives", printable(name)),
            is_of_mesh_losses(name)
                ? "what losses of meshes make of a case has no derivatives yet; "
                  "compare two analyses with --set"
            : std::ranges::any_of(analysis_.cases, has_found_slip)
                ? "a speed ratio that follows from the torque of a converter has no derivatives "
                  "yet; "
                  "give the motion of both its sides"
            : known_names_.empty()
                ? "no case is solved: 'kinestat analyze' says why"
                : guess_before(name,
                               known_names_,
                               fmt::format("write one of {}, or a path of the report below a case: "
                                           "kinematics/bodies/BODY/linear/0",
                                           plain_list(known_names_))));
      }
    }
  }

  SensitivityValue in_file_units(const ReportedValue& value,
                                 const std::string& name,
                                 CaseAdjoint& adjoint) const {
    const auto [unit, factor] = unit_of(value, analysis_.description.units);
    SensitivityValue result{.name = name,
                            .unit = unit,
                            .value = value.value.value / factor,
                            .completed_by = IndeterminateChoice::report,
                            .derivatives = adjoint.derivatives_of(value)};
    for (std::size_t p = 0; p < variables_.size(); ++p) {
      if (result.derivatives[p]) {
        *result.derivatives[p] *= variables_[p].factor / factor;
      }
    }
    return result;
  }

  const Analysis& analysis_;
  const SensitivityChoice& choice_;
  Diagnostics& found_;
  std::vector<Variable> variables_;
  std::set<std::string> answered_;        ///< names that some case has
  std::vector<std::string> known_names_;  ///< of a case, for hints
};

}  // namespace

std::optional<FoundSensitivity> find_sensitivity(const Analysis& analysis,
                                                 const SensitivityChoice& choice,
                                                 Diagnostics& found) {
  return SensitivityJob(analysis, choice, found).run();
}

Outcome sensitivity_files(const std::vector<std::string>& paths,
                          const SensitivityChoice& choice,
                          const AnalyseOptions& options) {
  return report_on_each_file(paths, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    std::optional<Loaded> loaded = load(file.path, options.load, file.source, file.found);
    if (!loaded) {
      return std::nullopt;
    }
    const Analysis analysis = solve_cases(file.path, *std::move(loaded));
    add_findings(analysis, file.found);
    const std::optional<FoundSensitivity> answer = find_sensitivity(analysis, choice, file.found);
    warn_of_cables(analysis, file.found);
    warn_of_curves(analysis, file.found);
    if (!answer) {
      return std::nullopt;
    }
    return make_sensitivity_report(
        file.path, analysis.description, answer->parameters, answer->cases, file.forms, file.found);
  });
}

}  // namespace kinestat
