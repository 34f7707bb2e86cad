#include "studies/sensitivity/report/sensitivity_record.hpp"

#include "report/report_keys.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

namespace {

struct DerivativeView {
  const SensitivityValue& value;
  const SensitivityParameter& parameter;
  std::optional<double> derivative;  // in the units of both
};

struct SensitiveValueView {
  const SensitivityValue& value;
  const std::vector<SensitivityParameter>& parameters;
};

struct SensitiveCaseView {
  const CaseSensitivity& one;
  const std::vector<SensitivityParameter>& parameters;
};

const Record<DerivativeView>& derivative_record() {
  using View = DerivativeView;
  static const Record<View> record(
      "The effect of one parameter, with the others unchanged.", [](Record<View>& keys) {
        keys.converted("derivative",
                       ByContext::beside,
                       "d value / d parameter; null where there is none: at a corner of a formula, "
                       "or where redundant couplings would no longer fit or begin to bind.",
                       [](const View& v) {
                         return std::pair(v.derivative, derivative_unit(v.value, v.parameter));
                       });
        keys.text("unit",
                  "Unit of the value per unit of the parameter.",
                  [](const View& v) { return derivative_unit(v.value, v.parameter); })
            .not_compared();
        keys.number(
            "relative",
            Bare::ratio,
            "Percent of the value per percent of the parameter; null where one of them is "
            "zero or there is no derivative.",
            [](const View& v) { return relative_sensitivity(v.value, v.parameter, v.derivative); });
      });
  return record;
}

void emit_derivatives(const SensitiveValueView& v, const Each<DerivativeView>& each) {
  for (std::size_t p = 0; p < v.parameters.size(); ++p) {
    const std::optional<double> derivative = v.value.derivatives[p];
    each(v.parameters[p].name,
         {.value = v.value, .parameter = v.parameters[p], .derivative = derivative},
         derivative ? "" : "no derivative");
  }
}

bool is_completed(const SensitivityValue& value) {
  return value.completed_by != IndeterminateChoice::report;
}

const Record<SensitiveValueView>& sensitive_value_record() {
  using View = SensitiveValueView;
  static const Record<View> record("One value of the report.", [](Record<View>& keys) {
    keys.number("value",
                ByContext::beside,
                "The value itself.",
                [](const View& v) { return v.value.value; })
        .not_in_tables();
    keys.text("unit",
              "Unit of the value; empty if it is a plain number.",
              [](const View& v) { return v.value.unit; })
        .not_compared();
    keys.word("completion",
              {std::string(word_of(IndeterminateChoice::minimum_norm)),
               std::string(word_of(IndeterminateChoice::stiffness))},
              "What completes the actions of which the value is made; only where equilibrium "
              "leaves these open.",
              [](const View& v) { return word_of(v.value.completed_by); })
        .only_if([](const View& v) { return is_completed(v.value); });
    keys.map("by",
             derivative_record(),
             "Derivatives by the name of the parameter.",
             emit_derivatives)
        .in_tables_is(TableRole::element);
  });
  return record;
}

// Values of actions that equilibrium leaves open have the method as their status.
void emit_values(const SensitiveCaseView& v, const Each<SensitiveValueView>& each) {
  for (const SensitivityValue& value : v.one.values) {
    each(value.name,
         {.value = value, .parameters = v.parameters},
         is_completed(value) ? word_of(value.completed_by) : std::string_view());
  }
}

const Record<SensitiveCaseView>& sensitive_case_record() {
  using View = SensitiveCaseView;
  static const Record<View> record("One case of the file.", [](Record<View>& keys) {
    keys.map("sensitivity",
             sensitive_value_record(),
             "Values by the name under which they were requested.",
             emit_values)
        .in_tables_is(TableRole::table);
  });
  return record;
}

}  // namespace

const Record<SensitivityReportView>& sensitivity_report_record() {
  using View = SensitivityReportView;
  static const Record<View> record(
      "What 'kinestat sensitivity --format json' writes: how values of the report depend on "
      "parameters of the file.",
      [](Record<View>& keys) {
        add_head(keys);
        keys.map("cases",
                 sensitive_case_record(),
                 "Cases by label.",
                 [](const View& v, const Each<SensitiveCaseView>& each) {
                   for (const CaseSensitivity& one : v.cases) {
                     each(one.label, {.one = one, .parameters = v.parameters});
                   }
                 })
            .in_tables_is(TableRole::cases);
        add_diagnostics(keys);
      });
  return record;
}

}  // namespace kinestat
