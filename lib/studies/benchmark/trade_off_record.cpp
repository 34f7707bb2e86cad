#include "studies/benchmark/trade_off_record.hpp"

namespace kinestat {

namespace {

const Record<ExtremeResult>& extreme_record() {
  using View = ExtremeResult;
  static const Record<View> record("A method at one extreme.", [](Record<View>& keys) {
    keys.word("status",
              {"solved", "refused", "not finite"},
              "Whether it has a solution; refused: it finds the equations singular and says so.",
              [](const View& v) { return text_of(v.status); });
    keys.number("error",
                Bare::ratio,
                "Largest error against the exact solution of the same doubles, as a fraction of "
                "the largest unknown.",
                [](const View& v) { return v.error; })
        .at_least(0);
    keys.number("value_error",
                Bare::ratio,
                "Largest error as a fraction of the unknown itself, among those that are not zero.",
                [](const View& v) { return v.value_error; })
        .at_least(0);
    keys.number("bound",
                Bare::ratio,
                "The error bound given by the method itself; null if it gives none.",
                [](const View& v) { return v.bound; })
        .at_least(0);
  });
  return record;
}

std::vector<std::string> extreme_names() {
  std::vector<std::string> names;
  for (const Extreme& extreme : kExtremes) {
    names.emplace_back(extreme.name);
  }
  return names;
}

// Times differ from run to run.
const Record<MethodResult>& method_record() {
  using View = MethodResult;
  static const Record<View> record("A method on one side of a case.", [](Record<View>& keys) {
    keys.number("time",
                Bare::ratio,
                "Median over the rounds, as drawn, in units of double_lu.",
                [](const View& v) { return v.time; })
        .at_least(0)
        .not_compared();
    keys.number("fastest",
                Bare::ratio,
                "The shortest of the rounds.",
                [](const View& v) { return v.fastest; })
        .at_least(0)
        .not_compared();
    keys.number("slowest",
                Bare::ratio,
                "The longest of the rounds.",
                [](const View& v) { return v.slowest; })
        .at_least(0)
        .not_compared();
    keys.number("worst_error",
                Bare::ratio,
                "Largest error of all extremes; null if the method has no answer for one.",
                [](const View& v) { return v.worst_error; })
        .at_least(0);
    keys.flag("pareto",
              "No other method is both faster and more accurate over all extremes.",
              [](const View& v) { return v.is_on_front; })
        .not_compared();
    keys.map("extremes",
             extreme_record(),
             "Its result in each extreme case: the mechanism as it is, all lengths multiplied by "
             "1e-9 or 1e9, the world origin at a distance of 1e3, 1e6 or 1e9 times the size of the "
             "mechanism.",
             [](const View& v, const Each<ExtremeResult>& each) {
               for (std::size_t i = 0; i < v.extremes.size(); ++i) {
                 each(kExtremes[i].name, v.extremes[i], text_of(v.extremes[i].status));
               }
             })
        .named(extreme_names())
        .in_tables_is(TableRole::element);
  });
  return record;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const SolveMethod method : kSolveMethods) {
    names.emplace_back(key_of(method));
  }
  return names;
}

}  // namespace

std::string_view word_of(NoProblem reason) {
  switch (reason) {
    case NoProblem::none:
      return "measured";
    case NoProblem::not_asked:
      return "not_asked";
    case NoProblem::open:
      return "open";
    case NoProblem::dependent:
      return "dependent";
    case NoProblem::too_large:
      return "too_large";
    case NoProblem::no_unknowns:
      return "no_unknowns";
  }
  return "";
}

const Record<TradeOff>& trade_off_record() {
  using View = TradeOff;
  static const Record<View> record("One side of a case.", [](Record<View>& keys) {
    const auto is_measured = [](const View& v) { return v.reason == NoProblem::none; };
    keys.word("status",
              words_up_to(NoProblem::no_unknowns),
              "measured, or why not: nothing is known on this side; what is known leaves "
              "magnitudes undetermined, or contradicts itself; more unknowns than dense methods "
              "are tried with; all are known.",
              [](const View& v) { return word_of(v.reason); });
    keys.count("unknowns", "Secondary magnitudes.", [](const View& v) { return v.unknowns; })
        .at_least(1)
        .only_if(is_measured);
    keys.quantity("unit_seconds",
                  QuantityKind::time,
                  "Median time of double_lu on this machine.",
                  [](const View& v) { return v.unit_seconds; })
        .at_least(0)
        .not_compared()
        .only_if(is_measured);
    keys.map("methods",
             method_record(),
             "Each method: dense elimination with partial pivoting in numbers of 24 bits, in "
             "doubles, which is the unit of time, and in numbers of 64 bits; by the singular "
             "values of the dense matrix; sparse elimination in doubles (--accuracy fast), with a "
             "bound on its error, refined with a residual of twice the digits (--accuracy high), "
             "and in fractions (--accuracy exact).",
             [](const View& v, const Each<MethodResult>& each) {
               for (const MethodResult& method : v.methods) {
                 each(key_of(method.method), method, method.is_on_front ? "pareto" : "dominated");
               }
             })
        .named(method_names())
        .in_tables_as("")
        .only_if(is_measured);
  });
  return record;
}

}  // namespace kinestat
