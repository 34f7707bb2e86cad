// How one value of a motion is followed to a place between steps where it is greatest.
#pragma once

#include <array>
#include <optional>

namespace kinestat {

/// A value at a share of the ranges of the drives, with its sign turned where the least is looked
/// for.
struct PeakSample {
  double share = 0.0;
  double value = 0.0;
};

/// Between which values lie that are folded there, as an angle at 0 and 90 degrees: they come to
/// the fold, and leave it, in straight lines.
struct ValueFolds {
  double least = 0.0;
  double greatest = 0.0;
};

/// Of three positions, one after the other.
using PeakTriple = std::array<PeakSample, 3>;

/// A climb from three steps to the peak among them: by the vertices of parabolas, where these come
/// no nearer by where the lines of both sides meet and by golden sections; or to the place where a
/// value is folded, as an angle at 90 degrees, to which it comes in straight lines from both sides.
class PeakClimb {
 public:
  PeakClimb() = default;
  PeakClimb(const PeakTriple& steps, const std::optional<double>& fold);

  /// Between two steps, by what is promised there.
  PeakClimb(const PeakSample& before,
            const PeakSample& promise,
            const PeakSample& behind,
            const std::optional<double>& fold);

  /// Where to look next, and what is promised there. Empty where the last value was as promised, or
  /// nothing is.
  const std::optional<PeakSample>& promise() const { return promise_; }

  /// The value there.
  void take(double value);

  const PeakSample& best() const { return best_; }

  /// Whether nothing but a polynomial speaks for it.
  bool is_guess() const { return is_between_steps_; }

 private:
  // What the best position is below the fold, how fast that changes, and on which side the fold is
  // thought to be.
  struct Fold {
    double below = 0.0;
    double slope = 0.0;
    double side = 1.0;
    bool is_from_best = false;  // the last trial began there
    bool has_tried_both = false;
  };

  void aim();
  void aim_at_vertex();
  std::optional<PeakSample> corner() const;
  void aim_at_fold();
  void approach_fold(const PeakSample& before, const PeakSample& next);
  void narrow(const PeakSample& next);

  PeakTriple by_ = {};
  std::array<std::optional<PeakSample>, 2> outer_ = {};  // the last ones before and behind these
  double last_way_ = 0.0;                                // of the last trial from the middle
  double way_before_ = 0.0;                              // of that before; 0: none yet
  bool is_between_steps_ = false;                        // nothing is known in the middle yet
  bool has_tried_corner_ = false;                        // since the last golden section
  PeakSample best_;
  std::optional<PeakSample> promise_;
  std::optional<double> height_;  // of the fold that there may be
  std::optional<Fold> fold_;      // while that is where it goes
  double extent_ = 0.0;           // between which values it climbs
  int trials_ = 0;
};

/// By more than rounding, which must not decide between what is equal.
bool is_higher(double value, double than);

}  // namespace kinestat
