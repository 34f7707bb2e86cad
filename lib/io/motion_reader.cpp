#include "io/motion_reader.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "io/field_values.hpp"
#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kDrivesForm =
    "write drives: [{drive: NAME, from: 0 deg, to: 90 deg}, …], or drive, from and to for one";

DriveRange read_range(Fields& fields, Diagnostics& found) {
  DriveRange range;
  range.actuator = require_reference(fields, "drive", found);
  range.from = find_value(fields, "from", found);
  range.to = require_value(fields, "to", found);
  return range;
}

std::vector<DriveRange> read_ranges(const YamlNode& node, Diagnostics& found) {
  std::vector<DriveRange> ranges;
  if (!check_list(node, "'drives' of 'motion'", kDrivesForm, found)) {
    return ranges;
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const YamlNode& item = node.items[i];
    Fields fields(item, item.where, fmt::format("drive {} of 'motion'", i + 1), found);
    ranges.push_back(read_range(fields, found));
    fields.finish();
  }
  return ranges;
}

// Each of several drives has its own range.
void refuse_beside_drives(const YamlNode& node, Fields& fields, Diagnostics& found) {
  for (const std::string_view key : {"drive", "from", "to"}) {
    if (fields.find(key) != nullptr) {
      found.error("E0302",
                  place_of_key(node, key),
                  fmt::format("'motion' cannot have '{}' beside 'drives'", key),
                  std::string(kDrivesForm));
    }
  }
}

std::vector<TracePoint> read_trace(const YamlNode& node, Space space, Diagnostics& found) {
  std::vector<TracePoint> trace;
  const std::string_view hint = space == Space::planar
                                    ? "write trace: [{body: NAME, at: [x, y]}]"
                                    : "write trace: [{body: NAME, at: [x, y, z]}]";
  if (!check_list(node, "'trace' of 'motion'", hint, found)) {
    return trace;
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const YamlNode& item = node.items[i];
    Fields fields(item, item.where, fmt::format("trace point {}", i + 1), found);
    TracePoint point;
    point.body = require_reference(fields, "body", found);
    point.at = require_point(fields, "at", space, found);
    fields.finish();
    trace.push_back(std::move(point));
  }
  return trace;
}

}  // namespace

std::optional<MotionDescription> read_motion(const YamlNode& node,
                                             Space space,
                                             Diagnostics& found) {
  const int errors_before = found.error_count();
  MotionDescription motion;
  motion.where = node.where;
  Fields fields(node, node.where, "'motion'", found);
  if (const YamlNode* drives = fields.find("drives")) {
    motion.drives = read_ranges(*drives, found);
    refuse_beside_drives(node, fields, found);
  } else {
    motion.drives.push_back(read_range(fields, found));
  }
  motion.steps = find_value(fields, "steps", found);
  motion.label = find_reference(fields, "case", found);
  if (const YamlNode* trace = fields.find("trace")) {
    motion.trace = read_trace(*trace, space, found);
  }
  motion.report = find_references(fields, "report", found);
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(motion)) : std::nullopt;
}

}  // namespace kinestat
