#include <optional>
#include <string>

#include "core/utf8.hpp"
#include "studies/synthesis/linkages/linkage_motion.hpp"
#include "studies/synthesis/linkages/linkage_record.hpp"
#include "studies/synthesis/report/synthesis_record.hpp"

namespace kinestat {

namespace {

const Record<LimitsNeeded>& limits_needed_record() {
  using View = LimitsNeeded;
  static const Record<View> record(
      "Limits with which it would be usable, which it meets exactly; null if it is usable, or does "
      "not pass the positions. Each key is null if the limit is kept to.",
      [](Record<View>& keys) {
        keys.word("class",
                  words_up_to(GrashofClass::change_point),
                  "Its class; also null of what is no four-bar.",
                  [](const View& v) -> std::optional<std::string_view> {
                    return v.grashof ? std::optional(word_of(*v.grashof)) : std::nullopt;
                  });
        keys.word("circuit",
                  words_up_to(LinkageCircuit::single),
                  "Its circuit; also null of what has no crank.",
                  [](const View& v) -> std::optional<std::string_view> {
                    return v.circuit ? std::optional(word_of(*v.circuit)) : std::nullopt;
                  });
        keys.flag("turns_fully", "false: its input meets a dead point.", [](const View& v) {
          return v.may_stop ? std::optional(false) : std::nullopt;
        });
        keys.quantity("outside",
                      QuantityKind::length,
                      "Distance of its pivots from the areas of 'centre_points' and "
                      "'circle_points', of the one farthest from its own.",
                      [](const View& v) { return v.outside; });
        keys.quantity("transmission_angle", QuantityKind::angle, "Its margin.", [](const View& v) {
          return v.transmission;
        });
        keys.quantity("full_transmission_angle",
                      QuantityKind::angle,
                      "Its margin wherever the input can go.",
                      [](const View& v) { return v.full_transmission; });
        keys.number("link_ratio", Bare::ratio, "Its ratio.", [](const View& v) { return v.ratio; });
        keys.quantity("size", QuantityKind::length, "Its longest link.", [](const View& v) {
          return v.size;
        });
      });
  return record;
}

const Record<LinkageCheck>& check_record() {
  using View = LinkageCheck;
  static const Record<View> record(
      "What the linkage does when it is moved as a mechanism; null where that was not asked for, "
      "and of linkages without digits.",
      [](Record<View>& keys) {
        keys.custom("reached",
                    list_shape(flag_shape(false)),
                    "Of each position, whether its drive comes to it from the first, in either "
                    "sense, without meeting a limit.",
                    [](const View& v, Archive& to) {
                      to.begin_list();
                      for (const bool is_reached : v.reached) {
                        to.flag(is_reached);
                      }
                      to.end_list();
                    });
        keys.flag("in_order",
                  "Whether it reaches all of them one after the other in one direction, that of "
                  "the verdict if it has one.",
                  [](const View& v) { return v.passes_in_order; });
        keys.number("worst",
                    Bare::number,
                    "By how much it misses a position that the verdict promises: the larger of the "
                    "distance as a fraction of the size and the rotation in radians; 0 where it "
                    "promises none.",
                    [](const View& v) { return v.worst; })
            .at_least(0)
            .not_compared();
        keys.flag("agrees", "Whether this is what the verdict says.", [](const View& v) {
          return v.agrees;
        });
      });
  return record;
}

// Null unless the file asks for curves; the coupler of a function has no point of its own.
void write_coupler_curve(const FoundLinkageView& v, Archive& to) {
  if (!v.analysis.description.synthesis->curve_count || v.analysis.limits.function) {
    to.null();
    return;
  }
  const LinkageCandidate& candidate = v.candidate();
  const LinkageMotion motion = trace_circuit(candidate.linkage,
                                             candidate.best_drive,
                                             pose_of(v.task.positions[0]),
                                             v.window.count,
                                             v.window.radius);
  branch_record().write(
      {.branch = {.points = coupler_curve(motion, {0.0, 0.0}), .is_closed = motion.is_closed}}, to);
}

std::optional<std::string> written_file(const FoundLinkageView& v) {
  const bool is_written = v.number < v.task.files.size() && !v.task.files[v.number].empty();
  return is_written ? std::optional(printable(v.task.files[v.number])) : std::nullopt;
}

std::optional<LinkageCheck> check_of(const FoundLinkageView& v) {
  return v.number < v.task.checks.size() ? v.task.checks[v.number] : std::nullopt;
}

}  // namespace

const Record<FoundLinkageView>& found_linkage_record() {
  using View = FoundLinkageView;
  static const Record<View> record("Two dyads.", [](Record<View>& keys) {
    keys.include(linkage_record(),
                 [](const View& v) -> const LinkageCandidate& { return v.candidate(); });
    keys.part("limits_needed", limits_needed_record(), [](const View& v) {
      return find_limits_needed(v.candidate());
    });
    keys.custom("coupler_curve",
                object_shape(branch_record(), true),
                "Path of the origin of the moving frame on the circuit of the first position, "
                "driven by 'drive'; null unless the file requests curves, and of a function.",
                write_coupler_curve);
    keys.part("verification", check_record(), check_of);
    keys.text("file", "The mechanism file written for it; null if there is none.", written_file)
        .not_compared();
  });
  return record;
}

}  // namespace kinestat
