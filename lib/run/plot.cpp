#include "run/plot.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "cases/chosen_case.hpp"
#include "core/page_text.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "draw/catalogue/catalogue.hpp"
#include "draw/gnuplot.hpp"
#include "draw/picture_title.hpp"
#include "files/each_file.hpp"
#include "io/atomic_file.hpp"
#include "run/picture_finder.hpp"
#include "run/picture_suffix.hpp"
#include "studies/motion/picture/motion_abscissa.hpp"

namespace kinestat {

namespace {

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

class PictureJob {
 public:
  PictureJob(const std::string& path,
             const PlotChoice& choice,
             const AnalyseOptions& options,
             const Clock& clock)
      : path_(path), choice_(choice), options_(options), finder_(path, choice, options, clock) {}

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
    if (!finder_.load(source_, found_)) {
      return std::nullopt;
    }
    if (choice_.picture == kListPictures) {
      return list_text();
    }
    const PictureKind* const kind = find_picture_kind(choice_.picture);
    if (kind == nullptr ||
        !finder_.find(choice_.at.empty() ? kind->need : PictureNeed::placed, found_)) {
      return std::nullopt;
    }
    PictureSource source = finder_.source();
    source.name = shown_name(path_, description());
    if (!choose_case(source) || !choose_abscissa(source)) {
      return std::nullopt;
    }
    if (const std::string why_not = kind->why_not(source); !why_not.empty()) {
      refuse(why_not);
      return std::nullopt;
    }
    return text_of(*kind, source);
  }

  const MechanismDescription& description() const { return finder_.description(); }

  void refuse(const std::string& why_not) {
    found_.error("E0909",
                 {},
                 fmt::format("there is no picture '{}' of this file: {}", choice_.picture, why_not),
                 fmt::format("'kinestat plot {} FILE' says which pictures it has", kListPictures));
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
      refuse_case(choice_.case_label, labels, found_);
      return false;
    }
    source.which = static_cast<std::size_t>(at - labels.begin());
    return true;
  }

  // False iff an error was added: the motion has no such column.
  bool choose_abscissa(PictureSource& source) {
    if (choice_.over.empty() || source.motion == nullptr) {
      return true;
    }
    source.over = find_abscissa(*source.motion, choice_.over);
    if (source.over) {
      return true;
    }
    std::vector<std::string> names;
    for (const MotionColumn& column : source.motion->columns) {
      names.push_back(column.name());
    }
    found_.error("E0101",
                 {},
                 fmt::format("--over: the motion has no column '{}'", printable(choice_.over)),
                 guess_before(choice_.over,
                              names,
                              "its columns are " + plain_list(names) +
                                  "; --report adds others, as does 'report' in the file"));
    return false;
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
    const bool is_of_transmissions = kind.need == PictureNeed::transmissions;
    const bool is_of_synthesis = is_of_transmissions || kind.need == PictureNeed::synthesis;
    if (is_of_synthesis && !description().synthesis) {
      return "the file has no section 'synthesis'";
    }
    if (is_of_synthesis && !is_of_transmissions && description().synthesis->transmission) {
      return "the task is one of transmissions";
    }
    if (is_of_transmissions && !description().synthesis->transmission) {
      return "the task is one of linkages";
    }
    if (!is_of_synthesis && !description().has_mechanism()) {
      return "the file holds no mechanism";
    }
    if (is_of_motion(kind.need) && !description().motion) {
      return "the file has no section 'motion'";
    }
    if (kind.need == PictureNeed::simulation && !description().simulation) {
      return "the file has no section 'simulation'";
    }
    if (kind.need == PictureNeed::sweep && !description().sweep) {
      return "the file has no section 'sweep'";
    }
    if (kind.need == PictureNeed::maps) {
      if (std::string why_not = finder_.why_no_maps(); !why_not.empty()) {
        return why_not;
      }
    }
    const bool is_of_time = kind.need == PictureNeed::benchmark;
    if (is_of_time && description().cases.empty()) {
      return "the file has no cases";
    }
    // Nothing is timed for a list.
    if (!finder_.find(is_of_time ? PictureNeed::analysis : kind.need, found_)) {
      return "the file has errors";
    }
    return is_of_time ? "" : kind.why_not(finder_.source());
  }

