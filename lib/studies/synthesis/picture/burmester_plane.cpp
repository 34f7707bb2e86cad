#include "studies/synthesis/picture/burmester_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/synthesis_tolerance.hpp"

namespace kinestat {

namespace {

Point turn_of(const PositionJets& position) {
  return std::polar(1.0, position.angle.front());
}

// The point about which the displacement between two positions turns; empty if it only translates.
std::optional<Point> pole_between(const PositionJets& one, const PositionJets& other) {
  const Point difference = turn_of(one) - turn_of(other);
  if (std::abs(difference) <= kSameAngle) {
    return std::nullopt;
  }
  const Point moving = (origin(other) - origin(one)) / difference;
  return turn_of(one) * moving + origin(one);
}

// Without the last condition of one group.
std::vector<PositionJets> reduced(std::vector<PositionJets> positions, std::size_t group) {
  PositionJets& one = positions[group];
  if (one.order() == 1) {
    positions.erase(positions.begin() + static_cast<std::ptrdiff_t>(group));
    return positions;
  }
  one.x.pop_back();
  one.y.pop_back();
  one.angle.pop_back();
  return positions;
}

class PlaneFinder {
 public:
  explicit PlaneFinder(const SynthesisTask& task)
      : task_(task), first_(pose_of(task.positions.front())) {}

  BurmesterPlane find() {
    add_poles();
    add_dyads();
    add_curves();
    add_circle();
    find_window();
    return std::move(result_);
  }

 private:
  void add_poles() {
    const std::vector<PositionJets>& positions = task_.positions;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (const auto pole = find_pole(positions[i])) {
        result_.poles.push_back({.name = fmt::format("P{}", i + 1), .at = *pole});
      }
      for (std::size_t j = i + 1; j < positions.size(); ++j) {
        if (const auto pole = pole_between(positions[i], positions[j])) {
          result_.poles.push_back({.name = fmt::format("P{}{}", i + 1, j + 1), .at = *pole});
        }
      }
    }
  }

  void add_dyad(const Dyad& dyad, bool is_chosen) {
    DrawnDyad drawn{.dyad = dyad,
                    .letter = static_cast<char>('A' + result_.dyads.size()),
                    .circle_point = first_.place(dyad.circle_point),
                    .centre_point = dyad.centre_point,
                    .direction = dyad.direction,
                    .is_chosen = is_chosen};
    if (dyad.kind == DyadKind::inverted_slider) {
      drawn.direction = dyad.direction * std::polar(1.0, first_.angle);
    }
    result_.dyads.push_back(drawn);
  }

  bool is_known(const Dyad& dyad) const {
    return std::ranges::any_of(result_.dyads,
                               [&](const DrawnDyad& other) { return is_same(other.dyad, dyad); });
  }

  // Those of the best linkage first.
  void add_dyads() {
    if (!task_.linkages.empty()) {
      add_dyad(task_.linkages.front().linkage.one, true);
      add_dyad(task_.linkages.front().linkage.other, true);
    }
    if (task_.dyads) {
      for (const Dyad& dyad : task_.dyads->dyads) {
        if (!is_known(dyad)) {
          add_dyad(dyad, false);
        }
      }
    }
  }

  void add_curves() {
    if (task_.curves) {
      add_curves(*task_.curves, task_.positions, "");
      return;
    }
    const std::vector<PositionJets>& positions = task_.positions;
    if (position_count(positions) != 5) {
      return;
    }
    // Any group but a first one of a single position may lose a condition: places of circle points
    // are those at the first position.
    for (std::size_t i = positions.size(); i-- > 0 && result_.curves.size() < 2;) {
      if (i > 0 || positions[i].order() > 1) {
        const int order = positions[i].order();
        const std::string which = std::to_string(i + 1);
        const std::vector<PositionJets> four = reduced(positions, i);
        add_curves(find_curves(four),
                   four,
                   order == 1 ? which : fmt::format("the last condition of {}", which));
      }
    }
  }

  void add_curves(FourPositionCurves curves,
                  std::vector<PositionJets> positions,
                  std::string without) {
    if (curves.status == BurmesterStatus::solved) {
      result_.curves.push_back({.curves = std::move(curves),
                                .positions = std::move(positions),
                                .without = std::move(without)});
    }
  }

  void add_circle() {
    if (task_.straight_paths) {
      result_.circle = task_.straight_paths;
      result_.circle_name = "straight paths";
      return;
    }
    const PositionJets& one = task_.positions.front();
    if (one.order() < 3) {
      return;
    }
    if (const auto frame = find_special_frame(one)) {
      result_.circle = inflection_circle(*frame);
      result_.circle_name = "inflection circle";
      result_.ball = find_ball_point(*frame);
    }
  }

  // Adds the points of a dyad that are no further from the middle than `far`. Where positions lie
  // close to each other, the best linkage may be far outside them: of it, both points are added
  // unless one is kFarOfClose times as far away as the other.
  static void add_reached(const DrawnDyad& dyad,
                          const Point& middle,
                          double far,
                          std::vector<Point>& points) {
    constexpr double kFarOfClose = 12.0;
    const std::array<Point, 2> ends = {dyad.circle_point, dyad.centre_point};
    const double near = std::min(std::abs(ends[0] - middle), std::abs(ends[1] - middle));
    for (const Point& p : ends) {
      if (std::abs(p - middle) <= std::max(far, dyad.is_chosen ? kFarOfClose * near : 0.0)) {
        points.push_back(p);
      }
    }
  }

