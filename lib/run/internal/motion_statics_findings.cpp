#include "run/internal/motion_statics_findings.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "report/numbers.hpp"
#include "run/internal/action_findings.hpp"
#include "run/internal/motion_position.hpp"

namespace kinestat {

namespace {

bool reports_actions(const MotionReport& report) {
  return report.action || report.power || report.mechanical_advantage || !report.actions.empty() ||
         !report.actuators.empty();
}

class StaticsFindings {
 public:
  StaticsFindings(const FoundMotion& motion,
                  const MechanismDescription& description,
                  const Mechanism& mechanism,
                  Diagnostics& found)
      : motion_(motion), description_(description), mechanism_(mechanism), found_(found) {}

  void add_all() {
    using enum SolveStatus;
    for (const SolveStatus status :
         std::array{inconsistent, dependent, overflow, undirected, locked}) {
      add(word_of(status));
    }
  }

 private:
  void add(std::string_view status) {
    const std::vector<MotionRow>& rows = motion_.table.rows;
    const auto first = std::ranges::find(rows, status, &MotionRow::status);
    if (first == rows.end()) {
      return;
    }
    const std::string where =
        fmt::format(" (at {}{})",
                    drives_text(*first),
                    count_text(std::ranges::count(rows, status, &MotionRow::status)));
    const Diagnostics said = findings_at(first->step);
    for (const Diagnostic& one : said.items()) {
      if (is_said(one)) {
        continue;
      }
      if (one.severity == Severity::error) {
        found_.error(one.code, one.where, one.message + where, one.hint);
      } else {
        found_.warning(one.code, one.where, one.message + where, one.hint);
      }
    }
  }

  // Of the drawn position, in a whole analysis.
  bool is_said(const Diagnostic& one) const {
    return std::ranges::any_of(found_.items(), [&](const Diagnostic& other) {
      return other.code == one.code && other.where == one.where;
    });
  }

  std::string count_text(std::ptrdiff_t count) const {
    return count == 1
               ? std::string()
               : fmt::format(" and {} more positions of {}", count - 1, motion_.table.rows.size());
  }

  std::string drives_text(const MotionRow& row) const {
    std::string text;
    for (std::size_t d = 0; d < motion_.table.drives.size(); ++d) {
      const DriveTravel& drive = motion_.table.drives[d];
      text += fmt::format("{}{} = {}{}{}",
                          d == 0 ? "" : ", ",
                          drive.name,
                          format_short(row.values[d].value_or(0.0)),
                          drive.unit.empty() ? "" : " ",
                          drive.unit);
    }
    return text;
  }

  // Of the statics of that position, analysed anew.
  Diagnostics findings_at(int step) const {
    MotionPositions positions(
        mechanism_, motion_.plan, motion_.network, motion_.drawn, {.statics = true});
    MotionPosition position = positions.at(motion_.solution.configuration_at(step));
    Analysis analysis;
    analysis.description = description_;
    analysis.mechanism = positions.moved();
    analysis.cases.push_back(*std::move(position.solved));
    Diagnostics said;
    add_action_findings(analysis, analysis.cases.front(), said);
    return said;
  }

  const FoundMotion& motion_;
  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  Diagnostics& found_;
};

}  // namespace

void add_motion_statics_findings(const FoundMotion& motion,
                                 const MechanismDescription& description,
                                 const Mechanism& mechanism,
                                 Diagnostics& found) {
  if (reports_actions(motion.plan.report)) {
    StaticsFindings(motion, description, mechanism, found).add_all();
  }
}

}  // namespace kinestat
