#include "studies/synthesis/dyads/dyad_record.hpp"

#include <optional>

#include "studies/synthesis/positions/plane_record.hpp"

namespace kinestat {

namespace {

void add_shape(Record<Dyad>& keys) {
  keys.word("type",
            words_up_to(DyadKind::inverted_slider),
            "A slider has its centre, an inverted slider its circle point at infinity.",
            [](const Dyad& v) { return word_of(v.kind); });
  add_point(keys,
            "circle_point",
            QuantityKind::length,
            "Moving frame; of an inverted slider the foot of the perpendicular from the origin on "
            "its line.",
            [](const Dyad& v) { return v.circle_point; });
  add_point(keys,
            "centre_point",
            QuantityKind::length,
            "Fixed frame; of a slider its circle point in the first position.",
            [](const Dyad& v) { return v.centre_point; });
  add_point(keys,
            "direction",
            Bare::direction,
            "Unit vector: of a slider its path, fixed frame; of an inverted slider its line, "
            "moving frame.",
            [](const Dyad& v) {
              return v.kind == DyadKind::crank ? std::nullopt : std::optional(v.direction);
            });
  keys.quantity("length", QuantityKind::length, "Of a crank.", [](const Dyad& v) {
    return v.kind == DyadKind::crank ? std::optional(v.length) : std::nullopt;
  });
}

void add_certainty(Record<Dyad>& keys) {
  const auto is_long_crank = [](const Dyad& v) { return v.crank_length > 0.0; };
  keys.count(
      "multiplicity", "2: two dyads that coincide.", [](const Dyad& v) { return v.multiplicity; });
  keys.number("digits",
              Bare::number,
              "Decimal digits that the data leave, estimated.",
              [](const Dyad& v) { return v.digits; })
      .not_compared();
  keys.number("residual",
              Bare::number,
              "The largest violation of its conditions, as a fraction of their terms.",
              [](const Dyad& v) { return v.residual; })
      .not_compared();
  keys.quantity("crank_length",
                QuantityKind::length,
                "Of a slider or inverted slider that the decimals of the positions cannot tell "
                "from a very long crank: its length.",
                [](const Dyad& v) { return v.crank_length; })
      .only_if(is_long_crank);
  keys.quantity("deviation",
                QuantityKind::length,
                "Of such a slider: by how much the positions miss it.",
                [](const Dyad& v) { return v.deviation; })
      .only_if(is_long_crank);
}

}  // namespace

const Record<Dyad>& dyad_record() {
  static const Record<Dyad> record("A link that keeps a point of the moving plane on a circle.",
                                   [](Record<Dyad>& keys) {
                                     add_shape(keys);
                                     add_certainty(keys);
                                   });
  return record;
}

}  // namespace kinestat
