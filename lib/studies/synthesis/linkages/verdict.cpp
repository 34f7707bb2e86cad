#include "studies/synthesis/linkages/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "core/contract.hpp"
#include "core/synthesis_tolerance.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// What the input meets at an end of its argument: nothing, so that it goes on; a change point,
// where everything meets; a dead point, where it turns back; infinity.
enum class End { free, change_point, dead_point, infinity };

// Which of the four kinds of poses are connected: side 1 or -1, x above or below zero. A change
// point at zero has the sign of its half.
class Connections {
 public:
  int operator()(int side, double x) const { return label_[index(side, x)]; }

  void join_halves() {
    join(0, 2);
    join(1, 3);
  }

  void join_sides() {
    join(0, 1);
    join(2, 3);
  }

  void join_at(End end) {
    if (end == End::free || end == End::change_point) {
      join_halves();
    }
    if (end == End::dead_point || end == End::change_point) {
      join_sides();
    }
  }

 private:
  static std::size_t index(int side, double x) {
    return (std::signbit(x) ? 2U : 0U) + (side < 0 ? 1U : 0U);
  }

  void join(std::size_t a, std::size_t b) {
    const int from = std::max(label_[a], label_[b]);
    const int to = std::min(label_[a], label_[b]);
    std::ranges::replace(label_, from, to);
  }

  std::array<int, 4> label_ = {1, 2, 3, 4};
};

bool is_equal(const std::vector<int>& all) {
  return std::ranges::all_of(all, [&](int one) { return one == all.front(); });
}

class Judge {
 public:
  Judge(const Linkage& linkage, Drive drive, std::span<const PositionJets> positions, int sense)
      : curve_(linkage, drive), positions_(positions), sense_(sense), range_(curve_.range()) {
    verdict_.drive = drive;
    find_ends();
  }

