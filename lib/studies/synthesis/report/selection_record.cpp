#include <array>
#include <optional>

#include "studies/synthesis/positions/plane_record.hpp"
#include "studies/synthesis/report/synthesis_record.hpp"

namespace kinestat {

namespace {

// By Missing.
constexpr std::array<const char*, kMissingCount> kMissingTexts = {
    "Their positions contradict themselves.",
    "Fewer than two real dyads that stand alone.",
    "No linkage of the type that 'linkage' requires."};

// By Defect but for none.
constexpr std::array<const char*, kDefectCount - 1> kDefectTexts = {
    "A dyad without any correct digits: the positions do not support it.",
    "Circuit defect.",
    "Branch defect.",
    "Order defect.",
    "Of another class than required.",
    "In another circuit than required.",
    "The input meets a dead point elsewhere.",
    "A centre point outside its area.",
    "A circle point outside its area.",
    "Below the limit on the way through the positions.",
    "Below the limit elsewhere.",
    "Above the limit.",
    "Above the limit."};

const Record<SelectionCounts>& rejected_record() {
  using View = SelectionCounts;
  static const Record<View> record(
      "Why choices are not usable: each counts once, by the defect of its best linkage.",
      [](Record<View>& keys) {
        for (std::size_t i = 0; i < kMissingCount; ++i) {
          keys.count(std::string(word_of(static_cast<Missing>(i))),
                     kMissingTexts[i],
                     [i](const View& v) { return v.missing[i]; });
        }
        for (std::size_t i = 1; i < kDefectCount; ++i) {
          keys.count(std::string(word_of(static_cast<Defect>(i))),
                     kDefectTexts[i - 1],
                     [i](const View& v) { return v.defects[i]; });
        }
      });
  return record;
}

// Only the limits of a file can be taken back.
const Record<SelectionCounts>& one_limit_record() {
  using View = SelectionCounts;
  static const Record<View> record(
      "Those of them that are rejected by this limit alone: without it they would be usable.",
      [](Record<View>& keys) {
        for (std::size_t i = static_cast<std::size_t>(Defect::order) + 1; i < kDefectCount; ++i) {
          keys.count(std::string(limit_of(static_cast<Defect>(i))),
                     kDefectTexts[i - 1],
                     [i](const View& v) { return v.one_limit[i]; });
        }
      });
  return record;
}

const Record<SelectionCounts>& counts_of_selection_record() {
  using View = SelectionCounts;
  static const Record<View> record("What was tried.", [](Record<View>& keys) {
    keys.count("samples",
               "Choices tried: a full grid with the same number of steps for every free number, "
               "the smallest with at least 'samples' of vary choices.",
               [](const View& v) { return v.samples; });
    keys.count(
        "with_linkage", "Those with a linkage.", [](const View& v) { return v.with_linkage; });
    keys.count("usable", "Those with one without defect and within the limits.", [](const View& v) {
      return v.usable;
    });
    keys.part("rejected", rejected_record(), [](const View& v) -> const View& { return v; });
    keys.part("rejected_by_one_limit", one_limit_record(), [](const View& v) -> const View& {
      return v;
    });
  });
  return record;
}

struct AngleView {
  const AngleSelection& selection;
  const SynthesisAnalysis& analysis;
};

const Record<AngleView>& angle_selection_record() {
  using View = AngleView;
  static const Record<View> record("One choice of angles.", [](Record<View>& keys) {
    keys.list("listed_angles",
              listed_angle_record(),
              "Its angles.",
              [](const View& v, const Each<ListedAngle>& each) {
                emit_listed_angles(v.selection.angles, v.analysis, each);
              });
    keys.include(counts_of_selection_record(),
                 [](const View& v) -> const SelectionCounts& { return v.selection.counts; });
    keys.count("first_task",
               "Number of the first task that it produced, if any; the next choice follows.",
               [](const View& v) { return v.selection.first_task; });
  });
  return record;
}

void emit_selections(const SelectionView& v, const Each<AngleView>& each) {
  if (positions_with_lists(*v.analysis.description.synthesis).empty()) {
    return;
  }
  for (const AngleSelection& one : v.analysis.selections) {
    each({.selection = one, .analysis = v.analysis});
  }
}

}  // namespace

const Record<ListedAngle>& listed_angle_record() {
  static const Record<ListedAngle> record(
      "One position with a list.", [](Record<ListedAngle>& keys) {
        keys.count(
            "position", "Its number, from 1.", [](const ListedAngle& v) { return v.place + 1; });
        keys.quantity("angle", QuantityKind::angle, "That of the list.", [](const ListedAngle& v) {
          return v.angle;
        });
      });
  return record;
}

void emit_listed_angles(const std::vector<double>& angles,
                        const SynthesisAnalysis& analysis,
                        const Each<ListedAngle>& each) {
  for (const std::size_t place : positions_with_lists(*analysis.description.synthesis)) {
    each({.place = place, .angle = angles[place]});
  }
}

const Record<SelectionView>& selection_record() {
  using View = SelectionView;
  static const Record<View> record(
      "What the ranges of vary offer; null without vary.", [](Record<View>& keys) {
        keys.include(counts_of_selection_record(),
                     [](const View& v) -> const SelectionCounts& { return *v.analysis.selection; });
        keys.list("by_angles",
                  angle_selection_record(),
                  "The same for each choice of the angles that the file lists; empty where it has "
                  "no lists.",
                  emit_selections);
      });
  return record;
}

const Record<SynthesisChoice>& choice_record() {
  using View = SynthesisChoice;
  static const Record<View> record(
      "What was chosen for the ranges of vary; no key without them.", [](Record<View>& keys) {
        keys.number("m",
                    Bare::ratio,
                    "Ratio of the free point; null if it is not varied.",
                    [](const View& v) { return v.m; });
        add_point(keys,
                  "free_point",
                  QuantityKind::length,
                  "Null if it is not varied.",
                  [](const View& v) { return v.free_point; });
        keys.quantity(
            "s",
            QuantityKind::length,
            "Effective freedom of the curvature, a length; null if it is not varied.",
            [](const View& v) { return v.freedom ? std::optional(v.freedom->s) : std::nullopt; });
        keys.number(
            "tau",
            Bare::number,
            "Of stationary curvature; null if s is not varied.",
            [](const View& v) { return v.freedom ? std::optional(v.freedom->tau) : std::nullopt; });
        keys.number("tau_2",
                    Bare::number,
                    "Of a Burmester point; null if s is not varied.",
                    [](const View& v) {
                      return v.freedom ? std::optional(v.freedom->tau_2) : std::nullopt;
                    });
      });
  return record;
}

}  // namespace kinestat
