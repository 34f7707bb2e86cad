#include "studies/motion/task/drive_counts.hpp"

#include <variant>

#include "expression/evaluate.hpp"
#include "expression/parameters.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

class DriveCounter {
 public:
  DriveCounter(const MechanismDescription& description, const MotionPlan& plan)
      : description_(description),
        steps_(plan.steps),
        table_(evaluate_parameters<Exact>(parameters_of(description)).table) {}

  std::optional<WholeRange> count(const DriveRange& typed, const PlannedDrive& drive, bool turns) {
    const QuantityKind kind = position_kind(turns);
    const auto from = count(typed.from, kind, drive.from);
    const auto to = count(typed.to, kind, drive.to);
    if (!from || !to || *from == *to) {
      return std::nullopt;
    }
    return whole_range(from, to, (*to - *from) / Rational(steps_));
  }

 private:
  // An end that is left out is where the mechanism is drawn, or follows from the time.
  std::optional<Rational> count(const std::optional<Value>& typed,
                                QuantityKind kind,
                                double planned) {
    if (!typed) {
      return planned == 0.0 ? std::optional(Rational(0)) : std::nullopt;
    }
    const auto value =
        evaluate_as<Exact>(kind, typed->expression, description_.units, table_.lookup(), {});
    const auto* const exact = std::get_if<Exact>(&value);
    return exact != nullptr && exact->value == planned
               ? exact_count(*exact, description_.units.scale(kind))
               : std::nullopt;
  }

  const MechanismDescription& description_;
  int steps_ = 0;
  BasicParameterTable<Exact> table_;
};

}  // namespace

std::vector<std::optional<WholeRange>> drive_counts(const MechanismDescription& description,
                                                    const Topology& topology,
                                                    const MotionPlan& plan) {
  const std::vector<DriveRange>& typed = description.motion->drives;
  DriveCounter counter(description, plan);
  std::vector<std::optional<WholeRange>> counts;
  for (std::size_t d = 0; d < plan.drives.size(); ++d) {
    const PlannedDrive& drive = plan.drives[d];
    const bool turns = topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation;
    const bool has_range = d < typed.size() && (!plan.schedule || plan.schedule->is_straight());
    counts.push_back(has_range ? counter.count(typed[d], drive, turns) : std::nullopt);
  }
  return counts;
}

double shown_drive(const MechanismDescription& description,
                   const Topology& topology,
                   const FoundMotion& motion,
                   const std::optional<WholeRange>& count,
                   std::size_t drive,
                   int position) {
  const int steps = motion.plan.steps;
  const double share =
      position == steps ? 1.0 : static_cast<double>(position) / static_cast<double>(steps);
  if (count && motion.solution.shares[static_cast<std::size_t>(position)] == share) {
    return count->at(position);
  }
  const auto freedom = static_cast<std::size_t>(motion.plan.drives[drive].freedom);
  const QuantityKind kind = position_kind(topology.freedoms[freedom].is_rotation);
  const double value =
      description.units.from_si(kind, motion.solution.drive_value(drive, position));
  return value == 0.0 ? 0.0 : value;
}

}  // namespace kinestat
