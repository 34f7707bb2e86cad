#include "studies/sweep/motion/lane_motions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/motion_tolerance.hpp"
#include "expression/file_units.hpp"
#include "mechanism/label_kind.hpp"
#include "studies/motion/task/figures/finer_rows.hpp"
#include "studies/motion/task/motion_events.hpp"

namespace kinestat {

namespace {

bool depends(const std::optional<Value>& value,
             const MechanismDescription& description,
             const std::vector<bool>& varies) {
  if (!value) {
    return false;
  }
  return std::ranges::any_of(value->expression.nodes(), [&](const Node& node) {
    const auto at = std::ranges::find(
        description.parameters,
        node.kind == NodeKind::name ? value->expression.text_of(node) : std::string_view(),
        [](const ParameterDescription& one) { return std::string_view(one.name.text); });
    return at != description.parameters.end() &&
           varies[static_cast<std::size_t>(at - description.parameters.begin())];
  });
}

bool moves_alike(const MechanismDescription& description, const std::vector<bool>& varies) {
  const MotionDescription& motion = *description.motion;
  return !depends(motion.steps, description, varies) &&
         std::ranges::none_of(motion.drives, [&](const DriveRange& one) {
           return depends(one.from, description, varies) || depends(one.to, description, varies);
         });
}

// Of "d.wz/position" the freedom, or -1.
int freedom_of(std::string_view column, std::string_view quantity, const Topology& topology) {
  for (int f = 0; f < topology.freedom_count(); ++f) {
    const std::string name = topology.freedom_name(f);
    if (column.size() == name.size() + quantity.size() && column.starts_with(name) &&
        column.ends_with(quantity)) {
      return f;
    }
  }
  return -1;
}

std::size_t place_in(LaneQuestion& question, int freedom) {
  const auto at = std::ranges::find(question.places, freedom);
  const auto place = static_cast<std::size_t>(at - question.places.begin());
  if (at == question.places.end()) {
    question.places.push_back(freedom);
    question.sides.emplace_back();
    question.means.push_back(false);
  }
  return place;
}

void add_sides(LaneSides& all, MotionFigure figure) {
  const bool needs_both = figure == MotionFigure::range || figure == MotionFigure::peak;
  all.least = all.least || needs_both || figure == MotionFigure::least;
  all.greatest = all.greatest || needs_both || figure == MotionFigure::greatest;
}

}  // namespace

LaneMotions::LaneMotions(const FileUnits& units,
                         Rebinder rebinder,
                         Geometry geometry,
                         std::vector<Source> sources,
                         std::vector<bool> turns,
                         LaneFollower follower)
    : units_(&units),
      rebinder_(std::move(rebinder)),
      geometry_(std::move(geometry)),
      length_(geometry_.length),
      sources_(std::move(sources)),
      turns_(std::move(turns)),
      follower_(std::move(follower)) {}

std::optional<LaneMotions> LaneMotions::make(const MechanismDescription& description,
                                             const Mechanism& mechanism,
                                             const SweptMotion& asked,
                                             const std::vector<bool>& varies) {
  if (asked.cases.size() != 1) {
    return std::nullopt;
  }
  const MotionPlan plan = *bind_motion(description, mechanism, asked.case_of(0));
  if (plan.drives.size() != 1 || plan.schedule || !moves_alike(description, varies)) {
    return std::nullopt;
  }
  const PlannedDrive& drive = plan.drives.front();
  if (drive.until_limit) {
    return std::nullopt;
  }
  const MotionNetwork network = make_motion_network(
      mechanism, bind_drawn_couplings(description, mechanism), std::array<int, 1>{drive.freedom});
  std::optional<LaneLinkage> linkage = make_lane_linkage(mechanism, network);
  LaneQuestion question;
  question.drive = {.freedom = drive.freedom, .from = drive.from, .to = drive.to};
  question.steps = plan.steps * parts_of_step(mechanism, plan, plan.steps);
  std::vector<Source> sources;
  if (!linkage || !find_sources(mechanism, asked, network, question, sources)) {
    return std::nullopt;
  }
  std::optional<Rebinder> rebinder = Rebinder::make(description, mechanism, varies);
  if (!rebinder) {
    return std::nullopt;
  }
  std::vector<bool> turns;
  for (const int freedom : question.places) {
    turns.push_back(mechanism.topology.freedoms[static_cast<std::size_t>(freedom)].is_rotation);
  }
  return LaneMotions(description.units,
                     *std::move(rebinder),
                     mechanism.geometry,
                     std::move(sources),
                     std::move(turns),
                     LaneFollower(*std::move(linkage), std::move(question), mechanism.geometry));
}

// False where a figure is of something else.
bool LaneMotions::find_sources(const Mechanism& mechanism,
                               const SweptMotion& asked,
                               const MotionNetwork& network,
                               LaneQuestion& question,
                               std::vector<Source>& sources) {
  const Topology& topology = mechanism.topology;
  if (asked.scope.dead_points) {
    question.watched = watched_freedoms(mechanism, network);
  }
  for (const SweptFigure& one : asked.figures) {
    Source source;
    source.figure = one.figure;
    if (one.figure == MotionFigure::dead_points) {
      for (std::size_t w = 0; w < question.watched.size(); ++w) {
        if (one.column.empty() || topology.freedom_name(question.watched[w]) == one.column) {
          source.watched.push_back(w);
        }
      }
    } else if (const int f = freedom_of(one.column, "/position", topology); f >= 0) {
      const std::size_t place = place_in(question, f);
      source.place = static_cast<int>(place);
      question.means[place] = question.means[place] || one.figure == MotionFigure::mean;
      // Its dead points are its extremes between the steps.
      if (std::ranges::find(question.watched, f) == question.watched.end()) {
        add_sides(question.sides[place], one.figure);
      }
    } else if (one.column.ends_with("/transmission_angle") && one.figure != MotionFigure::mean) {
      const Case& which = mechanism.cases[static_cast<std::size_t>(asked.cases.front())];
      question.transmission =
          find_lane_transmission(mechanism, network, which.inputs.front(), which.outputs.front());
      if (!question.transmission) {
        return false;
      }
      add_sides(question.transmission_sides, one.figure);
    } else {
      return false;
    }
    sources.push_back(std::move(source));
  }
  return true;
}

bool LaneMotions::load(std::size_t lane, const Slots& slots) {
  if (!rebinder_.rebind_geometry(slots, geometry_)) {
    return false;
  }
  follower_.set(lane, geometry_);
  return true;
}

bool LaneMotions::fill(std::size_t lane,
                       std::span<const SweepColumn> columns,
                       SweepRow& row) const {
  if (!follower_.is_certain(lane)) {
    return false;
  }
  for (std::size_t q = 0; q < columns.size(); ++q) {
    const std::optional<double> value =
        value_of(sources_[static_cast<std::size_t>(columns[q].index)], lane);
    if (!value || !std::isfinite(*value)) {
      return false;
    }
    row.values[q] = *value;
  }
  row.status = "solved";
  return true;
}

// Empty where a value is so small that a bound must decide whether it is zero.
std::optional<double> LaneMotions::value_of(const Source& source, std::size_t lane) const {
  if (source.figure == MotionFigure::dead_points) {
    int count = 0;
    for (const std::size_t watched : source.watched) {
      count += follower_.dead_points(watched, lane);
    }
    return count;
  }
  const bool turns = source.place < 0 || turns_[static_cast<std::size_t>(source.place)];
  LaneExtremes all;
  if (source.place >= 0) {
    all = follower_.extremes(static_cast<std::size_t>(source.place), lane);
  } else {
    const std::array<double, 2> angles = follower_.transmission_angles(lane);
    all = {.least = angles[0], .greatest = angles[1], .mean = 0.0};
  }
  const double unit = turns ? 1.0 : length_;
  if (source.figure == MotionFigure::mean && std::abs(all.mean) <= kLeastCorrection * unit) {
    return std::nullopt;
  }
  for (double* one : {&all.least, &all.greatest}) {
    const double size = std::abs(*one) / unit;
    if (size <= kMotionClosure) {
      *one = 0.0;
    } else if (size <= kLeastCorrection) {
      return std::nullopt;
    }
  }
  const auto in_unit = [&](double value) { return units_->from_si(position_kind(turns), value); };
  switch (source.figure) {
    case MotionFigure::least:
      return in_unit(all.least);
    case MotionFigure::greatest:
      return in_unit(all.greatest);
    case MotionFigure::range:
      return in_unit(all.greatest) - in_unit(all.least);
    case MotionFigure::mean:
      return in_unit(all.mean);
    case MotionFigure::peak:
      return in_unit(std::max(std::abs(all.least), std::abs(all.greatest)));
    case MotionFigure::rms:  // of motions in time, which are none of these
    case MotionFigure::dead_points:
    case MotionFigure::overall_efficiency:
      break;
  }
  return std::nullopt;
}

}  // namespace kinestat