  OutputFile output(std::string content) const {
    return {.path = choice_.path,
            .content = std::move(content),
            .signature = std::string(signature_of(choice_.form))};
  }

  std::vector<std::string> inputs() const { return input_paths({path_}, options_.load); }

  // Before anything is computed. False iff an error was added.
  bool has_place() {
    const OutputFile file = output({});
    return choice_.path.empty() ||
           check_places(std::span(&file, 1), choice_.overwrite, inputs(), found_);
  }

  void write(std::string text, Outcome& outcome) {
    if (choice_.picture == kListPictures) {
      constexpr std::size_t kSentence = 21;
      outcome.report.add_list(text, kSentence);
      return;
    }
    if (choice_.path.empty()) {
      outcome.out += text;
      return;
    }
    const OutputFile file = output(std::move(text));
    if (write_files(std::span(&file, 1), choice_.overwrite, inputs(), found_)) {
      outcome.out += fmt::format("{}: written\n", printable(choice_.path));
    }
  }

  const std::string& path_;
  const PlotChoice& choice_;
  const AnalyseOptions& options_;
  SourceFile source_;
  Diagnostics found_;
  PictureFinder finder_;
};

// Forms that a picture has, beside svg.
std::string other_forms(const PictureKind& kind) {
  return kind.dot != nullptr       ? "its other form is dot"
         : kind.gnuplot != nullptr ? "its other form is gnuplot"
                                   : "it has no other form than svg";
}

// "'motion-curves' and 'paths'": the pictures of which that holds.
template <class Holds>
std::string pictures_with(const Holds& holds) {
  std::vector<std::string> names;
  for (const PictureKind& kind : picture_kinds()) {
    if (holds(kind)) {
      names.emplace_back(kind.name);
    }
  }
  return quoted_list(names);
}

// Complains about options that the picture has no use for.
bool check_options(const PlotChoice& choice, const PictureKind& kind, Outcome& outcome) {
  const auto refuse = [&](std::string_view option, const auto& holds) {
    add_message("E0101",
                fmt::format("{}: picture '{}' has no use for it", option, choice.picture),
                fmt::format("it is for {}", pictures_with(holds)),
                outcome);
    return false;
  };
  const auto takes_positions = [](const PictureKind& one) { return one.takes_positions; };
  const auto takes_abscissa = [](const PictureKind& one) { return one.takes_abscissa; };
  const auto has_columns = [](const PictureKind& one) { return one.need == PictureNeed::motion; };
  const auto has_cases = [](const PictureKind& one) { return is_of_cases(one.need); };
  if (!choice.at.empty() && !takes_positions(kind)) {
    return refuse("--at", takes_positions);
  }
  if (!choice.over.empty() && !takes_abscissa(kind)) {
    return refuse("--over", takes_abscissa);
  }
  if (!choice.report.empty() && !has_columns(kind)) {
    return refuse("--report", has_columns);
  }
  if (!choice.case_label.empty() && !has_cases(kind)) {
    return refuse("--case", has_cases);
  }
  if (choice.drive && choice.at.empty()) {
    add_message("E0101",
                "--drive is given without --at",
                "give its position: --drive NAME --at '30 deg'",
                outcome);
    return false;
  }
  return true;
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
  return has_form && check_options(choice, *kind, outcome);
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
  const auto name_and_sentence = [](std::string_view name, std::string_view sentence) {
    constexpr std::size_t kSentence = 18;
    return page_lines(fmt::format("  {:<15} ", name), sentence, kSentence);
  };
  for (const PictureKind& kind : picture_kinds()) {
    text += name_and_sentence(kind.name, kind.sentence);
  }
  return text + name_and_sentence(kListPictures, "says which of these the file has");
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
