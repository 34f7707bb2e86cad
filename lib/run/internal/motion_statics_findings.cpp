#include "run/internal/motion_statics_findings.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "power/transmission_angle.hpp"
#include "report/numbers.hpp"
#include "run/internal/action_findings.hpp"
#include "run/internal/motion_position.hpp"

namespace kinestat {

namespace {

bool reports_actions(const MotionReport& report) {
  return report.action || report.power || report.mechanical_advantage || !report.actions.empty() ||
         !report.actuators.empty();
}

std::string reason_of(TransmissionObstacle why, std::string_view output) {
  switch (why) {
    case TransmissionObstacle::same_actuator:
      return "it is the input too";
    case TransmissionObstacle::no_one_coupling:
      return fmt::format("not one coupling alone drives the body of '{}'", output);
    case TransmissionObstacle::open_force:
      return fmt::format("equilibrium does not determine the force that drives '{}'", output);
    case TransmissionObstacle::couple:
      return fmt::format("a couple drives '{}', and it has no line", output);
    case TransmissionObstacle::rest:
      return fmt::format("'{}' does not move where the force acts", output);
  }
  return {};
}

std::string hint_of(TransmissionObstacle why) {
  return why == TransmissionObstacle::open_force
             ? "write 'space: planar' if all moves in one plane, or leave out with 'passive:' what "
               "the couplings do not bear; 'mechanical_advantage' needs no force"
             : "take 'transmission_angle' out of 'report'; 'mechanical_advantage' says how well "
               "the output is driven";
}

class StaticsFindings {
 public:
  StaticsFindings(const FoundMotion& motion,
                  const MechanismDescription& description,
                  const Mechanism& mechanism,
                  Diagnostics& found)
      : motion_(motion), description_(description), mechanism_(mechanism), found_(found) {}

  // Only where no position has one: at dead points alone it explains itself.
  void add_transmission() {
    const MotionTable& table = motion_.table;
    const auto column =
        std::ranges::find(table.columns, "transmission_angle", &MotionColumn::quantity);
    if (column == table.columns.end()) {
      return;
    }
    const auto c = static_cast<std::size_t>(column - table.columns.begin());
    const MotionRow* first = nullptr;
    for (const MotionRow& row : table.rows) {
      if (row.values[c]) {
        return;
      }
      first = first == nullptr && row.status != "singular" ? &row : first;
    }
    if (first == nullptr) {
      return;
    }
    MotionPositions positions(
        mechanism_,
        motion_.plan,
        motion_.network,
        motion_.drawn,
        {.transmission_angle = true, .misclosure = worst_misclosure(motion_.solution)});
    positions.at(motion_.solution.configuration_at(first->step));
    const Case& which = mechanism_.cases[static_cast<std::size_t>(motion_.plan.which)];
    const int output = which.outputs.front();
    if (const auto why =
            find_transmission_obstacle(positions.moved(), which.inputs.front(), output)) {
      const std::string& name =
          mechanism_.topology.actuators[static_cast<std::size_t>(output)].name;
      found_.warning("W0505",
                     motion_.plan.where,
                     fmt::format("'{}' has no transmission angle: {}", name, reason_of(*why, name)),
                     hint_of(*why));
    }
  }

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
    MotionPositions positions(mechanism_,
                              motion_.plan,
                              motion_.network,
                              motion_.drawn,
                              {.statics = true, .misclosure = worst_misclosure(motion_.solution)});
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
  StaticsFindings findings(motion, description, mechanism, found);
  if (reports_actions(motion.plan.report)) {
    findings.add_all();
  }
  findings.add_transmission();
}

}  // namespace kinestat
