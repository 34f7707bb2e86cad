#include "studies/tolerance/report/tolerance_record.hpp"

#include <utility>

#include "report/report_keys.hpp"

namespace kinestat {

namespace {

struct ShareView {
  const ToleranceShare& share;
  QuantityKind of;  // of the position
  const FileUnits& units;
  bool has_tolerances;
};

struct StackView {
  const ToleranceStack& stack;
  const std::optional<DrivePlace>& drive;
  const FileUnits& units;
  bool has_tolerances;
};

struct CaseView {
  const CaseTolerance& one;
  const FileUnits& units;
};

ShownValue shown(double si, QuantityKind kind, const FileUnits& units) {
  return {.value = si == 0.0 ? 0.0 : units.from_si(kind, si), .unit = units.text(kind)};
}

std::pair<std::optional<double>, std::string> pair_of(const ShownValue& value) {
  return {value.value, value.unit};
}

// A value whose unit the rest of the report does not tell.
const Record<ShownValue>& shown_record() {
  static const Record<ShownValue> record("A length or an angle.", [](Record<ShownValue>& keys) {
    keys.converted("value", ByContext::beside, "The number.", pair_of).in_tables_as("");
    keys.text("unit", "Its unit.", [](const ShownValue& v) { return v.unit; }).not_compared();
  });
  return record;
}

const Record<ShareView>& share_record() {
  using View = ShareView;
  static const Record<View> record(
      "The effect on the position of parts at one coupling, or of one "
      "drive.",
      [](Record<View>& keys) {
        const auto influence = [](const View& v) {
          return shown_influence(v.share, v.of, v.units);
        };
        const auto has = [](const View& v) { return v.has_tolerances; };
        keys.converted("influence",
                       ByContext::beside,
                       "Movement of the position per unit of the deviation, in the direction that "
                       "has the most effect. It is also the action that holds the deviation under "
                       "a unit action at the position.",
                       [influence](const View& v) { return pair_of(influence(v)); });
        keys.text("unit",
                  "Unit of the position per unit of the deviation; empty if they are of the same "
                  "kind.",
                  [influence](const View& v) { return influence(v).unit; })
            .not_compared();
        keys.vector("direction",
                    Bare::direction,
                    "The direction that has the most effect, of the head relative to the tail: "
                    "along it for a location, about it for an angle; null for a drive, or where "
                    "nothing moves.",
                    [](const View& v) { return v.share.direction; });
        keys.part("tolerance",
                  shown_record(),
                  "How far the parts may deviate, to either side. Only where a tolerance is given.",
                  [](const View& v) { return shown(v.share.tolerance, v.share.kind, v.units); })
            .only_if(has);
        keys.part("moved",
                  shown_record(),
                  "How far this may move the position, to either side.",
                  [](const View& v) { return shown(v.share.moved, v.of, v.units); })
            .only_if(has);
      });
  return record;
}

const Record<StackView>& stack_record() {
  using View = StackView;
  static const Record<View> record("The error of one position.", [](Record<View>& keys) {
    const auto has = [](const View& v) { return v.has_tolerances; };
    keys.part("drive",
              shown_record(),
              "Position of the first drive of the motion.",
              [](const View& v) { return v.drive->value; })
        .only_if([](const View& v) { return v.drive.has_value(); })
        .only_in_tables();
    keys.converted("worst_case",
                   ByContext::beside,
                   "Sum over all deviations, each at its tolerance in the direction that has the "
                   "most effect. Only where a tolerance is given.",
                   [](const View& v) {
                     return pair_of(shown(v.stack.worst_case, v.stack.position.kind, v.units));
                   })
        .only_if(has);
    keys.converted("root_sum_square",
                   ByContext::beside,
                   "Root sum square of the same contributions: what to expect if deviations are "
                   "independent.",
                   [](const View& v) {
                     return pair_of(shown(v.stack.root_sum_square, v.stack.position.kind, v.units));
                   })
        .only_if(has);
    keys.text("unit",
              "Unit of the position.",
              [](const View& v) { return v.units.text(v.stack.position.kind); })
        .not_compared();
    keys.map("by",
             share_record(),
             "What moves it: COUPLING/place, COUPLING/angle and DRIVE/drive.",
             [](const View& v, const Each<ShareView>& each) {
               for (const ToleranceShare& share : v.stack.shares) {
                 each(share.name,
                      {.share = share,
                       .of = v.stack.position.kind,
                       .units = v.units,
                       .has_tolerances = v.has_tolerances});
               }
             })
        .in_tables_is(TableRole::element);
  });
  return record;
}

const Record<CaseView>& case_record() {
  using View = CaseView;
  static const Record<View> record(
      "One case of the file, or one step of its motion.", [](Record<View>& keys) {
        keys.part("drive",
                  shown_record(),
                  "Where the first drive of the motion stands; only with --along.",
                  [](const View& v) { return v.one.drive->value; })
            .only_if([](const View& v) { return v.one.drive.has_value(); })
            .not_in_tables();
        keys.names("held",
                   "The drives that are held: those of the motion, or the known motions of the "
                   "case; none in a singular position, where nothing is held.",
                   [](const View& v, const EachName& each) {
                     for (const std::string& name : v.one.held) {
                       each(name);
                     }
                   })
            .not_in_tables();
        keys.map("positions",
                 stack_record(),
                 "Positions by name: a freedom, a component of a point or of a body.",
                 [](const View& v, const Each<StackView>& each) {
                   for (const ToleranceStack& stack : v.one.positions) {
                     each(stack.position.name,
                          {.stack = stack,
                           .drive = v.one.drive,
                           .units = v.units,
                           .has_tolerances = v.one.has_tolerances});
                   }
                 })
            .in_tables_is(TableRole::table);
        keys.names("loose",
                   "Positions without influences, as the drives do not hold them: an idle freedom "
                   "moves them.",
                   [](const View& v, const EachName& each) {
                     for (const std::string& name : v.one.loose) {
                       each(name);
                     }
                   })
            .not_in_tables();
        keys.names("not_fitting",
                   "Actions along or about which no part can deviate alone, because constraints "
                   "are redundant there: other parts would have to bend, or need play.",
                   [](const View& v, const EachName& each) {
                     for (const std::string& name : v.one.not_fitting) {
                       each(name);
                     }
                   })
            .not_in_tables();
      });
  return record;
}

const Record<FoundTolerance>& general_record() {
  using View = FoundTolerance;
  static const Record<View> record(
      "How far what has no tolerance of its own may deviate, to either side.",
      [](Record<View>& keys) {
        keys.quantity("place", QuantityKind::length, "Places of couplings.", [](const View& v) {
          return v.place;
        });
        keys.quantity(
            "angle", QuantityKind::angle, "Angles of guides and axes.", [](const View& v) {
              return v.angle;
            });
      });
  return record;
}

}  // namespace

const Record<ToleranceReportView>& tolerance_report_record() {
  using View = ToleranceReportView;
  static const Record<View> record(
      "What 'kinestat tolerance --format json' writes: position errors caused by deviations of "
      "parts and drives, to first order.",
      [](Record<View>& keys) {
        add_head(keys);
        keys.part("tolerances",
                  general_record(),
                  [](const View& v) -> const FoundTolerance& { return v.answer; })
            .not_in_tables();
        keys.map("cases",
                 case_record(),
                 "Cases by label; with --along the steps of the motion.",
                 [](const View& v, const Each<CaseView>& each) {
                   for (const CaseTolerance& one : v.answer.cases) {
                     each(one.label, {.one = one, .units = v.description.units});
                   }
                 })
            .in_tables_is(TableRole::cases);
        add_diagnostics(keys);
      });
  return record;
}

}  // namespace kinestat
