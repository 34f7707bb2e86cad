#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "core/spelling.hpp"
#include "core/text.hpp"
#include "pages/page_parts.hpp"
#include "report/number_format.hpp"
#include "studies/synthesis/report/linkage_text.hpp"

namespace kinestat {

namespace {

// "an inverted-slider-crank"
std::string with_article(const std::string& noun) {
  constexpr std::string_view kVowels = "aeio";
  return fmt::format("{} {}", kVowels.find(noun.front()) == kVowels.npos ? "a" : "an", noun);
}

// "3 of 6 linkages are usable", "1 of 6 linkages is usable"; of a selection "388 of 4096 choices
// have a usable linkage".
std::string usable_text(const SynthesisAnalysis& synthesis, const SynthesisTask& task) {
  if (synthesis.selection) {
    const SelectionCounts& counts = *synthesis.selection;
    if (counts.usable == 0 && task.linkages.front().is_usable()) {
      return fmt::format("none of {} has a usable linkage, but one between them",
                         counted(counts.samples, "choice", "choices"));
    }
    return fmt::format("{} of {} {} a usable linkage",
                       counts.usable,
                       counted(counts.samples, "choice", "choices"),
                       counts.usable == 1 || counts.samples == 1 ? "has" : "have");
  }
  const auto usable = static_cast<int>(std::ranges::count(
      task.linkages, Defect::none, [](const LinkageCandidate& one) { return one.defect(); }));
  const auto all = static_cast<int>(task.linkages.size());
  return fmt::format("{} of {} {} usable",
                     usable,
                     counted(all, "linkage", "linkages"),
                     usable == 1 || all == 1 ? "is" : "are");
}

void add_best(const SynthesisAnalysis& synthesis,
              const SynthesisTask& task,
              std::vector<std::string>& sentences) {
  const FileUnits& units = synthesis.description.units;
  const LinkageCandidate& best = task.linkages.front();
  const bool is_usable = best.is_usable();
  std::string text = fmt::format("{}; the {} is {}",
                                 usable_text(synthesis, task),
                                 is_usable ? "best" : "nearest",
                                 with_article(hyphenated(word_of(best.linkage.type()))));
  text += best.grashof ? fmt::format(", class {}", hyphenated(word_of(best.grashof->kind))) : "";
  text += best.circuit ? fmt::format(", circuit {}", word_of(*best.circuit)) : "";
  text += is_usable ? fmt::format(", whose transmission angle stays {} {} away from dead points",
                                  format_short(units.from_si(QuantityKind::angle, best.margin())),
                                  units.text(QuantityKind::angle))
                    : fmt::format(", with this against it: {}", phrase_of(best.defects));
  sentences.push_back(text + ".");
}

}  // namespace

std::vector<std::string> synthesis_sentences(const SynthesisAnalysis& synthesis) {
  std::vector<std::string> sentences;
  const auto choices = static_cast<int>(synthesis.tasks.size());
  const std::string what = fmt::format(
      "{} {}", synthesis.limits.function ? "Function generator" : "Synthesis task", synthesis.form);
  sentences.push_back(choices == 1 ? fmt::format("{}.", what)
                                   : fmt::format("{} with {}.", what, counted(choices, "choice")));
  for (const SynthesisTask& task : synthesis.tasks) {
    const bool counts_dyads = !synthesis.limits.function && task.dyads;
    if (counts_dyads && task.dyads->status == BurmesterStatus::solved) {
      const int real = static_cast<int>(task.dyads->dyads.size());
      const int imaginary = task.dyads->imaginary_count;
      sentences.push_back(
          imaginary == 0
              ? fmt::format("{} real.", counted(real, "dyad is", "dyads are"))
              : fmt::format("Of {} dyads {} real.", real + imaginary, counted(real, "is", "are")));
    }
    if (task.dyads && task.dyads->status == BurmesterStatus::family) {
      std::string why = family_text(task.dyads->reason, task.positions);
      why.front() = why.front() == 'a' ? 'A' : 'N';  // "a family ...", "no dyads ..."
      sentences.push_back(fmt::format("{}.", why.substr(0, why.find('\n'))));
    }
    if (!task.linkages.empty()) {
      add_best(synthesis, task, sentences);
    } else if (task.dyads && task.dyads->status != BurmesterStatus::family) {
      sentences.emplace_back("No linkage is found.");
    }
    if (choices > 1) {
      break;
    }
  }
  return sentences;
}

}  // namespace kinestat
