#include <fmt/format.h>

#include "core/utf8.hpp"
#include "pages/motion_tables.hpp"
#include "pages/page_parts.hpp"
#include "pages/tables.hpp"
#include "studies/motion/picture/actuator_curves.hpp"
#include "studies/motion/picture/dynamics_curves.hpp"
#include "studies/motion/picture/motion_curves.hpp"
#include "studies/motion/report/motion_dynamics_text.hpp"
#include "studies/motion/report/motion_text.hpp"

namespace kinestat {

namespace {

void add_motion_tables(const MotionTable& motion, Html& html) {
  if (!motion.label.empty()) {
    html.element("p",
                 fmt::format("With the speeds and loads of case {}.", printable(motion.label)));
  }
  add_table(drive_table(motion), "Drives", html);
  if (!motion.events.empty()) {
    add_table(event_table(motion), "Events", html);
  }
  add_blocks(motion_remarks(motion), "Motion", html);
}

}  // namespace

void add_motion_part(SectionWriter& section) {
  const FilePage& page = section.page();
  Html& html = section.html();
  if (!page.motion) {
    section.add_lack("motion", "Motion", page.description && page.description->motion);
    return;
  }
  section.open_part("motion", "Motion");
  add_motion_tables(page.motion->table, html);
  add_blocks(motion_dynamics_blocks(page.motion->table), "Dynamics", html);
  html.open("div", {{"class", "charts"}});
  section.add_charts(motion_figure(page.motion->table, ""), "Motion", ChartRows::of_motion);
  section.add_charts(path_figure(page.motion->table, ""), "Paths of points", ChartRows::of_motion);
  if (page.motion->table.dynamics) {
    section.add_charts(actuator_figure(page.motion->table, ""), "Actions of actuators");
    section.add_charts(speed_torque_figure(page.motion->table, ""), "Action over speed");
    section.add_charts(shaking_figure(page.motion->table, ""), "Shaking force");
    section.add_charts(harmonic_figure(page.motion->table, ""), "Harmonics");
  }
  html.close();
  const std::size_t positions = page.motion->table.rows.size();
  if (positions > kMostPositions) {
    html.element("p",
                 fmt::format("The table has some of the {} positions; the file of the motion "
                             "under Data has all.",
                             positions));
  }
  if (positions > 0) {
    add_table(position_table(page.motion->table), "Positions", html);
  }
  html.close();
}

}  // namespace kinestat
