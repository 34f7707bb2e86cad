#include "studies/motion/task/row_place.hpp"

#include <fmt/format.h>

#include "report/number_format.hpp"

namespace kinestat {

std::string row_place(const MotionTable& table, const MotionRow& row) {
  std::string text;
  for (std::size_t d = 0; d < table.drives.size(); ++d) {
    const DriveTravel& drive = table.drives[d];
    text += fmt::format("{}{} = {}{}{}",
                        d == 0 ? "" : ", ",
                        drive.name,
                        format_short(row.values[d].value_or(0.0)),
                        drive.unit.empty() ? "" : " ",
                        drive.unit);
  }
  return text;
}

}  // namespace kinestat
