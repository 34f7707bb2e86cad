#include "run/plot.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "draw/catalogue/catalogue.hpp"
#include "draw/gnuplot.hpp"
#include "draw/picture_title.hpp"
#include "files/each_file.hpp"
#include "io/atomic_file.hpp"
#include "mechanism/bind/bind.hpp"
#include "run/analyse.hpp"
#include "run/benchmark.hpp"
#include "run/motion.hpp"
#include "run/picture_suffix.hpp"
#include "run/sweep.hpp"
#include "run/synthesis.hpp"
#include "studies/duty/task/find_duty.hpp"
#include "studies/motion/task/find_motion.hpp"
#include "studies/synthesis/task/find_synthesis.hpp"

namespace kinestat {

namespace {

// For each side of a case.
constexpr double kTimingSeconds = 2.0;

constexpr std::string_view kDotSignature = "// kinestat picture\n";

std::string_view signature_of(PictureForm form) {
  switch (form) {
    case PictureForm::svg:
      return svg_signature();
    case PictureForm::dot:
      return kDotSignature;
    case PictureForm::gnuplot:
      return gnuplot_signature();
  }
  return {};
}

// Everything of a file that pictures are made of, as far as somebody asked for it.
struct PictureSolutions {
  std::optional<Analysis> analysis;
  std::optional<FoundMotion> motion;
  std::optional<MovingMechanism> moving;
  std::optional<SynthesisAnalysis> synthesis;
  std::optional<std::vector<BenchmarkedCase>> benchmark;
  std::optional<SweepTable> sweep;
  std::optional<std::vector<EfficiencyMap>> maps;

  PictureSource source() const {
    return {.analysis = analysis ? &*analysis : nullptr,
            .motion = motion ? &motion->table : nullptr,
            .moving = moving ? &*moving : nullptr,
            .synthesis = synthesis ? &*synthesis : nullptr,
            .benchmark = benchmark ? &*benchmark : nullptr,
            .sweep = sweep ? &*sweep : nullptr,
            .maps = maps ? &*maps : nullptr};
  }
};

class PictureJob {
 public:
  PictureJob(const std::string& path,
             const PlotChoice& choice,
             const AnalyseOptions& options,
             const Clock& clock)
      : path_(path), choice_(choice), options_(options), clock_(clock) {}

  void run(Outcome& outcome) {
    if (!has_place()) {
      add_diagnostics({}, found_, options_.strictness, outcome);
      return;
    }
    source_.path = path_;
    if (std::optional<std::string> text = make_text()) {
      write(*std::move(text), outcome);
    }
    add_diagnostics(source_, found_, options_.strictness, outcome);
  }

 private:
  // Empty iff an error was added.
  std::optional<std::string> make_text() {
    description_ = load_description(path_, options_.load, source_, found_);
    if (!description_) {
      return std::nullopt;
    }
    if (choice_.picture == kListPictures) {
      return list_text();
    }
    const PictureKind* const kind = find_picture_kind(choice_.picture);
    if (kind == nullptr || !find(kind->need)) {
      return std::nullopt;
    }
    PictureSource source = solutions_.source();
    source.name = shown_name(path_, *description_);
    if (!choose_case(source)) {
      return std::nullopt;
    }
    if (const std::string why_not = kind->why_not(source); !why_not.empty()) {
      refuse(why_not);
      return std::nullopt;
    }
    return text_of(*kind, source);
  }

  void refuse(const std::string& why_not) {
    found_.error("E0909",
                 {},
                 fmt::format("there is no picture '{}' of this file: {}", choice_.picture, why_not),
                 fmt::format("'kinestat plot {} FILE' says which pictures it has", kListPictures));
  }

  // Looks for it once. False if it was not found, with an error the first time. What is wrong with
  // one is no reason to leave out another.
  bool find(PictureNeed need) {
    std::optional<bool>& is_found = is_found_[static_cast<std::size_t>(need)];
    if (!is_found) {
      Diagnostics found;
      is_found = solve(need, found);
      add_new(found, found_);
    }
    return *is_found;
  }

  bool solve(PictureNeed need, Diagnostics& found) {
    switch (need) {
      case PictureNeed::analysis:
        return find_analysis(found);
      case PictureNeed::synthesis:
        solutions_.synthesis = find_synthesis(path_, *description_, {}, found);
        return solutions_.synthesis.has_value();
      case PictureNeed::benchmark:
        return find_benchmark(found);
      case PictureNeed::motion:
        return find_motion_of_file(found);
      case PictureNeed::moving:
        return find_moving(found);
      case PictureNeed::sweep:
        return find_sweep(found);
      case PictureNeed::maps:
        return find_maps(found);
    }
    return false;
  }

  std::optional<Mechanism> bind_mechanism(Diagnostics& found) const {
    std::optional<Mechanism> mechanism = bind(*description_, found);
    if (!mechanism && !found.has_errors()) {
      refuse_without_mechanism(*description_, found);
    }
    return mechanism;
  }

