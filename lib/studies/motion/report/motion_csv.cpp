#include "studies/motion/report/motion_csv.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "report/csv.hpp"
#include "report/number_format.hpp"
#include "report/table_archive.hpp"
#include "report/tables/component_name.hpp"
#include "studies/motion/report/motion_dynamics_record.hpp"

namespace kinestat {

namespace {

std::string cell(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? format_exact(*value) : "";
}

// Of its case.
const Record<MotionTable>& dynamics_tables() {
  static const Record<MotionTable> record(
      "What a motion tells as a whole.", [](Record<MotionTable>& keys) {
        keys.map("dynamics",
                 motion_dynamics_record(),
                 motion_dynamics_record().meaning,
                 [](const MotionTable& v, const Each<MotionDynamics>& each) {
                   each(v.label, *v.dynamics);
                 })
            .in_tables_is(TableRole::table_of_cases);
      });
  return record;
}

class MotionCsv {
 public:
  MotionCsv(const std::string& mechanism, const MotionTable& motion)
      : mechanism_(mechanism), motion_(motion) {}

  std::string run() {
    for (const MotionRow& row : motion_.rows) {
      const std::string step = std::to_string(row.step);
      const std::string drive = cell(row.values[0]);
      for (std::size_t c = 0; c < row.values.size(); ++c) {
        line(motion_.columns[c], row.values[c], row.status, step, drive);
      }
    }
    for (const MotionEvent& event : motion_.events) {
      for (std::size_t d = 0; d < event.drive.size(); ++d) {
        const MotionColumn column{.element = event.element,
                                  .quantity = "event/" + event.kind + "/" + motion_.drives[d].name,
                                  .unit = motion_.drives[d].unit};
        event_line(column, event.drive[d], event);
      }
      const MotionColumn width{.element = event.element,
                               .quantity = "event/" + event.kind + "/uncertainty",
                               .unit = motion_.drives[0].unit};
      event_line(width, event.uncertainty, event);
      add_jumps(event);
    }
    if (motion_.overall_efficiency) {
      fixed_line({"", "overall_efficiency", ""}, *motion_.overall_efficiency);
    }
    add_gaps(motion_.drawn_gaps, "drawn_gap");
    add_corrections();
    add_gaps(motion_.nearest_gaps, "nearest_gap");
    add_dynamics();
    return std::move(text_);
  }

 private:
  void line(const MotionColumn& column,
            const std::optional<double>& value,
            std::string_view status,
            std::string_view step,
            std::string_view drive) {
    const std::string number = cell(value);
    append_csv_line(std::array<std::string_view, 10>{mechanism_,
                                                     motion_.label,
                                                     "motion",
                                                     column.element,
                                                     column.quantity,
                                                     number,
                                                     column.unit,
                                                     status,
                                                     step,
                                                     drive},
                    text_);
  }

  void event_line(const MotionColumn& column,
                  const std::optional<double>& value,
                  const MotionEvent& event) {
    line(column, value, event.kind, std::to_string(event.step), cell(event.drive[0]));
  }

  // Of friction that turns round: what columns come to on either side.
  void add_jumps(const MotionEvent& event) {
    for (std::size_t c = motion_.drives.size(); c < motion_.columns.size(); ++c) {
      const auto side = [&](const char* which, const std::optional<double>& value) {
        const MotionColumn column{
            .element = event.element,
            .quantity = fmt::format("event/{}/{}/{}", event.kind, which, motion_.columns[c].name()),
            .unit = motion_.columns[c].unit};
        event_line(column, value, event);
      };
      if (event.is_jump_of(c)) {
        side("before", event.value_before(c));
        side("after", event.value_after(c));
      }
    }
  }

  void fixed_line(const MotionColumn& column, double value) {
    line(column, value, word_of(motion_.end), {}, {});
  }

  void add_gaps(const std::vector<CouplingGap>& gaps, const std::string& quantity) {
    for (const CouplingGap& gap : gaps) {
      fixed_line({gap.coupling, quantity + "/distance", motion_.length_unit}, gap.distance);
      fixed_line({gap.coupling, quantity + "/angle", motion_.angle_unit}, gap.angle);
    }
  }

  void add_corrections() {
    for (const BodyCorrection& one : motion_.corrections) {
      for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_name(static_cast<std::size_t>(i));
        fixed_line({one.body, "correction/shift/" + axis, motion_.length_unit}, one.shift[i]);
      }
      fixed_line({one.body, "correction/angle", motion_.angle_unit}, one.angle);
    }
  }

  // Lines of a table of its own, which have neither step nor drive.
  void add_dynamics() {
    if (!motion_.dynamics) {
      return;
    }
    for (const NamedTable& table :
         tables_of(dynamics_tables(), motion_, mechanism_, motion_.dynamics->units)) {
      bool is_quoted = false;
      for (const char one : std::string_view(table.text).substr(kCsvHeader.size())) {
        is_quoted = is_quoted != (one == '"');
        text_ += one == '\n' && !is_quoted ? std::string(",,\n") : std::string(1, one);
      }
    }
  }

  const std::string& mechanism_;
  const MotionTable& motion_;
  std::string text_ = std::string(kMotionCsvHeader);
};

}  // namespace

std::string motion_csv(const std::string& mechanism, const MotionTable& motion) {
  return MotionCsv(mechanism, motion).run();
}

}  // namespace kinestat
