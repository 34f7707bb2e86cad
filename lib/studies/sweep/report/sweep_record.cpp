#include "studies/sweep/report/sweep_record.hpp"

#include "studies/sweep/report/sweep_status.hpp"

namespace kinestat {

namespace {

constexpr int kSummaryVersion = 1;

const Record<SweepMetadata>& sweeping_program_record() {
  using View = SweepMetadata;
  static const Record<View> record("The program that swept.", [](Record<View>& keys) {
    keys.count("sweep", "Version of this format.", [](const View&) { return kSummaryVersion; });
    keys.text("version", "Version of the program.", [](const View& v) { return v.version; });
  });
  return record;
}

struct RequirementView {
  const std::string& condition;
  std::uint64_t excluded = 0;
};

const Record<RequirementView>& requirement_record() {
  using View = RequirementView;
  static const Record<View> record("One requirement.", [](Record<View>& keys) {
    keys.text("condition", "As the file has it.", [](const View& v) { return v.condition; });
    keys.count("excluded",
               "States for which it is the first requirement violated.",
               [](const View& v) { return v.excluded; });
  });
  return record;
}

const Record<SweepMetadata>& words_record() {
  using View = SweepMetadata;
  static const Record<View> record(
      "What the numbers in two fields of an array stand for: 0 is the first word.",
      [](Record<View>& keys) {
        keys.names("case",
                   "The cases of the sweep.",
                   [](const View& v, const EachName& each) {
                     for (const std::string& label : v.cases) {
                       each(label);
                     }
                   })
            .ordered();
        keys.names("status",
                   "All possible statuses, including those that no row has.",
                   [](const View&, const EachName& each) {
                     for (const std::string_view word : sweep_statuses()) {
                       each(word);
                     }
                   })
            .ordered();
      });
  return record;
}

void emit_requirements(const SweepSummaryView& v, const Each<RequirementView>& each) {
  const std::vector<std::uint64_t>& excluded = v.counts.excluded;
  for (std::size_t i = 0; i < v.metadata.requirements.size(); ++i) {
    each({.condition = v.metadata.requirements[i],
          .excluded = i < excluded.size() ? excluded[i] : 0});
  }
}

struct KeptView {
  const std::string& condition;
  std::uint64_t dropped = 0;
};

const Record<KeptView>& kept_record() {
  using View = KeptView;
  static const Record<View> record("One condition of rows.", [](Record<View>& keys) {
    keys.text("condition", "As the file has it.", [](const View& v) { return v.condition; });
    keys.count("dropped",
               "Rows for which it is the first condition that fails, or cannot be judged.",
               [](const View& v) { return v.dropped; });
  });
  return record;
}

void emit_kept(const SweepSummaryView& v, const Each<KeptView>& each) {
  const std::vector<std::uint64_t>& dropped = v.counts.dropped;
  for (std::size_t i = 0; i < v.metadata.keep.size(); ++i) {
    each({.condition = v.metadata.keep[i], .dropped = i < dropped.size() ? dropped[i] : 0});
  }
}

void write_statuses(const SweepSummaryView& v, Archive& to) {
  to.begin_map();
  for (const auto& [status, count] : v.counts.statuses) {
    to.element(status, {});
    to.whole(static_cast<std::int64_t>(count));
  }
  to.end_map();
}

void add_plan(Record<SweepSummaryView>& keys) {
  using View = SweepSummaryView;
  keys.part("kinestat", sweeping_program_record(), [](const View& v) -> const SweepMetadata& {
    return v.metadata;
  });
  keys.text("name", "Name of the mechanism; empty if the file gives none.", [](const View& v) {
    return v.metadata.name;
  });
  keys.text("plan",
            "Hash of everything that determines the bytes of the rows: version, file, options.",
            [](const View& v) { return v.metadata.plan; });
  keys.names(
          "columns",
          "Titles of the columns, which are the keys of JSON rows and the fields of arrays: varied "
          "parameters, case, quantities, status.",
          [](const View& v, const EachName& each) {
            for (const std::string& title : v.metadata.titles) {
              each(title);
            }
          })
      .ordered();
  keys.part(
          "words", words_record(), [](const View& v) -> const SweepMetadata& { return v.metadata; })
      .only_if([](const View& v) { return v.metadata.format == RowFormat::npy; });
}

void add_counts_of_sweep(Record<SweepSummaryView>& keys) {
  using View = SweepSummaryView;
  keys.count(
      "states",
      "Combinations of the varied values, or samples, including those that a requirement excludes.",
      [](const View& v) { return v.counts.states; });
  keys.list("require",
            requirement_record(),
            "The requirements in the order of the file.",
            emit_requirements);
  keys.count("analysed", "States that no requirement excludes.", [](const View& v) {
    return v.counts.analysed();
  });
  keys.count(
      "rows",
      "Rows of all analysed states, one a case; with 'keep' and --top more than are written.",
      [](const View& v) { return v.counts.rows; });
  keys.list("keep", kept_record(), "The conditions of rows in the order of the file.", emit_kept);
  keys.count("unranked",
             "Of the rows that meet all conditions, those that --top or --pareto leaves out "
             "because the ranking quantity has no value.",
             [](const View& v) { return v.counts.unranked; });
  keys.custom("statuses",
              map_shape(whole_shape(false)),
              "How many rows have which status: solved, or why the row has no answer or one that "
              "cannot be (cable_slack, contact_pulls, cable_slips, freewheel_overruns, "
              "freewheel_locks), as 'kinestat help sweeps' lists them.",
              write_statuses);
}

template <class View, class Get>
void add_criterion(Record<View>& keys, Get get) {
  keys.text("by", "The quantity, or the formula, that decides.", [get](const View& v) {
    return get(v).by;
  });
  keys.word("order",
            {std::string(word_of(RankOrder::largest)), std::string(word_of(RankOrder::smallest))},
            "Which values come first.",
            [get](const View& v) { return word_of(get(v).order); });
}

const Record<BestChoice>& top_record() {
  using View = BestChoice;
  static const Record<View> record(
      "The best rows by one criterion; null where all or a Pareto front were written.",
      [](Record<View>& keys) {
        keys.count("count", "How many at most.", [](const View& v) { return v.count; }).at_least(1);
        add_criterion(keys, [](const View& v) -> const Criterion& { return v.criteria.front(); });
      });
  return record;
}

}  // namespace

const Record<Criterion>& criterion_record() {
  using View = Criterion;
  static const Record<View> record(
      "The criterion by which rows were "
      "compared.",
      [](Record<View>& keys) {
        add_criterion(keys, [](const View& v) -> const Criterion& { return v; });
      });
  return record;
}

const Record<SampleChoice>& sample_record() {
  using View = SampleChoice;
  static const Record<View> record(
      "The sampling method; null where all combinations are taken.", [](Record<View>& keys) {
        keys.count("count", "How many.", [](const View& v) { return v.count; }).at_least(1);
        keys.word("method",
                  {kSampleMethods.begin(), kSampleMethods.end()},
                  "By which method.",
                  [](const View& v) { return kSampleMethods[static_cast<std::size_t>(v.method)]; });
        keys.count("seed", "The seed of the sample.", [](const View& v) { return v.seed; });
      });
  return record;
}

const Record<SweepSummaryView>& sweep_summary_record() {
  using View = SweepSummaryView;
  static const Record<View> record(
      "What 'kinestat sweep --out' and 'kinestat merge' write beside the rows, as "
      "STEM.sweep.json.",
      [](Record<View>& keys) {
        add_plan(keys);
        add_counts_of_sweep(keys);
        keys.part("top", top_record(), [](const View& v) {
          const std::optional<BestChoice>& best = v.metadata.best;
          return best && !best->is_front() ? best : std::nullopt;
        });
        keys.list(
            "pareto",
            criterion_record(),
            "The criteria of the Pareto front that was kept; none where it was not asked for.",
            [](const View& v, const Each<Criterion>& each) {
              const std::optional<BestChoice>& best = v.metadata.best;
              for (const Criterion& one :
                   best && best->is_front() ? best->criteria : std::vector<Criterion>()) {
                each(one);
              }
            });
        keys.part("sample", sample_record(), [](const View& v) { return v.metadata.sample; });
      });
  return record;
}

}  // namespace kinestat
