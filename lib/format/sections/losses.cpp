// The section `losses`.
#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

const Mapping<LossValue>& loss_mapping() {
  static const Mapping<LossValue> mapping("", "", "{eta: 0.98}", [](auto& m) {
    m.key("loss", "The fraction of the power that is lost, from 0 to below 1.")
        .may(&LossValue::value, fraction(), "0.02")
        .selects(&LossValue::form, LossForm::fraction);
    m.key("eta", "The efficiency: the fraction of the power that remains, above 0 and at most 1.")
        .may(&LossValue::value, efficiency(), "0.98")
        .selects(&LossValue::form, LossForm::efficiency);
    m.key("k",
          "Loss from the numbers of teeth: eta = 1 - k (1/z1 + 1/z2), with a minus for a ring; for "
          "meshes of 'gears'.")
        .may(&LossValue::value, not_negative(), "0.15")
        .selects(&LossValue::form, LossForm::teeth);
    m.rule({.kind = FormRule::Kind::one_of,
            .others = {"loss", "eta", "k"},
            .message = "{} needs one of 'loss', 'eta' and 'k'",
            .hint = "write the share that is lost, 0.02; or {eta: 0.98}; or {k: 0.23} for "
                    "eta = 1 - k (1/z1 + 1/z2)"});
  });
  return mapping;
}

// 0.02, {loss: 0.02}, {eta: 0.98} or {k: 0.23}.
Form<LossValue> loss() {
  const auto share = converted<LossValue>(
      fraction(),
      [](Value value) { return LossValue{.form = LossForm::fraction, .value = std::move(value)}; },
      [](const LossValue& one) { return one.value; });
  Form<LossValue> form =
      by_shape<LossValue>({share, loss_mapping().form()}, [](const LossValue& one) {
        return one.form == LossForm::fraction ? std::size_t{0} : std::size_t{1};
      });
  form.shape.definition = "loss";
  form.shape.meaning =
      "The loss of a mesh: the fraction lost, 0.02, or one of {loss: 0.02}, {eta: 0.98} and {k: "
      "0.15}.";
  form.shape.examples = {"0.02", "{eta: 0.98}"};
  return form;
}

}  // namespace

const Mapping<LossDescription>& losses_section() {
  static const Mapping<LossDescription> mapping(
      "", "", "{gear_external: 0.02, gear_internal: 0.01}", [](auto& m) {
        m.key("model", "How losses are calculated.")
            .may(
                &LossDescription::model,
                choice_of<LossModel>(
                    {{"carrier",
                      "by the rolling power of each mesh, seen from its carrier; the field's "
                      "standard"},
                     {"absolute",
                      "by the power through each coupling (Cazangi 2008, 4.4.4), for comparison"}}),
                "absolute")
            .usual("carrier");
        m.key(
             "gear_external",
             "Loss of every mesh of two external gears; default 0. Any loss may depend on 'speed', "
             "the pitch line speed relative to the carrier, and on 'force', the tooth force along "
             "it.")
            .may(&LossDescription::gear_external, loss(), "0.02")
            .example("0.008 + 0.01*exp(-speed/(4 m/s))");
        m.key("gear_internal", "Loss of every mesh with a ring; default 0.")
            .may(&LossDescription::gear_internal, loss(), "0.01");
        m.key("meshes",
              "Losses of individual meshes or gear couplings, by name; they replace the general "
              "ones.")
            .may(&LossDescription::meshes,
                 values_by_name(&MeshLoss::coupling,
                                &MeshLoss::loss,
                                loss(),
                                {.elements = "meshes to losses", .name_definition = "name"},
                                "the loss of mesh '{0}'"),
                 "{h: 0.015}");
      });
  return mapping;
}

}  // namespace kinestat
