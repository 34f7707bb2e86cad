#include "studies/motion/task/motion_choice.hpp"

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

Name name_of(const std::string& text) {
  return {.text = text, .where = {}};
}

// Replaces a value if the option is there.
void replace(const char* option,
             const std::optional<std::string>& text,
             std::optional<Value>& value,
             Diagnostics& found) {
  if (!text) {
    return;
  }
  auto parsed = parse_expression(*text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    found.error("E0101",
                {},
                fmt::format("{} '{}': {}", option, printable(*text), error->message),
                error->hint);
    return;
  }
  value = Value{.expression = std::get<Expression>(std::move(parsed)), .where = {}};
}

void replace_drive(const MotionChoice& choice, MotionDescription& motion, Diagnostics& found) {
  if (choice.drive) {
    motion.drives = {DriveRange{.actuator = name_of(*choice.drive), .from = {}, .to = {}}};
  }
  if (motion.drives.size() > 1 && (choice.from || choice.to)) {
    found.error("E0101",
                {},
                "--from and --to are of one drive, and the file has several",
                "say which: --drive NAME");
    return;
  }
  if (motion.drives.empty()) {
    found.error("E0303",
                {},
                "the file has no section 'motion'",
                "add motion: {drive: NAME, to: VALUE}, or write --drive NAME --to VALUE");
    return;
  }
  if (choice.from || choice.to) {
    motion.drives.front().profile.clear();
    motion.drives.front().curve.reset();
  }
  replace("--from", choice.from, motion.drives.front().from, found);
  replace("--to", choice.to, motion.drives.front().to, found);
  if (!motion.drives.front().to && !motion.drives.front().has_course() && !motion.time &&
      !found.has_errors()) {
    found.error("E0101",
                {},
                fmt::format("the motion of '{}' has no end",
                            printable(motion.drives.front().actuator.text)),
                "write for example --to '90 deg'");
  }
}

}  // namespace

bool apply(const MotionChoice& choice, MechanismDescription& description, Diagnostics& found) {
  const int errors_before = found.error_count();
  MotionDescription motion = description.motion.value_or(MotionDescription{});
  replace_drive(choice, motion, found);
  replace("--steps", choice.steps, motion.steps, found);
  if (choice.label) {
    motion.label = name_of(*choice.label);
  }
  if (!choice.report.empty()) {
    motion.report.clear();
    for (const std::string& name : choice.report) {
      motion.report.push_back(name_of(name));
    }
  }
  motion.is_another = choice.drive || choice.from || choice.to || choice.label;
  description.motion = std::move(motion);
  return found.error_count() == errors_before;
}

}  // namespace kinestat