  bool find_analysis(Diagnostics& found) {
    std::optional<Mechanism> mechanism = bind_mechanism(found);
    if (!mechanism) {
      return false;
    }
    auto certified = analyse_mechanism(
        path_,
        {.description = *description_, .mechanism = *std::move(mechanism), .shift = std::nullopt},
        options_.accuracy,
        found);
    if (certified) {
      solutions_.analysis = std::move(certified->analysis);
    }
    return certified.has_value();
  }

  bool find_motion_of_file(Diagnostics& found) {
    if (!description_->motion) {
      found.error("E0303",
                  {},
                  "the file has no section 'motion'",
                  "add motion: {drive: …, from: …, to: …}; 'kinestat help motion' says more");
      return false;
    }
    // Also of a drawing that does not close: the motion closes it first.
    const std::optional<Mechanism> mechanism = bind_unassembled(*description_, found);
    if (!mechanism) {
      return false;
    }
    solutions_.motion = find_motion(*description_, *mechanism, found);
    return solutions_.motion.has_value();
  }

  // Of a drawing that does not close a picture would show bodies that hang in no joint.
  bool find_moving(Diagnostics& found) {
    if (!find(PictureNeed::motion)) {
      return false;
    }
    const std::optional<Mechanism> mechanism = bind_mechanism(found);
    if (mechanism) {
      solutions_.moving = moving_mechanism(path_, *description_, *mechanism, *solutions_.motion);
    }
    return mechanism.has_value();
  }

  bool find_sweep(Diagnostics& found) {
    if (!description_->sweep) {
      found.error("E0303",
                  {},
                  "the file has no section 'sweep'",
                  "add sweep: {vary: {…}}; 'kinestat help sweeps' says more");
      return false;
    }
    solutions_.sweep = find_sweep_table(source_, *description_, found);
    return solutions_.sweep.has_value();
  }

  // Of the duty or, without one, of the gears.
  bool find_maps(Diagnostics& found) {
    if (const std::string why_not = why_no_maps(); !why_not.empty()) {
      found.error("E0303",
                  {},
                  why_not,
                  "add duty: {points: [{case: …, input_motion: …, input_action: …, duration: …}]}; "
                  "'kinestat help duty' says more");
      return false;
    }
    if (!find(PictureNeed::analysis)) {
      return false;
    }
    const Analysis& analysis = *solutions_.analysis;
    if (!analysis.description.duty) {
      solutions_.maps = map_cases(analysis.mechanism, gears_of(analysis));
    } else if (const auto duty = find_duty(path_, "", judged_file(analysis), found)) {
      solutions_.maps = map_duty(analysis.mechanism, duty->plan);
    }
    return solutions_.maps.has_value();
  }

  std::string why_no_maps() const {
    if (description_->duty) {
      return "";
    }
    if (!description_->shift) {
      return "the file has no section 'duty' or 'shift'";
    }
    return description_->shift->input_action.empty()
               ? "the file has no section 'duty', and its 'shift' no 'input_action'"
               : "";
  }

  // Their cases stand behind those of the file.
  static std::vector<std::size_t> gears_of(const Analysis& analysis) {
    std::vector<std::size_t> gears;
    const auto count = std::ranges::count(
        analysis.shift->solution.states, ShiftClass::gear, [](const NamedShiftState& one) {
          return one.state.kind;
        });
    const std::size_t end = analysis.mechanism.cases.size();
    for (std::size_t i = end - static_cast<std::size_t>(count); i < end; ++i) {
      gears.push_back(i);
    }
    return gears;
  }

  bool find_benchmark(Diagnostics& found) {
    const std::optional<Mechanism> mechanism = bind_mechanism(found);
    if (!mechanism) {
      return false;
    }
    const BenchmarkChoice choice = {.case_label = choice_.case_label,
                                    .limits = {.seconds = kTimingSeconds}};
    solutions_.benchmark = benchmark_cases(*mechanism, choice, clock_, found);
    return solutions_.benchmark.has_value();
  }

  // False iff an error was added: there is no such case.
  bool choose_case(PictureSource& source) {
    if (choice_.case_label.empty() || source.analysis == nullptr) {
      return true;
    }
    const std::vector<CaseAnalysis>& cases = source.analysis->cases;
    std::vector<std::string> labels;
    for (const CaseAnalysis& one : cases) {
      labels.push_back(one.which.label);
    }
    const auto at = std::ranges::find(labels, choice_.case_label);
    if (at == labels.end()) {
      found_.error("E0101",
                   {},
                   fmt::format("--case: there is no case '{}'", choice_.case_label),
                   labels.empty() ? "the file has no cases; leave --case out"
                                  : fmt::format("its cases are {}", quoted_list(labels)));
      return false;
    }
    source.which = static_cast<std::size_t>(at - labels.begin());
    return true;
  }

  std::string text_of(const PictureKind& kind, const PictureSource& source) const {
    switch (choice_.form) {
      case PictureForm::svg:
        return svg_file(kind.draw(source));
      case PictureForm::dot:
        return std::string(kDotSignature) + kind.dot(source);
      case PictureForm::gnuplot:
        return kind.gnuplot(source);
    }
    return {};
  }

