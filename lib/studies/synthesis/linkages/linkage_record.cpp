#include "studies/synthesis/linkages/linkage_record.hpp"

#include <optional>
#include <string>
#include <vector>

#include "studies/synthesis/positions/plane_record.hpp"

namespace kinestat {

namespace {

const Record<FourBarLengths>& lengths_record() {
  using View = FourBarLengths;
  static const Record<View> record("The links of a four-bar.", [](Record<View>& keys) {
    keys.quantity("ground", QuantityKind::length, "Between the centres.", [](const View& v) {
      return std::optional(v.ground);
    });
    keys.quantity("crank_one", QuantityKind::length, "The first dyad.", [](const View& v) {
      return std::optional(v.crank_one);
    });
    keys.quantity("coupler", QuantityKind::length, "Between the circle points.", [](const View& v) {
      return std::optional(v.coupler);
    });
    keys.quantity("crank_other", QuantityKind::length, "The second dyad.", [](const View& v) {
      return std::optional(v.crank_other);
    });
  });
  return record;
}

const Record<Grashof>& grashof_record() {
  static const Record<Grashof> record("Class of a four-bar.", [](Record<Grashof>& keys) {
    keys.word(
        "class", words_up_to(GrashofClass::change_point), "By Grashof.", [](const Grashof& v) {
          return word_of(v.kind);
        });
    keys.word("link",
              words_up_to(FourBarLink::crank_other),
              "The shortest link; of a triple rocker the longest.",
              [](const Grashof& v) { return word_of(v.which); });
  });
  return record;
}

const Record<FourBarPlaces>& cognate_record() {
  using View = FourBarPlaces;
  static const Record<View> record("A four-bar in the first position.", [](Record<View>& keys) {
    add_points(keys, "fixed", "Centres.", [](const View& v) { return v.fixed; });
    add_points(keys, "moving", "Pivots of the coupler.", [](const View& v) { return v.moving; });
    keys.part("lengths", lengths_record(), "Its links.", [](const View& v) { return v.lengths; });
  });
  return record;
}

// How the linkage moves with one dyad as its input.
struct DriveView {
  const DriveVerdict& verdict;
  const LinkageCandidate& candidate;
};

std::size_t driven_dyad(const LinkageCandidate& candidate, Drive drive) {
  return candidate.dyads[drive == Drive::one ? 0 : 1];
}

// Of a coordinate of the input.
QuantityKind coordinate_kind(const DriveView& v) {
  return input_of(v.candidate.linkage, v.verdict.drive).kind == DyadKind::slider
             ? QuantityKind::length
             : QuantityKind::angle;
}

void write_quantities(const std::vector<double>& values, QuantityKind kind, Archive& to) {
  to.begin_list();
  for (const double value : values) {
    to.quantity(value, kind);
  }
  to.end_list();
}

void write_range(const TransmissionRange& range, Archive& to) {
  write_quantities({range.least, range.most}, QuantityKind::angle, to);
}

Shape range_shape(bool is_nullable) {
  return tuple_shape(number_shape(QuantityKind::angle, true), 2, is_nullable);
}

void add_places(Record<DriveView>& keys) {
  using View = DriveView;
  keys.count("dyad", "The dyad that is driven: index into dyads.", [](const View& v) {
    return driven_dyad(v.candidate, v.verdict.drive);
  });
  keys.custom("coordinates",
              list_shape(number_shape(ByContext::coordinate, true)),
              "Of the input in the positions: the angle of a crank from the line of centres, the "
              "displacement of a slider.",
              [](const View& v, Archive& to) {
                write_quantities(v.verdict.coordinates, coordinate_kind(v), to);
              });
  keys.custom("transmission",
              list_shape(number_shape(QuantityKind::angle, true)),
              "Transmission angle in the positions.",
              [](const View& v, Archive& to) {
                write_quantities(v.verdict.transmission, QuantityKind::angle, to);
              });
  add_counts(keys,
             "circuits",
             "Equal numbers: the same circuit.",
             [](const View& v) -> const std::vector<int>& { return v.verdict.circuits; });
  add_counts(keys,
             "branches",
             "Equal numbers: the same branch.",
             [](const View& v) -> const std::vector<int>& { return v.verdict.branches; });
}

void add_passage(Record<DriveView>& keys) {
  using View = DriveView;
  keys.flag("same_circuit", "Whether one circuit holds all positions.", [](const View& v) {
    return v.verdict.same_circuit;
  });
  keys.flag("same_branch", "Whether no dead point lies between them.", [](const View& v) {
    return v.verdict.same_circuit && v.verdict.same_branch;
  });
  keys.word("passage",
            words_up_to(Passage::decreasing),
            "The direction in which the input passes the positions in their order.",
            [](const View& v) { return word_of(v.verdict.passage); });
  keys.flag("turns_fully", "Whether the input meets no dead point.", [](const View& v) {
    return v.verdict.turns_fully;
  });
  keys.by_context("arc",
                  ByContext::coordinate,
                  "What the input moves from first to last; null where it passes them in no order.",
                  [](const View& v) {
                    const bool passes = v.verdict.passage != Passage::none;
                    return std::pair(passes ? std::optional(v.verdict.arc) : std::nullopt,
                                     coordinate_kind(v));
                  });
}

const Record<DriveView>& drive_record() {
  using View = DriveView;
  static const Record<View> record(
      "How the linkage moves through the positions with one dyad as its input.",
      [](Record<View>& keys) {
        add_places(keys);
        add_passage(keys);
        keys.custom("working_transmission",
                    range_shape(true),
                    "Least and largest transmission angle on that arc.",
                    [](const View& v, Archive& to) {
                      v.verdict.working_arc ? write_range(*v.verdict.working_arc, to) : to.null();
                    });
        keys.custom("full_transmission",
                    range_shape(false),
                    "Least and largest transmission angle over all that the input can reach.",
                    [](const View& v, Archive& to) { write_range(v.verdict.full, to); });
      });
  return record;
}

void write_cognates(const LinkageCandidate& v, Archive& to) {
  if (!v.cognates) {
    to.null();
    return;
  }
  to.begin_list();
  for (const FourBarPlaces& one : v.cognates->linkages) {
    cognate_record().write(one, to);
  }
  to.end_list();
}

Shape cognates_shape() {
  Shape shape = list_shape(object_shape(cognate_record(), false));
  shape.is_nullable = true;
  return shape;
}

void add_standing(Record<LinkageCandidate>& keys) {
  using View = LinkageCandidate;
  keys.word("type",
            words_up_to(LinkageType::double_inverted_slider),
            "Which kinds of dyads.",
            [](const View& v) { return word_of(v.linkage.type()); });
  keys.custom("dyads",
              tuple_shape(whole_shape(false), 2, false),
              "Indices into dyads.",
              [](const View& v, Archive& to) {
                to.begin_list();
                for (const std::size_t dyad : v.dyads) {
                  to.whole(static_cast<std::int64_t>(dyad));
                }
                to.end_list();
              });
  keys.word("defect",
            words_after_none(Defect::size),
            "The worst reason against it; null: usable.",
            [](const View& v) { return word_unless_none(v.defect()); });
  keys.names("defects",
             "All reasons against it, the one above first. Of a linkage that does not pass the "
             "positions, 'transmission_angle' is not judged.",
             [](const View& v, EachName each) {
               for (std::size_t i = 1; i < kDefectCount; ++i) {
                 if (v.defects.has(static_cast<Defect>(i))) {
                   each(word_of(static_cast<Defect>(i)));
                 }
               }
             });
  keys.count("drive",
             "Which of its dyads is the better input: index into dyads.",
             [](const View& v) { return driven_dyad(v, v.best_drive); });
  keys.quantity("margin",
                QuantityKind::angle,
                "Least distance of the transmission angle from the dead points on the working arc.",
                [](const View& v) {
                  return v.best().working_arc ? std::optional(v.margin()) : std::nullopt;
                });
}

}  // namespace

const Record<LinkageCandidate>& linkage_record() {
  using View = LinkageCandidate;
  static const Record<View> record("Two dyads.", [](Record<View>& keys) {
    add_standing(keys);
    keys.quantity("longest", QuantityKind::length, "Longest link.", [](const View& v) {
      return std::optional(v.longest);
    });
    keys.number("link_ratio", Bare::ratio, "Longest over shortest link.", [](const View& v) {
      return std::optional(v.ratio);
    });
    keys.part(
        "lengths", lengths_record(), "Of a four-bar.", [](const View& v) { return v.lengths; });
    keys.part(
        "grashof", grashof_record(), "Of a four-bar.", [](const View& v) { return v.grashof; });
    keys.word("circuit",
              words_up_to(LinkageCircuit::single),
              "In which it is assembled; null without a crank, and where the positions lie in "
              "several.",
              [](const View& v) -> std::optional<std::string_view> {
                return v.circuit ? std::optional(word_of(*v.circuit)) : std::nullopt;
              });
    keys.custom(
        "cognates",
        cognates_shape(),
        "Both four-bars that guide the origin of the moving frame along the same path; null "
        "of a function.",
        write_cognates);
    keys.list("drives",
              drive_record(),
              "By the first and by the second dyad.",
              [](const View& v, const Each<DriveView>& each) {
                for (const DriveVerdict& verdict : v.verdicts) {
                  each({.verdict = verdict, .candidate = v});
                }
              });
  });
  return record;
}

}  // namespace kinestat
