#include "studies/synthesis/report/synthesis_record.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/digit_limits.hpp"
#include "core/utf8.hpp"
#include "report/report_keys.hpp"
#include "studies/synthesis/dyads/dyad_record.hpp"
#include "studies/synthesis/positions/plane_record.hpp"
#include "studies/synthesis/positions/position_record.hpp"

namespace kinestat {

namespace {

struct TaskView {
  const SynthesisAnalysis& analysis;
  const SynthesisTask& task;
  CurveWindow window;  // of its curves
};

// Curves are drawn within some sizes of the task: the spread of its positions and poles, or of the
// pivots of a function.
CurveWindow window_of(const SynthesisTask& task, const SynthesisAnalysis& analysis) {
  constexpr double kSizes = 4.0;
  const int count = analysis.curve_count;
  if (const auto& function = analysis.limits.function) {
    return {.middle = 0.5 * (function->input_pivot + function->output_pivot),
            .radius = kSizes * std::abs(function->output_pivot - function->input_pivot),
            .count = count};
  }
  Point sum(0.0, 0.0);
  for (const PositionJets& position : task.positions) {
    sum += origin(position);
  }
  const Point middle = sum / static_cast<double>(task.positions.size());
  double size = 0.0;
  for (const PositionJets& position : task.positions) {
    size = std::max(size, std::abs(origin(position) - middle));
    if (const auto pole = find_pole(position)) {
      size = std::max(size, std::abs(*pole - middle));
    }
  }
  return {.middle = middle, .radius = size > 0.0 ? kSizes * size : kSizes, .count = count};
}

bool has_dyads(const TaskView& v) {
  return v.task.dyads.has_value();
}

void emit_task_angles(const TaskView& v, const Each<ListedAngle>& each) {
  std::vector<double> angles;
  for (const PositionJets& position : v.task.positions) {
    angles.push_back(position.angle[0]);
  }
  emit_listed_angles(angles, v.analysis, each);
}

struct PrecisionPoint {
  double input = 0.0;   // [rad]
  double output = 0.0;  // [rad]
};

const Record<PrecisionPoint>& precision_point_record() {
  static const Record<PrecisionPoint> record(
      "Angles of input and output, from those in the first position.",
      [](Record<PrecisionPoint>& keys) {
        keys.quantity("input", QuantityKind::angle, "Of the input link.", [](const auto& v) {
          return std::optional(v.input);
        });
        keys.quantity("output", QuantityKind::angle, "Of the output link.", [](const auto& v) {
          return std::optional(v.output);
        });
      });
  return record;
}

void add_function(Record<TaskView>& keys) {
  using View = TaskView;
  keys.list("function",
            precision_point_record(),
            "The precision points of a function, instead of positions.",
            [](const View& v, const Each<PrecisionPoint>& each) {
              const AngleFunction& function = *v.analysis.limits.function;
              for (std::size_t i = 0; i < function.input.size(); ++i) {
                each({.input = function.input[i], .output = function.output[i]});
              }
            })
      .in_tables_is(TableRole::element)
      .only_if([](const View& v) { return v.analysis.limits.function.has_value(); });
}

void add_task(Record<TaskView>& keys) {
  using View = TaskView;
  keys.list("listed_angles",
            listed_angle_record(),
            "Which of the angles that the file lists; empty where it has no lists.",
            emit_task_angles)
      .in_tables_is(TableRole::element);
  keys.part("choice",
            choice_record(),
            [](const View& v) -> const SynthesisChoice& { return *v.task.choice; })
      .in_tables_is(TableRole::element)
      .only_if([](const View& v) { return v.task.choice.has_value(); });
  keys.list("positions",
            position_record(),
            "In the order of the file.",
            [](const View& v, const Each<PositionView>& each) {
              for (const PositionJets& position : v.task.positions) {
                each({.position = position, .units = v.analysis.description.units});
              }
            })
      .in_tables_is(TableRole::element)
      .only_if([](const View& v) { return !v.analysis.limits.function; });
  add_function(keys);
}

// What five positions answer; of others the reason alone may be told.
void add_solution(Record<TaskView>& keys) {
  using View = TaskView;
  keys.word("status",
            words_up_to(BurmesterStatus::no_digits),
            "Of five positions, and of dyads that are given or chosen. family: infinitely many "
            "dyads, see reason; no_digits: the "
            "positions are too close.",
            [](const View& v) { return word_of(v.task.dyads->status); })
      .only_if(has_dyads);
  keys.word("reason",
            words_after_none(Degeneracy::shared_conic),
            "Why the dyads are a family, or there are none; null where they are neither.",
            [](const View& v) {
              return word_unless_none(has_dyads(v) ? v.task.dyads->reason : v.task.special);
            })
      .only_if([](const View& v) { return has_dyads(v) || !v.task.curves; });
  keys.number("digits",
              Bare::number,
              "Decimal digits that the data leave, estimated.",
              [](const View& v) { return v.task.dyads->digits; })
      .not_compared()
      .only_if(has_dyads);
  keys.number("reciprocal_condition",
              Bare::number,
              "Smallest over largest singular value of the conditions.",
              [](const View& v) { return v.task.dyads->reciprocal_condition; })
      .not_compared()
      .only_if(has_dyads);
  keys.count("imaginary_dyads",
             "How many are not real.",
             [](const View& v) { return v.task.dyads->imaginary_count; })
      .only_if(has_dyads);
}

void add_dyads(Record<TaskView>& keys) {
  using View = TaskView;
  keys.list("dyads",
            dyad_record(),
            "The real ones; of a family those that stand alone.",
            [](const View& v, const Each<Dyad>& each) {
              for (const Dyad& dyad : v.task.dyads->dyads) {
                each(dyad);
              }
            })
      .in_tables_is(TableRole::element)
      .only_if(has_dyads);
  keys.part("nearest_dyad",
            dyad_record(),
            "Where no dyad is real: of their real parts the one that misses the positions least.",
            [](const View& v) {
              return v.task.dyads->dyads.empty() ? v.task.dyads->nearest : std::nullopt;
            })
      .in_tables_is(TableRole::element)
      .only_if(has_dyads);
}

const Record<SynthesisTask>& left_out_record() {
  using View = SynthesisTask;
  static const Record<View> record(
      "How many usable linkages there are of kinds that 'linkage' of the file does not ask for, by "
      "kind; it is four_bar unless the file says another, and any asks for all.",
      [](Record<View>& keys) {
        for (int i = 0; i <= static_cast<int>(LinkageType::double_inverted_slider); ++i) {
          const auto type = static_cast<LinkageType>(i);
          const auto find = [type](const View& v) {
            return std::ranges::find(v.left_out, type, &LeftOutLinkages::type);
          };
          keys.count(std::string(word_of(type)),
                     "Those without defect and within the limits.",
                     [find](const View& v) { return find(v)->usable; })
              .only_if([find](const View& v) { return find(v) != v.left_out.end(); });
        }
      });
  return record;
}

void add_linkages(Record<TaskView>& keys) {
  using View = TaskView;
  keys.list("linkages",
            found_linkage_record(),
            "The best first.",
            [](const View& v, const Each<FoundLinkageView>& each) {
              for (std::size_t i = 0; i < v.task.linkages.size(); ++i) {
                each({.analysis = v.analysis, .task = v.task, .window = v.window, .number = i});
              }
            })
      .in_tables_is(TableRole::element)
      .only_if(has_dyads);
  keys.part("left_out",
            left_out_record(),
            [](const View& v) -> const SynthesisTask& { return v.task; })
      .in_tables_is(TableRole::element)
      .only_if(has_dyads);
}

const Record<TaskView>& task_record() {
  using View = TaskView;
  static const Record<View> record(
      "One choice of the angles that the file lists.", [](Record<View>& keys) {
        add_task(keys);
        add_solution(keys);
        add_dyads(keys);
        add_linkages(keys);
        keys.part("curves",
                  curves_record(),
                  "Of four positions; of a function circle_points are those of the input, and "
                  "centre_points the circle points of the output.",
                  [](const View& v) {
                    return CurvesView{.curves = *v.task.curves,
                                      .positions = v.task.positions,
                                      .window = v.window,
                                      .units = v.analysis.description.units};
                  })
            .in_tables_is(TableRole::element)
            .only_if([](const View& v) { return v.task.curves.has_value(); });
        keys.part("straight_paths",
                  circle_record(),
                  "Of three positions: the points that move on straight lines.",
                  [](const View& v) { return *v.task.straight_paths; })
            .in_tables_is(TableRole::element)
            .only_if([](const View& v) { return v.task.straight_paths.has_value(); });
      });
  return record;
}

std::string_view status_in_tables(const SynthesisTask& task) {
  const BurmesterStatus of_curves = task.curves ? task.curves->status : BurmesterStatus::solved;
  return word_of(task.dyads ? task.dyads->status : of_curves);
}

// Tables call a task by its number.
void emit_tasks(const SynthesisAnalysis& v, const Each<TaskView>& each) {
  for (std::size_t i = 0; i < v.tasks.size(); ++i) {
    const SynthesisTask& task = v.tasks[i];
    each(std::to_string(i),
         {.analysis = v, .task = task, .window = window_of(task, v)},
         status_in_tables(task));
  }
}

const Record<SynthesisAnalysis>& synthesis_record() {
  using View = SynthesisAnalysis;
  static const Record<View> record("The task.", [](Record<View>& keys) {
    keys.text("form", "For example PP-PP-P.", [](const View& v) { return v.form; });
    keys.count("working_digits",
               "Decimal digits used for the positions: 16, or the number requested.",
               [](const View& v) { return v.digits.value_or(kDoubleDigits); });
    keys.part("selection",
              selection_record(),
              [](const View& v) {
                return v.selection ? std::optional(SelectionView{.analysis = v}) : std::nullopt;
              })
        .in_tables_is(TableRole::element);
    keys.list("tasks",
              task_record(),
              "Several if the file lists angles; with vary the best choices.",
              emit_tasks)
        .in_tables_is(TableRole::cases);
  });
  return record;
}

}  // namespace

const Record<SynthesisReportView>& synthesis_report_record() {
  using View = SynthesisReportView;
  static const Record<View> record(
      "What 'kinestat synthesize --format json' writes: linkages that guide a plane through "
      "positions. Lengths and angles are in the units of the file.",
      [](Record<View>& keys) {
        const auto head_of = [](const View& v) {
          return HeadView{.file = v.analysis.file, .description = v.analysis.description};
        };
        keys.part("kinestat", program_record(), head_of).not_in_tables().not_compared();
        keys.part("mechanism", mechanism_record(), head_of).not_in_tables();
        keys.part("synthesis",
                  synthesis_record(),
                  [](const View& v) -> const SynthesisAnalysis& { return v.analysis; })
            .in_tables_is(TableRole::table);
        keys.custom("diagnostics",
                    diagnostics_shape(),
                    "Errors and warnings, in the order in which they were found.",
                    [](const View& v, Archive& to) { write_diagnostics(v.found, to); })
            .not_in_tables()
            .not_compared();
      });
  return record;
}

}  // namespace kinestat
