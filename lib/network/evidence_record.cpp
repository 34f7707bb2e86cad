#include "network/evidence_record.hpp"

namespace kinestat {

namespace {

// What every view of a rank has.
template <class View, class Read>
void add_rank(Record<View>& keys, const Read& read) {
  keys.text("method",
            "How the rank was found, for example sparse elimination.",
            [read](const View& v) { return read(v).method; });
  keys.count("rank", "Rank of the system that was solved.", [read](const View& v) {
    return read(v).rank;
  });
  keys.number("smallest_pivot",
              Bare::number,
              "Smallest pivot that counted, relative to the largest entry after scaling; without "
              "unit.",
              [read](const View& v) { return read(v).smallest_pivot; })
      .at_least(0);
  keys.number("largest_dropped",
              Bare::number,
              "Largest entry that counted as zero, relative to the largest entry after scaling; "
              "without unit.",
              [read](const View& v) { return read(v).largest_dropped; })
      .at_least(0);
  keys.number("gap",
              Bare::number,
              "Decades between the smallest pivot and the largest entry dropped; null where only "
              "exact zeros were dropped. Without unit.",
              [read](const View& v) { return std::optional(read(v).gap()); });
}

std::optional<double> bound_of(const EvidenceView& v) {
  return v.is_answered ? v.answer.error_bound : std::nullopt;
}

using MaybeWord = std::optional<std::string_view>;

}  // namespace

const Record<RankEvidence>& rank_evidence_record() {
  static const Record<RankEvidence> record(
      "The evidence for the rank of the minimal count.", [](Record<RankEvidence>& keys) {
        add_rank(keys, [](const RankEvidence& rank) -> const RankEvidence& { return rank; });
      });
  return record;
}

const Record<EvidenceView>& evidence_record() {
  static const Record<EvidenceView> record(
      "The evidence for the result.", [](Record<EvidenceView>& keys) {
        add_rank(keys, [](const EvidenceView& v) -> const RankEvidence& { return v.rank; });
        keys.number("residual",
                    Bare::number,
                    "Residual of the equations relative to the terms they sum; null where nothing "
                    "was solved. Without unit.",
                    [](const EvidenceView& v) {
                      return v.is_answered ? std::optional(v.residual) : std::nullopt;
                    })
            .at_least(0);
        keys.word("precision",
                  words_up_to(Precision::exact),
                  "How the answer was found: in doubles, refined with residuals of twice the "
                  "digits, or from the numbers as typed; null without an answer.",
                  [](const EvidenceView& v) {
                    return v.is_answered ? MaybeWord(word_of(v.answer.precision)) : MaybeWord();
                  });
        keys.number("error_bound",
                    Bare::number,
                    "Bound of the relative error of the worst of the determined magnitudes; 1 "
                    "where no digit is certain, null where no bound was requested or is known.",
                    bound_of)
            .at_least(0);
        keys.flag("exact",
                  "Whether fractions were used throughout, so that only the written values are "
                  "rounded.",
                  [](const EvidenceView& v) { return v.answer.is_exact; });
        keys.word("refers_to",
                  {"numbers rounded to double", "numbers as typed"},
                  "The equations to which that error refers: those with numbers rounded to double, "
                  "or those of the file as typed.",
                  [](const EvidenceView& v) {
                    return !bound_of(v)              ? MaybeWord()
                           : v.answer.is_exact_input ? MaybeWord("numbers as typed")
                                                     : MaybeWord("numbers rounded to double");
                  });
      });
  return record;
}

}  // namespace kinestat
