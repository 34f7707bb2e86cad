#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "studies/motion/task/motion_findings.hpp"
#include "studies/motion/task/position_findings.hpp"

namespace kinestat {

namespace {

class SpeedFindings {
 public:
  SpeedFindings(const FoundMotion& motion, const Mechanism& mechanism, Diagnostics& found)
      : motion_(motion), mechanism_(mechanism), found_(found) {}

  void add_all() {
    add_unmoved_drives();
    add_singular_rows();
    add_flat_rows();
    add_dropped_cells();
  }

 private:
  using Condition = std::function<bool(const MotionRow&)>;

  const MotionRow* first_of(const Condition& holds) const {
    const auto row = std::ranges::find_if(motion_.table.rows, holds);
    return row == motion_.table.rows.end() ? nullptr : &*row;
  }

  // "m = 5 deg and 2 more positions of 3"
  std::string places_text(const MotionRow& first, const Condition& holds) const {
    const std::string text = row_place(motion_.table, first);
    const std::vector<MotionRow>& rows = motion_.table.rows;
    const auto count = std::ranges::count_if(rows, holds);
    return count == 1 ? text
                      : text + fmt::format(" and {} more position{} of {}",
                                           count - 1,
                                           count == 2 ? "" : "s",
                                           rows.size());
  }

  // The judge of the case has nothing against these.
  static bool is_solved(const MotionRow& row) {
    return row.lacks_velocities && row.status == "solved";
  }

  void add_unmoved_drives() {
    if (const MotionRow* first = first_of(is_solved)) {
      found_.warning("W0507",
                     motion_.plan.where,
                     fmt::format("velocities are omitted at {}: the motions that case '{}' gives "
                                 "do not move the drives there",
                                 places_text(*first, is_solved),
                                 which().label),
                     "give the speed of the drives themselves in 'motion:' of the case");
    }
  }

  bool is_reported(std::string_view code) const {
    return std::ranges::any_of(found_.items(),
                               [&](const Diagnostic& other) { return other.code == code; });
  }

  const Case& which() const {
    return mechanism_.cases[static_cast<std::size_t>(motion_.plan.which)];
  }

  // Where the motion goes on, its events name singular positions; otherwise its end does.
  void add_singular_rows() {
    const Condition holds = [](const MotionRow& row) {
      return row.lacks_velocities && row.status == kSingularEvent;
    };
    const MotionRow* first = first_of(holds);
    const bool is_named = is_reported("W0503") || is_reported("E0505") ||
                          is_reported(kEndsAtLimit) || is_reported("E0506");
    if (first != nullptr && !is_named) {
      found_.warning(
          "W0507",
          motion_.plan.where,
          fmt::format(
              "velocities are omitted at {}: the drives do not determine them there, or hardly",
              places_text(*first, holds)),
          "the position is singular, or so near to it that nothing but rounding would "
          "be left; take other steps, or another drive");
    }
  }

  void add_flat_rows() {
    const Condition holds = [](const MotionRow& row) { return row.lacks_accelerations; };
    if (const MotionRow* first = first_of(holds)) {
      found_.warning("W0507",
                     motion_.plan.where,
                     fmt::format("accelerations are omitted at {}: a singular position is so near "
                                 "that they would be rounding",
                                 places_text(*first, holds)),
                     "velocities are correct there; choose other steps or another drive");
    }
  }

  void add_dropped_cells() {
    const std::pair<std::string_view, Condition> kinds[] = {
        {"velocities", [](const MotionRow& row) { return row.drops_velocities; }},
        {"accelerations", [](const MotionRow& row) { return row.drops_accelerations; }}};
    for (const auto& [name, holds] : kinds) {
      if (const MotionRow* first = first_of(holds)) {
        found_.warning(
            "W0507",
            motion_.plan.where,
            fmt::format("some {} are omitted at {}: rounding leaves them open so near to "
                        "a singular position, or where they follow from what hardly "
                        "moves",
                        name,
                        places_text(*first, holds)),
            "the values shown are correct; choose other steps, or drive the part that "
            "runs fast, such as the spindle of a screw");
      }
    }
  }

  const FoundMotion& motion_;
  const Mechanism& mechanism_;
  Diagnostics& found_;
};

}  // namespace

void add_motion_speed_findings(const FoundMotion& motion,
                               const Mechanism& mechanism,
                               Diagnostics& found) {
  SpeedFindings(motion, mechanism, found).add_all();
}

}  // namespace kinestat