  // What is wrong with the file shows where a picture is asked for; here it is only left out.
  std::string list_text() {
    std::string text;
    for (const PictureKind& kind : picture_kinds()) {
      const std::string why_not = why_not_of(kind);
      text += fmt::format("{}  {:<15} {}\n",
                          why_not.empty() ? "yes" : "no ",
                          kind.name,
                          why_not.empty() ? std::string(kind.sentence) : why_not);
    }
    return text;
  }

  std::string why_not_of(const PictureKind& kind) {
    const bool is_of_synthesis = kind.need == PictureNeed::synthesis;
    if (is_of_synthesis && !description_->synthesis) {
      return "the file has no section 'synthesis'";
    }
    if (!is_of_synthesis && !description_->has_mechanism()) {
      return "the file holds no mechanism";
    }
    const bool is_of_motion = kind.need == PictureNeed::motion || kind.need == PictureNeed::moving;
    if (is_of_motion && !description_->motion) {
      return "the file has no section 'motion'";
    }
    if (kind.need == PictureNeed::sweep && !description_->sweep) {
      return "the file has no section 'sweep'";
    }
    if (kind.need == PictureNeed::maps) {
      if (std::string why_not = why_no_maps(); !why_not.empty()) {
        return why_not;
      }
    }
    const bool is_of_time = kind.need == PictureNeed::benchmark;
    if (is_of_time && description_->cases.empty()) {
      return "the file has no cases";
    }
    // Nothing is timed for a list.
    if (!find(is_of_time ? PictureNeed::analysis : kind.need)) {
      return "the file has errors";
    }
    return is_of_time ? "" : kind.why_not(solutions_.source());
  }

  OutputFile output(std::string content) const {
    return {.path = choice_.path,
            .content = std::move(content),
            .signature = std::string(signature_of(choice_.form))};
  }

  // Before anything is computed. False iff an error was added.
  bool has_place() {
    const OutputFile file = output({});
    return choice_.path.empty() || check_places(std::span(&file, 1), choice_.overwrite, found_);
  }

  void write(std::string text, Outcome& outcome) {
    if (choice_.path.empty() || choice_.picture == kListPictures) {
      outcome.out += text;
      return;
    }
    const OutputFile file = output(std::move(text));
    if (write_files(std::span(&file, 1), choice_.overwrite, found_)) {
      outcome.out += fmt::format("{}: written\n", printable(choice_.path));
    }
  }

  const std::string& path_;
  const PlotChoice& choice_;
  const AnalyseOptions& options_;
  const Clock& clock_;
  SourceFile source_;
  Diagnostics found_;
  std::optional<MechanismDescription> description_;
  PictureSolutions solutions_;
  std::array<std::optional<bool>, 7> is_found_;  ///< by PictureNeed
};

// Forms that a picture has, beside svg.
std::string other_forms(const PictureKind& kind) {
  return kind.dot != nullptr       ? "its other form is dot"
         : kind.gnuplot != nullptr ? "its other form is gnuplot"
                                   : "it has no other form than svg";
}

// Complains about a picture or a form that there is not.
bool check_choice(const PlotChoice& choice, Outcome& outcome) {
  if (choice.picture == kListPictures) {
    return true;
  }
  const PictureKind* const kind = find_picture_kind(choice.picture);
  if (kind == nullptr) {
    const std::vector<std::string> names = picture_names();
    const std::string guess = did_you_mean(choice.picture, names);
    add_message(
        "E0101",
        fmt::format("there is no picture '{}'", printable(choice.picture)),
        guess.empty() ? fmt::format("pictures are {}", plain_list(names, names.size())) : guess,
        outcome);
    return false;
  }
  const bool has_form = choice.form == PictureForm::svg ||
                        (choice.form == PictureForm::dot ? kind->dot : kind->gnuplot) != nullptr;
  if (!has_form) {
    const char* const form = choice.form == PictureForm::dot ? "dot" : "gnuplot";
    add_message("E0101",
                fmt::format("--emit {}: '{}' has no such form", form, choice.picture),
                other_forms(*kind),
                outcome);
  }
  return has_form;
}

}  // namespace

std::vector<std::string> picture_names() {
  std::vector<std::string> names;
  for (const PictureKind& kind : picture_kinds()) {
    names.emplace_back(kind.name);
  }
  return names;
}

std::string picture_help() {
  std::string text;
  for (const PictureKind& kind : picture_kinds()) {
    text += fmt::format("  {:<15} {}\n", kind.name, kind.sentence);
  }
  return text + fmt::format("  {:<15} {}\n", kListPictures, "says which of these the file has");
}

Outcome plot_file(const std::string& path,
                  const PlotChoice& choice,
                  const AnalyseOptions& options,
                  const Clock& clock) {
  Outcome outcome;
  outcome.form = options.diagnostics;
  if (!check_choice(choice, outcome) || !check_picture_suffix(choice.path, outcome)) {
    return outcome;
  }
  const Outcome done =
      for_each_file({path}, options, [&](const std::string& one, Outcome& of_file) {
        PictureJob(one, choice, options, clock).run(of_file);
      });
  return done;
}

}  // namespace kinestat
