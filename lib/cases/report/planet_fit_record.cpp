#include "cases/report/planet_fit_record.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "report/number_format.hpp"

namespace kinestat {

const Record<PlanetFit>& planet_fit_record() {
  using View = PlanetFit;
  static const Record<View> record("Several equal planets of 'gears'.", [](Record<View>& keys) {
    keys.count("count", "Their number.", [](const View& v) { return v.count; });
    keys.flag("assembles",
              "Whether they can be equally spaced; W0306 says why not.",
              [](const View& v) { return v.assembles; });
    keys.quantity("clearance",
                  QuantityKind::length,
                  "Tip clearance of neighbours, tip to tip, with tips one module outside the pitch "
                  "circles; negative where they overlap (W0307).",
                  [](const View& v) { return std::optional(v.clearance); });
  });
  return record;
}

std::vector<std::string> planet_fit_sentences(const std::vector<PlanetFit>& fits,
                                              const InUnits& in) {
  std::vector<std::string> sentences;
  for (const PlanetFit& one : fits) {
    const bool is_free = one.clearance > 0.0;
    sentences.push_back(fmt::format("{} planets '{}' {} be equally spaced; {} {} {}",
                                    one.count,
                                    printable(one.planet),
                                    one.assembles ? "can" : "cannot",
                                    is_free ? "tip clearance" : "tips of neighbours overlap by",
                                    format_short(std::abs(in.length(one.clearance))),
                                    in.units().text(QuantityKind::length)));
  }
  return sentences;
}

std::string planet_fit_text(const std::vector<PlanetFit>& fits, const InUnits& in) {
  std::string text;
  for (const std::string& one : planet_fit_sentences(fits, in)) {
    text += "  " + one + "\n";
  }
  return text;
}

}  // namespace kinestat