  // The window shows all positions. Other dyads and poles are shown within kFar times the spread of
  // the positions around their middle, the best linkage within three times as far. The factors are
  // chosen by eye.
  void find_window() {
    constexpr double kFar = 3.5;
    constexpr double kMarginShare = 0.18;  // of the larger side, on each side
    constexpr double kLeastShape = 0.6;    // shorter side over longer side
    std::vector<Point> points;
    for (const PositionJets& position : task_.positions) {
      points.push_back(origin(position));
      if (const auto pole = find_pole(position)) {
        points.push_back(*pole);
      }
    }
    Point middle(0.0, 0.0);
    for (const Point& p : points) {
      middle += p / static_cast<double>(points.size());
    }
    double spread = 0.0;
    for (const Point& p : points) {
      spread = std::max(spread, std::abs(p - middle));
    }
    for (const bool is_chosen : {true, false}) {
      for (const DrawnDyad& dyad : result_.dyads) {
        if (dyad.is_chosen == is_chosen) {
          add_reached(dyad, middle, (is_chosen ? 3.0 * kFar : kFar) * spread, points);
        }
      }
    }
    for (const NamedPoint& pole : result_.poles) {
      if (std::abs(pole.at - middle) <= kFar * spread) {
        points.push_back(pole.at);
      }
    }
    Point low = points.front();
    Point high = points.front();
    for (const Point& p : points) {
      low = {std::min(low.real(), p.real()), std::min(low.imag(), p.imag())};
      high = {std::max(high.real(), p.real()), std::max(high.imag(), p.imag())};
    }
    double size = std::max((high - low).real(), (high - low).imag());
    size = size > 0.0 ? size : 1.0;
    const double most = (1.0 + 2 * kMarginShare) * size;
    const auto side = [&](double extent) {
      return std::max(extent + 2 * kMarginShare * size, kLeastShape * most);
    };
    const Point half = Point(side((high - low).real()), side((high - low).imag())) / 2.0;
    const Point centre = (low + high) / 2.0;
    result_.window = {.low = centre - half, .high = centre + half};
  }

  const SynthesisTask& task_;
  Pose first_;
  BurmesterPlane result_;
};

// Whether a crank that turns one way comes through finitely separated positions as they are
// numbered. Of others nothing is said.
bool passes_in_order(const Dyad& dyad, const std::vector<PositionJets>& positions) {
  const bool is_finite =
      std::ranges::all_of(positions, [](const PositionJets& one) { return one.order() == 1; });
  if (dyad.kind != DyadKind::crank || !is_finite) {
    return true;
  }
  // From each position to the next and back to the first, anticlockwise: one turn in all if they
  // follow each other so, all turns but one if clockwise.
  double turns = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto arm = [&](std::size_t k) {
      return pose_of(positions[k]).place(dyad.circle_point) - dyad.centre_point;
    };
    const double angle = std::arg(arm((i + 1) % positions.size()) / arm(i));
    turns += (angle < 0.0 ? angle + 2 * std::numbers::pi : angle) / (2 * std::numbers::pi);
  }
  const auto count = static_cast<double>(positions.size());
  return std::round(turns) <= 1.0 || std::round(turns) >= count - 1.0;
}

}  // namespace

BurmesterPlane find_plane(const SynthesisTask& task) {
  return PlaneFinder(task).find();
}

std::string find_rejection(const std::vector<PositionJets>& positions,
                           const LinkageLimits& limits,
                           const std::optional<Dyad>& partner,
                           const Point& circle_point) {
  const std::optional<Dyad> dyad = find_dyad(positions, circle_point);
  if (!dyad) {
    return "no centre";
  }
  if (!partner) {
    const bool is_large = dyad->kind == DyadKind::crank && dyad->length > limits.size;
    const auto is_outside = [&](DyadPoint which) {
      return distance_outside(*dyad, which, limits) > 0.0;
    };
    const Defect defect = !passes_in_order(*dyad, positions)    ? Defect::order
                          : is_outside(DyadPoint::centre_point) ? Defect::centre_point
                          : is_outside(DyadPoint::circle_point) ? Defect::circle_point
                          : is_large                            ? Defect::size
                                                                : Defect::none;
    return defect == Defect::none ? "" : std::string(word_of(defect));
  }
  // A crank of the curve makes a four-bar also where the task asks for a slider.
  LinkageLimits of_any_type = limits;
  of_any_type.type.reset();
  const std::array<Dyad, 2> pair = {*partner, *dyad};
  const std::vector<LinkageCandidate> found = rank_linkages(pair, positions, of_any_type);
  return found.front().is_usable() ? "" : std::string(word_of(found.front().defect()));
}

bool is_same(const Dyad& one, const Dyad& other) {
  return one.kind == other.kind && one.circle_point == other.circle_point &&
         one.centre_point == other.centre_point;
}

}  // namespace kinestat
