// The section `published`.
#include <cmath>

#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

constexpr const char* kToleranceHint =
    "add for example 'tolerance: 1e-3'; only a whole number needs none";

// A whole number without a tolerance is met exactly: counts are. Of others the source prints some
// digits only.
void check_tolerance(const PublishedValue& one, const FileValue& value) {
  if (std::floor(one.is) != one.is && value.node.find("tolerance") == nullptr) {
    value.found.error(
        "E0303", value.where, "a published value lacks the key 'tolerance'", kToleranceHint);
  }
  if (one.tolerance < 0.0) {
    value.found.error(
        "E0305", value.node.find("tolerance")->where, "a tolerance cannot be negative");
  }
}

Form<Name> json_pointer() {
  Form<Name> form = only_if(
      free_name(),
      [](const YamlNode& node) {
        return node.kind != YamlKind::scalar || node.text.starts_with('/');
      },
      "{} must be a JSON Pointer into the report, which begins with '/'",
      "write for example value: /cases/M1/ratio");
  form.shape.pattern = "^/";
  form.shape.pattern_text = "Write a JSON Pointer into the report, such as /cases/M1/ratio.";
  return form;
}

const Mapping<PublishedValue>& published_value() {
  static const Mapping<PublishedValue> mapping(
      "published_value",
      "A number from the source, which a test compares with the report.",
      "{value: /cases/M1/ratio, is: 2.847, tolerance: 0.0005, where: Tab. 5.15}",
      [](auto& m) {
        m.key("value", "The place of the number in the report: a JSON Pointer.")
            .needed(&PublishedValue::pointer, json_pointer(), "/cases/M1/ratio")
            .add_hint("'value: /cases/…', a JSON Pointer into the report");
        m.key("is", "The correct value, in the report's units.")
            .needed(&PublishedValue::is, plain_number(bare_number()), "2.847")
            .at(&PublishedValue::is_where);
        m.key("tolerance",
              "Largest permitted difference from the report, in the same unit; not negative. A "
              "whole number without it must match exactly.")
            .may(&PublishedValue::tolerance, plain_number(not_negative()), "0.0005");
        m.key("where", "Where the source prints it.")
            .may(&PublishedValue::where, text(), "Tab. 5.15");
        m.key("printed", "What the source prints, if that is not the correct value.")
            .passed_over(plain_number(bare_number()), "0.9605");
        m.key("erratum", "What is wrong in the source.")
            .passed_over(text(), "the printed value rests on a truncated intermediate");
        m.rule({.kind = FormRule::Kind::needed_unless_whole, .key = "tolerance", .others = {"is"}});
        m.check(check_tolerance);
      });
  return mapping;
}

}  // namespace

Form<std::vector<PublishedValue>> published() {
  return list_of(published_value().form(),
                 "a published value",
                 "begin each value with '- {value: /…, is: …, tolerance: …}'",
                 {.least = 0});
}

}  // namespace kinestat
