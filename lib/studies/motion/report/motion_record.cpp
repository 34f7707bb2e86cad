#include "studies/motion/report/motion_record.hpp"

#include <algorithm>
#include <optional>

#include "studies/motion/report/motion_dynamics_record.hpp"
#include "studies/motion/report/motion_time.hpp"

namespace kinestat {

namespace {

const Record<DriveTravel>& drive_record() {
  using View = DriveTravel;
  static const Record<View> record("One drive.", [](Record<View>& keys) {
    keys.text("name", "The actuator.", [](const View& v) { return v.name; });
    keys.text("freedom", "The freedom that it drives, coupling.freedom.", [](const View& v) {
      return v.freedom;
    });
    keys.number("from",
                ByContext::drive,
                "Where the range begins, from the drawn position.",
                [](const View& v) { return v.from; });
    keys.number("to",
                ByContext::drive,
                "Where the range ends, from the drawn position.",
                [](const View& v) { return v.to; });
    keys.number("reached",
                ByContext::drive,
                "The last position of the drive; null if there is none.",
                [](const View& v) { return v.reached; });
    keys.text("unit",
              "Of these positions: the unit of angle or of length.",
              [](const View& v) { return v.unit; })
        .not_compared();
  });
  return record;
}

const Record<MotionColumn>& column_record() {
  using View = MotionColumn;
  static const Record<View> record("One column.", [](Record<View>& keys) {
    keys.text("name", "Element and quantity, as in a.wz/position.", [](const View& v) {
      return v.name();
    });
    keys.text("element",
              "coupling.freedom, coupling.action, actuator, body or traced point; empty for what "
              "concerns the whole.",
              [](const View& v) { return v.element; });
    keys.text("quantity", "position, velocity, linear/x and so on.", [](const View& v) {
      return v.quantity;
    });
    keys.text("unit",
              "That of the file; empty for a bare number and for words.",
              [](const View& v) { return v.unit; })
        .not_compared();
  });
  return record;
}

void emit_columns(const MotionTable& v, const Each<MotionColumn>& each) {
  each({.element = "", .quantity = "step", .unit = ""});
  for (const MotionColumn& column : v.columns) {
    each(column);
  }
  each({.element = "", .quantity = "status", .unit = ""});
}

void write_rows(const MotionTable& v, Archive& to) {
  to.begin_list();
  for (const MotionRow& row : v.rows) {
    to.begin_list();
    to.whole(row.step);
    for (const std::optional<double>& value : row.values) {
      to.number(value, {});
    }
    to.text(row.status);
    to.end_list();
  }
  to.end_list();
}

Shape rows_shape() {
  Shape cell = number_shape(ByContext::column, true);
  cell.form = Shape::Form::cell;
  return list_shape(list_shape(std::move(cell)));
}

struct FiguresView {
  const MotionTable& motion;
  const MotionColumn& column;
  const ColumnFigures& figures;
};

const Record<FiguresView>& figures_record() {
  using View = FiguresView;
  using Extreme = std::optional<ColumnExtreme> ColumnFigures::*;
  static const Record<View> record("One column.", [](Record<View>& keys) {
    const auto value = [](Extreme extreme) {
      return [extreme](const View& v) {
        return v.figures.*extreme ? std::optional((v.figures.*extreme)->value) : std::nullopt;
      };
    };
    const auto place = [](Extreme extreme) {
      return [extreme](const View& v) {
        return v.figures.*extreme ? std::optional((v.figures.*extreme)->drive) : std::nullopt;
      };
    };
    const auto time = [](Extreme extreme) {
      return [extreme](const View& v) {
        return v.figures.*extreme ? time_at_row(v.motion, (v.figures.*extreme)->row) : std::nullopt;
      };
    };
    const auto has_time = [](const View& v) { return time_column(v.motion).has_value(); };
    keys.text("unit",
              "That of the file; empty for a bare number.",
              [](const View& v) { return v.column.unit; })
        .not_compared();
    keys.number("least",
                ByContext::column,
                "The least value, also between the steps; null where no position has one.",
                value(&ColumnFigures::least));
    keys.number("least_at",
                ByContext::drive,
                "Where that is: position of the first drive.",
                place(&ColumnFigures::least))
        .not_compared();
    keys.number("least_time",
                QuantityKind::time,
                "When that is; no key of a motion without time.",
                time(&ColumnFigures::least))
        .not_compared()
        .only_if(has_time);
    keys.number("greatest",
                ByContext::column,
                "The greatest value, likewise.",
                value(&ColumnFigures::greatest));
    keys.number("greatest_at",
                ByContext::drive,
                "Where that is: position of the first drive.",
                place(&ColumnFigures::greatest))
        .not_compared();
    keys.number("greatest_time",
                QuantityKind::time,
                "When that is; no key of a motion without time.",
                time(&ColumnFigures::greatest))
        .not_compared()
        .only_if(has_time);
    keys.number(
        "mean",
        ByContext::column,
        "The mean over the range of the drives, by the trapezoidal rule, or for a motion in time "
        "over time, by polynomials between corners, without the rests in which friction leaves it "
        "open; null where another step has no value or the motion does not reach its end.",
        [](const View& v) { return v.figures.mean; });
    keys.number("rms",
                ByContext::column,
                "The root of the mean square in time, likewise; no key of a motion without time.",
                [](const View& v) { return v.figures.rms; })
        .only_if([](const View& v) { return v.figures.rms.has_value(); });
  });
  return record;
}

// But the drives, whose ranges the file gives, and the closure error.
void emit_figures(const MotionTable& v, const Each<FiguresView>& each) {
  for (std::size_t c = v.drives.size(); c < v.figures.size(); ++c) {
    if (v.columns[c].quantity != kClosureErrorColumn && v.columns[c].quantity != kTimeColumn) {
      each(v.columns[c].name(), {.motion = v, .column = v.columns[c], .figures = v.figures[c]});
    }
  }
}

struct EventView {
  const MotionTable& motion;
  const MotionEvent& event;
};

struct JumpView {
  const MotionColumn& column;
  std::optional<double> before;
  std::optional<double> after;
};

const Record<JumpView>& jump_record() {
  using View = JumpView;
  static const Record<View> record("One column.", [](Record<View>& keys) {
    keys.text("unit",
              "That of the file; empty for a bare number.",
              [](const View& v) { return v.column.unit; })
        .not_compared();
    keys.number("before",
                ByContext::column,
                "As the reversal is approached; null where there is no value, or no way before.",
                [](const View& v) { return v.before; });
    keys.number("after", ByContext::column, "As it is left, likewise.", [](const View& v) {
      return v.after;
    });
  });
  return record;
}

void emit_jumps(const EventView& v, const Each<JumpView>& each) {
  for (std::size_t c = v.motion.drives.size(); c < v.motion.columns.size(); ++c) {
    if (v.event.is_jump_of(c)) {
      each(v.motion.columns[c].name(),
           {.column = v.motion.columns[c],
            .before = v.event.value_before(c),
            .after = v.event.value_after(c)});
    }
  }
}

const Record<EventView>& event_record() {
  using View = EventView;
  static const Record<View> record("One event.", [](Record<View>& keys) {
    keys.word("kind",
              {std::string(kDeadPointEvent),
               std::string(kSingularEvent),
               std::string(kLimitEvent),
               std::string(kLiftOffEvent),
               std::string(kFrictionReversalEvent)},
              "dead_point: a freedom comes to rest and reverses; singular: the drives do not "
              "determine the motion there; limit: a drive can go no further; lift_off: a cable "
              "leaves its pulley, and the motion ends; friction_reversal: a coupling with friction "
              "slides back, and actions jump.",
              [](const View& v) { return v.event.kind; });
    keys.text("element",
              "The freedom, the drive or the coupling concerned; may be empty.",
              [](const View& v) { return v.event.element; });
    keys.count("step",
               "The last step before; -1 on the way from the drawn position to the first.",
               [](const View& v) { return v.event.step; })
        .at_least(-1);
    keys.custom("drive",
                list_shape(number_shape(ByContext::drive, true)),
                "Position of each drive.",
                [](const View& v, Archive& to) {
                  to.begin_list();
                  for (const double position : v.event.drive) {
                    to.number(position, {});
                  }
                  to.end_list();
                });
    keys.number("time",
                QuantityKind::time,
                "When; null on the way from the drawn position, no key of a motion without time.",
                [](const View& v) { return time_at_row(v.motion, v.event.row); })
        .only_if([](const View& v) { return time_column(v.motion).has_value(); });
    keys.number("uncertainty",
                ByContext::drive,
                "Of the position of the first drive: half of the bracket that holds it.",
                [](const View& v) { return v.event.uncertainty; })
        .at_least(0)
        .not_compared();
    keys.map("jumps",
             jump_record(),
             "Of a friction reversal: the columns that jump, and what they come to on either "
             "side. At the reversal itself actions are undetermined.",
             emit_jumps)
        .only_if([](const View& v) { return v.event.kind == kFrictionReversalEvent; });
  });
  return record;
}

const Record<MotionTable>& closure_record() {
  static const Record<MotionTable> record(
      "How well the circuits close in the rows; null without rows.", [](Record<MotionTable>& keys) {
        keys.number("largest",
                    Bare::number,
                    "Largest closure error relative to the size of the mechanism.",
                    [](const MotionTable& v) { return v.worst_closure; })
            .at_least(0);
        keys.count("step", "Where it is.", [](const MotionTable& v) { return v.worst_step; });
      });
  return record;
}

const Record<CouplingGap>& gap_record() {
  static const Record<CouplingGap> record("Of one coupling.", [](Record<CouplingGap>& keys) {
    keys.number("distance",
                QuantityKind::length,
                "Between the point on its tail and that on its head, in directions that the "
                "coupling constrains; unit of length.",
                [](const CouplingGap& v) { return v.distance; })
        .at_least(0);
    keys.number("angle",
                QuantityKind::angle,
                "Between the directions on its tail and on its head; unit of angle.",
                [](const CouplingGap& v) { return v.angle; })
        .at_least(0);
  });
  return record;
}

const Record<BodyCorrection>& correction_record() {
  using View = BodyCorrection;
  static const Record<View> record("Of one body.", [](Record<View>& keys) {
    keys.custom("shift",
                vector_shape(QuantityKind::length, false),
                "Of its reference point; unit of length.",
                [](const View& v, Archive& to) {
                  to.begin_list();
                  for (const double component : v.shift) {
                    to.number(component, {});
                  }
                  to.end_list();
                });
    keys.number(
        "angle", QuantityKind::angle, "By which it was turned; unit of angle.", [](const View& v) {
          return v.angle;
        });
  });
  return record;
}

void emit_gaps(const std::vector<CouplingGap>& gaps, const Each<CouplingGap>& each) {
  for (const CouplingGap& gap : gaps) {
    each(gap.coupling, gap);
  }
}

const Record<MotionTable>& assembly_record() {
  using View = MotionTable;
  static const Record<View> record("How the drawn position was closed.", [](Record<View>& keys) {
    keys.map("drawn_gaps",
             gap_record(),
             "Couplings whose ends do not meet in the reference position.",
             [](const View& v, const Each<CouplingGap>& each) { emit_gaps(v.drawn_gaps, each); });
    keys.map("corrections",
             correction_record(),
             "Bodies that were moved to close the drawn position.",
             [](const View& v, const Each<BodyCorrection>& each) {
               for (const BodyCorrection& one : v.corrections) {
                 each(one.body, one);
               }
             });
    keys.map("nearest_gaps",
             gap_record(),
             "Where nothing closes it: couplings whose ends are apart in the nearest position.",
             [](const View& v, const Each<CouplingGap>& each) { emit_gaps(v.nearest_gaps, each); });
  });
  return record;
}

void add_rows(Record<MotionTable>& keys) {
  keys.list(
      "columns",
      column_record(),
      "What the cells of a row are: the step, the positions of the drives, what was asked "
      "for, the status: solved, limit, singular, that of the actions (indeterminate, "
      "inconsistent, ambiguous, locked, …), or cable_slack, contact_pulls, cable_slips, "
      "freewheel_overruns or freewheel_locks where the numbers hold only for a cable that could "
      "push, surfaces that could pull on each other, a cable held by more friction, or a clutch in "
      "place of a freewheel.",
      emit_columns);
  keys.custom("rows",
              rows_shape(),
              "One a position: one cell a column; null where there is no value.",
              write_rows);
  keys.map("figures",
           figures_record(),
           "Summary of each column: extremes and mean, by its name as in 'columns'.",
           emit_figures);
  keys.flag("extremes_at_steps",
            "Always true: with so many columns extremes are those of the steps and, of positions, "
            "of dead points alone; no key where they are looked for between them.",
            [](const MotionTable& v) { return !v.looks_between_steps; })
      .only_if([](const MotionTable& v) {
        return !v.looks_between_steps && v.columns.size() > v.drives.size();
      });
  keys.list("events",
            event_record(),
            "Events during the motion, in order.",
            [](const MotionTable& v, const Each<EventView>& each) {
              for (const MotionEvent& event : v.events) {
                each({.motion = v, .event = event});
              }
            });
}

bool has_overall_efficiency(const MotionTable& v) {
  return v.overall_efficiency || !v.no_overall_efficiency.empty();
}

}  // namespace

const Record<MotionTable>& motion_record() {
  using View = MotionTable;
  static const Record<View> record(
      "The finite motion of the section 'motion', from the drawn position.",
      [](Record<View>& keys) {
        keys.word("status",
                  words_up_to(MotionEnd::not_assembled),
                  "complete: the drives reached the end of their ranges; limited: one reached a "
                  "limit before; locked: they cannot move at all, or not together; lost: the "
                  "motion could not be followed; not_assembled: the drawn position does not close. "
                  "The rows go as far as the motion.",
                  [](const View& v) { return word_of(v.end); });
        keys.text(
            "case", "The case whose speeds and loads apply; null without one.", [](const View& v) {
              return v.label.empty() ? std::nullopt : std::optional(v.label);
            });
        keys.list("drives",
                  drive_record(),
                  "What is driven, in the order of the file.",
                  [](const View& v, const Each<DriveTravel>& each) {
                    for (const DriveTravel& drive : v.drives) {
                      each(drive);
                    }
                  });
        keys.count("steps",
                   "Number of steps that the file asks for; a whole motion has one position more.",
                   [](const View& v) { return v.steps; });
        add_rows(keys);
        keys.custom("closure",
                    object_shape(closure_record(), true),
                    closure_record().meaning,
                    [](const View& v, Archive& to) {
                      v.rows.empty() ? to.null() : closure_record().write(v, to);
                    })
            .not_compared();
        keys.number("overall_efficiency",
                    Bare::efficiency,
                    "Of a case that names input and output, where its powers are reported: the "
                    "mean power of the outputs over that of the inputs, in time or, of a motion "
                    "without time, for as long as the drive takes at the speeds of the case; null "
                    "where the reason in 'no_overall_efficiency' says why.",
                    [](const View& v) { return v.overall_efficiency; })
            .only_if(has_overall_efficiency);
        keys.text("no_overall_efficiency",
                  "Why there is none, or why it is 0; empty otherwise.",
                  [](const View& v) { return v.no_overall_efficiency; })
            .only_if(has_overall_efficiency);
        keys.part("dynamics",
                  motion_dynamics_record(),
                  [](const View& v) -> const MotionDynamics& { return *v.dynamics; })
            .only_if([](const View& v) { return v.dynamics.has_value(); });
        keys.part("assembly", assembly_record(), [](const View& v) -> const View& { return v; });
      });
  return record;
}

}  // namespace kinestat
