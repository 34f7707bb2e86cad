// The search among the stationary ratios of one layout with roles of its sets.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "studies/transmissions/search.hpp"
#include "studies/transmissions/stationary_axes.hpp"

namespace kinestat {

/// A layout with what every choice of roles asks of it.
struct SearchedLayout {
  TransmissionLayout layout;
  std::vector<std::uint32_t> states;  ///< of its gears
  std::vector<SetAction> actions;     ///< of its automorphisms
  LadderWalk walk;
};

/// What became of a layout with roles of its sets.
enum class LabelledOutcome {
  refuted,        ///< no ladder
  undecided,      ///< ranges too narrow, or too many
  not_buildable,  ///< ladders, but no placement of the elements that can be built as asked
  over_limits,    ///< ladders, of which all exceed limits
  found
};

class LabelledSearch {
 public:
  LabelledSearch(const TransmissionTask& task,
                 const GenericTrain& train,
                 const SearchedLayout& layout,
                 const RoleChoice& choice);

  /// Looks at all points of lists, and for one of ranges, which it then betters by the rank.
  LabelledOutcome run();

  const FoundTransmission& best() const { return best_; }

  /// Whether it finds one, with at most so many parts of ranges looked at beside some points.
  bool has_any(int most_parts);

  /// Whether that were too few.
  bool is_given_up() const { return !is_found_ && parts_left_ < 0; }

  /// How many parts were looked at.
  std::uint64_t parts() const { return parts_; }

 private:
  struct Placement {
    ElementPlacement elements;
    std::uint64_t parts = 0;  // rotating clutches and, where they are asked for, hollow shafts
  };

  void search(const StationaryPart& part);
  void try_corners(const StationaryPart& part);
  void try_samples();
  void refine();
  bool may_have_ladder(const StationaryPart& part);
  bool is_least(const StationaryPart& part, std::size_t corner) const;
  bool try_point(const StationaryPoint& point);
  bool try_ratios(const StationaryPoint& point, std::span<const double> ratios);
  bool try_ladder(const StationaryPoint& point,
                  std::span<const double> ratios,
                  const Ladder& ladder);
  bool choose_placement(FoundTransmission& candidate) const;

  bool counts_parts() const { return task_.rank == TransmissionRank::elements; }

  double mean_loss(const Ladder& ladder) const;

  std::size_t forward_gears() const { return static_cast<std::size_t>(task_.ladder.forward); }

  std::vector<double> planet_turns(const StationaryPoint& point) const;
  StationaryPoint neighbour(StationaryPoint point, std::size_t set, double step) const;
  void find_placements();
  void find_losses(const StationaryPoint& point);

  const TransmissionTask& task_;
  const GenericTrain& train_;
  const SearchedLayout& layout_;
  RoleChoice choice_;
  StationaryAxes axes_;
  RatioTable table_;
  std::optional<std::vector<Placement>> placements_;  // that can be built as asked
  bool has_too_many_parts_ = false;                   // one that could be arranged
  std::vector<GearLosses> losses_;
  int parts_left_;
  std::uint64_t parts_ = 0;
  bool needs_one_ = false;
  bool has_ladder_ = false;
  bool is_found_ = false;
  FoundTransmission best_;
};

}  // namespace kinestat
