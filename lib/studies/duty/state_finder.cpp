#include "studies/duty/state_finder.hpp"

#include <algorithm>
#include <utility>

#include "cases/converter_slip.hpp"
#include "cases/solve_cases.hpp"

namespace kinestat {

namespace {

// So many sets of senses at most are kept of a case.
constexpr std::size_t kMostKnown = 64;

// A case with these magnitudes.
Case case_at(Case which, std::span<const double> motions, std::span<const double> actions) {
  for (std::size_t i = 0; i < motions.size(); ++i) {
    which.motions[i].value = motions[i];
  }
  for (std::size_t i = 0; i < actions.size(); ++i) {
    which.actions[i].value = actions[i];
  }
  return which;
}

}  // namespace

ClosedCase::ClosedCase(const Mechanism& mechanism,
                       Case which,
                       std::span<const Mesh> meshes,
                       OnAnalysis on_analysis)
    : mechanism_(mechanism),
      which_(std::move(which)),
      meshes_(meshes),
      on_analysis_(std::move(on_analysis)),
      motions_(mechanism, which_),
      is_plain_(motions_.is_solved() && has_plain_statics(mechanism) && !which_.has_inertia()) {}

std::optional<DutyState> ClosedCase::find(std::span<const double> motions,
                                          std::span<const double> actions) {
  if (is_plain_) {
    for (std::size_t i = 0; i < known_.size(); ++i) {
      DutyCase& one = *known_[i];
      if (one.moves_alike(motions) && one.presses_alike(motions, actions)) {
        std::rotate(known_.begin(),
                    known_.begin() + static_cast<std::ptrdiff_t>(i),
                    known_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        std::optional<DutyState> state = known_.front()->state_at(motions, actions);
        if (state && has_right_freewheels(*state)) {
          return state;
        }
        break;
      }
    }
  }
  std::optional<DutyState> state = find_anew(case_at(which_, motions, actions), motions, actions);
  if (state) {
    on_analysis_(last_);
  }
  return state;
}

// Where one is on the wrong side, an analysis of the point has to say so.
bool ClosedCase::has_right_freewheels(const DutyState& state) const {
  return std::ranges::none_of(mechanism_.freewheels, [&](const Freewheel& one) {
    const double torque = state.actions[static_cast<std::size_t>(one.action)].value_or(0.0);
    return fault_of(one, torque, state.rates[static_cast<std::size_t>(one.freedom)]).has_value();
  });
}

std::optional<DutyState> ClosedCase::find_anew(Case there,
                                               std::span<const double> motions,
                                               std::span<const double> actions) {
  if (is_plain_ && known_.size() < kMostKnown) {
    auto made = std::make_unique<DutyCase>(mechanism_, std::move(there), motions_, meshes_);
    std::optional<DutyState> state = made->is_prepared()
                                         ? made->state_at(motions, actions)
                                         : state_of(mechanism_, made->analysis(), meshes_);
    last_ = made->analysis();
    if (made->is_prepared()) {
      known_.insert(known_.begin(), std::move(made));
    }
    return state;
  }
  last_ = std::move(solve_some_cases(mechanism_, std::span(&there, 1)).front());
  return state_of(mechanism_, last_, meshes_);
}

StateFinder::StateFinder(const Mechanism& mechanism,
                         std::size_t which,
                         std::span<const Mesh> meshes,
                         const OnAnalysis& on_analysis)
    : mechanism_(mechanism),
      meshes_(meshes),
      on_analysis_(on_analysis),
      drawn_(mechanism, mechanism.cases[which], meshes, on_analysis) {}

std::optional<DutyState> StateFinder::find(const DutyPoint& point) {
  if (by_converter_) {
    return find_open(point);
  }
  return analyse(point);
}

// The slip first, and then as any point whose motions are known. Where the torques decide no slip,
// one analysis that says so is enough.
std::optional<DutyState> StateFinder::find_open(const DutyPoint& point) {
  std::vector<double> actions = point.actions;
  actions.erase(actions.begin() + static_cast<std::ptrdiff_t>(by_converter_->deciding));
  const SlipAnswer slip =
      by_converter_->slips->find(point.motions, actions, point.actions[by_converter_->deciding]);
  if (slip.is_sure && !slip.rate && has_unanswered_) {
    return std::nullopt;
  }
  if (slip.is_sure && slip.rate) {
    std::vector<double> motions = point.motions;
    motions.push_back(*slip.rate);
    if (std::optional<DutyState> state = by_converter_->closed->find(motions, actions)) {
      return state;
    }
  }
  return analyse(point);
}

std::optional<DutyState> StateFinder::analyse(const DutyPoint& point) {
  std::optional<DutyState> state = drawn_.find(point.motions, point.actions);
  if (state && drawn_.is_plain()) {
    return state;
  }
  CaseAnalysis analysis = drawn_.take_analysis();
  const std::optional<ConverterSearch>& search = analysis.converter_search;
  if (!has_tried_converter_ && search && search->which) {
    add_converter(*search);
  }
  if (!state && !has_unanswered_) {
    has_unanswered_ = true;
    unanswered_ = std::move(analysis);
  }
  return state;
}

// Where its points can be solved together. A converter or an action that is tried before the one
// that decides might decide elsewhere.
void StateFinder::add_converter(const ConverterSearch& search) {
  has_tried_converter_ = true;
  const Case& open = drawn_.which();
  const std::size_t deciding = deciding_actions(mechanism_.topology, open).front();
  const auto converter =
      std::ranges::find_if(mechanism_.frictions, [](const CouplingFriction& one) {
        return one.converter != nullptr && !one.converter->is_of_stator;
      });
  if (open.actions[deciding].index != search.action || converter->coupling != search.coupling) {
    return;
  }
  ByConverter one{
      .deciding = deciding,
      .closed = std::make_unique<ClosedCase>(mechanism_, *search.which, meshes_, on_analysis_)};
  one.slips =
      std::make_unique<SlipFinder>(mechanism_, one.closed->which(), search, one.closed->motions());
  if (one.closed->is_plain() && one.slips->is_able()) {
    by_converter_ = std::move(one);
  }
}

}  // namespace kinestat