  DriveVerdict run() {
    make_room();
    for (const PositionJets& position : positions_) {
      const Pose pose = pose_of(position);
      verdict_.coordinates.push_back(curve_.coordinate_of(pose));
      const DriveCurve::Transmission transmission = curve_.transmission_of(pose);
      verdict_.transmission.push_back(transmission.angle);
      sides_.push_back(transmission.side);
    }
    place_dead_points();
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      verdict_.circuits.push_back(circuits_(sides_[i], verdict_.coordinates[i]));
      verdict_.branches.push_back(branches_(sides_[i], verdict_.coordinates[i]));
    }
    if (circuits_(1, -1.0) != circuits_(1, 1.0) || circuits_(-1, 1.0) != circuits_(1, 1.0)) {
      verdict_.mirror = verdict_.circuits.front() == circuits_(1, 1.0) ? 1 : -1;
    }
    verdict_.same_circuit = is_equal(verdict_.circuits);
    verdict_.same_branch = is_equal(verdict_.branches);
    verdict_.turns_fully = curve_.is_cyclic() && !bounds(zero_end_) && !bounds(far_end_);
    verdict_.full = range_between(range_.low_transmission, range_.high_transmission);
    if (verdict_.same_circuit && verdict_.same_branch) {
      find_passage();
    }
    if (verdict_.passage != Passage::none) {
      verdict_.working_arc = range_of_arc(verdict_.arc);
    }
    return std::move(verdict_);
  }

 private:
  static bool bounds(End end) { return end != End::free; }

  void make_room() {
    verdict_.coordinates.reserve(positions_.size());
    verdict_.transmission.reserve(positions_.size());
    verdict_.circuits.reserve(positions_.size());
    verdict_.branches.reserve(positions_.size());
    sides_.reserve(positions_.size());
  }

  // The ends of the argument: of a cosine at x = 0 and x = π; of a square at x = 0 and far away; of
  // x itself both far away. Circuits go round dead points, branches end there.
  void find_ends() {
    using enum DriveCurve::Argument;
    const End far_away = std::isfinite(range_.high) ? End::dead_point : End::infinity;
    switch (curve_.argument()) {
      case cosine:
        zero_end_ = curve_.is_open_ended() ? End::infinity : end_at(0.0);
        far_end_ = curve_.is_open_ended() ? End::infinity : end_at(std::numbers::pi);
        break;
      case square:
        zero_end_ = end_at(0.0);
        far_end_ = far_away;
        break;
      case linear:
        far_end_ = far_away;
        break;
      case none:
        branches_.join_sides();
        circuits_.join_sides();
        break;
    }
    circuits_.join_at(zero_end_);
    circuits_.join_at(far_end_);
    if (zero_end_ == End::free || (far_end_ == End::free && curve_.is_cyclic())) {
      branches_.join_halves();
    }
  }

  // A position in a dead point ends the branches on both sides, one in a change point also those of
  // both halves: it counts to that of the position before it, or behind it where there is none.
  void place_dead_points() {
    const auto first = std::ranges::find_if(sides_, [](int side) { return side != 0; });
    if (first == sides_.end()) {
      return;
    }
    auto neighbour = static_cast<std::size_t>(first - sides_.begin());
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (sides_[i] == 0) {
        sides_[i] = sides_[neighbour];
        double& x = verdict_.coordinates[i];
        if (nearer_end(x) == End::change_point) {
          x = std::copysign(x, verdict_.coordinates[neighbour]);
        }
      }
      neighbour = std::max(neighbour, i);
    }
  }

  End nearer_end(double x) const {
    return std::abs(x) - range_.low < range_.high - std::abs(x) ? zero_end_ : far_end_;
  }

  // |cos μ| below one, one, or beyond reach.
  End end_at(double x) const {
    const double reserve = curve_.reserve(x);
    if (std::abs(reserve) < kChangePoint) {
      return End::change_point;
    }
    return reserve > 0.0 ? End::free : End::dead_point;
  }

  // The coordinate without the jump: on a branch that does not contain x = 0 angles run from 0.
  double unrolled(double x) const {
    return curve_.is_cyclic() && bounds(zero_end_) && std::signbit(x) ? x + 2.0 * std::numbers::pi
                                                                      : x;
  }

  // Whether no other sense is asked for, nor by derivatives that have one.
  bool allows(int sense) const {
    return sense_ != -sense && std::ranges::all_of(positions_, [&](const PositionJets& position) {
             return !position.is_directed || position.order() < 2 ||
                    curve_.sense_of(position) != -sense;
           });
  }

  void find_passage() {
    std::vector<double> x = verdict_.coordinates;
    if (!verdict_.turns_fully) {
      std::ranges::transform(x, x.begin(), [&](double one) { return unrolled(one); });
      find_monotone(x);
      return;
    }
    const double forward = turn(x, 1.0);
    const double backward = turn(x, -1.0);
    const bool goes_forward = forward < 2.0 * std::numbers::pi && allows(1);
    const bool goes_backward = backward < 2.0 * std::numbers::pi && allows(-1);
    if (goes_forward) {
      set_passage(Passage::increasing, forward);
    }
    if (goes_backward && (!goes_forward || is_better_way(-backward, forward))) {
      set_passage(Passage::decreasing, -backward);
    }
  }

  // Of two ways, which only two positions leave open, the one that transmits better; of those that
  // are equal but for rounding, the shorter.
  bool is_better_way(double arc, double other) const {
    const double margin = range_of_arc(arc).margin();
    const double other_margin = range_of_arc(other).margin();
    return std::abs(margin - other_margin) > kSameValue ? margin > other_margin
                                                        : std::abs(arc) < std::abs(other);
  }

  // How far the input turns from the first position to the last in one sense.
  static double turn(const std::vector<double>& x, double sense) {
    double sum = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double step = sense * (x[i] - x[i - 1]);
      sum += step - 2.0 * std::numbers::pi * std::floor(step / (2.0 * std::numbers::pi));
    }
    return sum;
  }

  void find_monotone(const std::vector<double>& x) {
    const double arc = x.back() - x.front();
    if (std::ranges::is_sorted(x) && allows(1)) {
      set_passage(Passage::increasing, arc);
    } else if (std::ranges::is_sorted(x, std::greater<>()) && allows(-1)) {
      set_passage(Passage::decreasing, arc);
    }
  }

  void set_passage(Passage passage, double arc) {
    verdict_.passage = passage;
    verdict_.arc = arc;
  }

  static TransmissionRange range_between(double one, double other) {
    return {.least = std::min(one, other), .most = std::max(one, other)};
  }

  static void include(TransmissionRange& range, double angle) {
    range.least = std::min(range.least, angle);
    range.most = std::max(range.most, angle);
  }

  // cos μ is monotone in the argument, so that it is extreme at the ends and where the argument is.
  TransmissionRange range_of_arc(double arc) const {
    const double from = unrolled(verdict_.coordinates.front());
    const double to = from + arc;
    const double low = std::min(from, to);
    const double high = std::max(from, to);
    TransmissionRange range =
        range_between(verdict_.transmission.front(), verdict_.transmission.back());
    if (curve_.argument() == DriveCurve::Argument::cosine) {
      for (double x = std::numbers::pi * std::ceil(low / std::numbers::pi); x <= high;
           x += std::numbers::pi) {
        include(range, curve_.transmission(x));
      }
    } else if (low < 0.0 && high > 0.0) {
      include(range, curve_.transmission(0.0));
    }
    return range;
  }

  DriveCurve curve_;
  std::span<const PositionJets> positions_;
  int sense_ = 0;
  DriveCurve::Range range_;
  End zero_end_ = End::free;
  End far_end_ = End::free;
  Connections circuits_;
  Connections branches_;
  std::vector<int> sides_;
  DriveVerdict verdict_;
};

}  // namespace

std::string_view word_of(Passage passage) {
  switch (passage) {
    case Passage::none:
      return "none";
    case Passage::increasing:
      return "increasing";
    case Passage::decreasing:
      return "decreasing";
  }
  return "";
}

double TransmissionRange::margin() const {
  return std::numbers::pi / 2 -
         std::max(std::abs(least - std::numbers::pi / 2), std::abs(most - std::numbers::pi / 2));
}

DriveVerdict find_verdict(const Linkage& linkage,
                          Drive drive,
                          std::span<const PositionJets> positions,
                          int sense) {
  KINESTAT_EXPECTS(!positions.empty());
  return Judge(linkage, drive, positions, sense).run();
}

}  // namespace kinestat
