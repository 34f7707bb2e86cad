#include "draw/train/scheme_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/index.hpp"

namespace kinestat {

namespace {

// Tracks of the grid at the ends, between sets, and between columns of one set.
constexpr int kEndTracks = 16;
constexpr int kSetTracks = 13;
constexpr int kColumnTracks = 6;
constexpr int kOuterRows = 11;

constexpr double kTrack = 12.0;       // between tracks that are used [px]
constexpr double kUnusedTrack = 1.5;  // and others
constexpr double kFace = 13.0;        // half the width of a wheel
constexpr double kRow = 9.5;          // least distance of rows
constexpr double kUsualHeight = 200.0;
constexpr double kLeastSun = 42.0;
constexpr double kMostHeight = 300.0;

// Likewise of a developed section.
constexpr int kPlaneTracks = 13;
constexpr double kNarrowTrack = 8.0;
constexpr double kNarrowFace = 9.0;
constexpr double kLinkTrack = 7.0;
constexpr std::array kNearRows = {6.0, 15.0, 24.0, 33.0, 42.0, 51.0};
constexpr double kSameRow = 4.0;
constexpr int kFewOuterRows = 6;

}  // namespace

SchemeGrid::SchemeGrid(const SchemeTrain& train,
                       const SchemeRadii& radii,
                       const SchemeColumns& columns)
    : train_(train), radii_(radii), columns_(columns) {
  make_tracks();
  find_scale();
  make_rows();
}

SchemeGrid::SchemeGrid(const SchemeTrain& train,
                       const SchemeRadii& radii,
                       const SchemeColumns& columns,
                       const SchemeAxisView& view)
    : train_(train),
      radii_(radii),
      columns_(columns),
      is_developed_(true),
      axis_(view.axis),
      base_(view.scale * radii.axes[at(view.axis)]),
      scale_(view.scale) {
  make_tracks();
  make_rows();
}

void SchemeGrid::make_tracks() {
  int track = kEndTracks;
  for (int c = 0; c < columns_.count; ++c) {
    if (c > 0) {
      const bool is_same = columns_.set_of[at(c)] == columns_.set_of[at(c - 1)];
      track += is_developed_ ? kPlaneTracks : is_same ? kColumnTracks : kSetTracks;
    }
    centres_.push_back(track + 1);
    track += 3 + columns_.links[at(c)];
  }
  track_count_ = track + kEndTracks;
}

double SchemeGrid::low(int wheel) const {
  const SchemeWheel& of = train_.wheels[at(wheel)];
  return scale_ * (radii_.planets[at(of.planet)] - radii_.wheels[at(wheel)]);
}

double SchemeGrid::high(int wheel) const {
  const SchemeWheel& of = train_.wheels[at(wheel)];
  const double radius = radii_.wheels[at(wheel)];
  return scale_ * (of.planet < 0 ? radius : radii_.planets[at(of.planet)] + radius);
}

double SchemeGrid::pin(int planet) const {
  return scale_ * radii_.planets[at(planet)];
}

void SchemeGrid::find_scale() {
  double highest = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
    highest = std::max(highest, high(w));
    if (train_.wheels[at(w)].planet < 0 && !train_.wheels[at(w)].is_ring) {
      least = std::min(least, radii_.wheels[at(w)]);
    }
  }
  scale_ = std::min(std::max(kUsualHeight / highest, kLeastSun / least), kMostHeight / highest);
}

// Rows at all wheels and pins, and as many between them as lines may lie beside each other.
void SchemeGrid::make_rows() {
  std::vector<double> fixed;
  for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
    if (is_developed_ && (!is_placed(w) || is_whole(train_, w))) {
      continue;
    }
    fixed.push_back(high(w));
    if (train_.wheels[at(w)].planet >= 0) {
      fixed.push_back(low(w));
      fixed.push_back(pin(train_.wheels[at(w)].planet));
    }
  }
  std::ranges::sort(fixed);
  heights_.push_back(0.0);
  if (is_developed_) {
    add_near_rows(fixed);
  }
  for (const double height : fixed) {
    add_rows_up_to(height);
  }
  inner_rows_ = row_count();
  const int outer_rows = is_developed_ ? kFewOuterRows : kOuterRows;
  for (int i = 0; i < outer_rows; ++i) {
    heights_.push_back(heights_.back() + kTrack);
  }
}

// Those of shafts round each other, but for what the wheels have there.
void SchemeGrid::add_near_rows(std::vector<double>& fixed) const {
  for (const double near : kNearRows) {
    const bool is_there = std::ranges::any_of(
        fixed, [near](double height) { return std::abs(height - near) < kSameRow; });
    if (!is_there) {
      fixed.push_back(near);
    }
  }
  std::ranges::sort(fixed);
}

void SchemeGrid::add_rows_up_to(double height) {
  const double from = heights_.back();
  const int more = static_cast<int>((height - from) / kRow);
  for (int i = 1; i <= more; ++i) {
    heights_.push_back(from + (height - from) * i / more);
  }
  if (more == 0 && height - from > 1.0) {
    heights_.push_back(height);
  }
}

int SchemeGrid::row_at(double height) const {
  int best = 0;
  for (int row = 0; row < inner_rows_; ++row) {
    if (std::abs(heights_[at(row)] - height) < std::abs(heights_[at(best)] - height)) {
      best = row;
    }
  }
  return best;
}

bool SchemeGrid::is_placed(int wheel) const {
  return columns_.last[at(wheel)] >= 0 && train_.wheels[at(wheel)].axis == axis_;
}

int SchemeGrid::left_face(int wheel) const {
  return centre(columns_.first[at(wheel)]) - 1;
}

int SchemeGrid::right_face(int wheel) const {
  return centre(columns_.last[at(wheel)]) + 1;
}

// From the track before.
double SchemeGrid::track_width(int track, bool is_used) const {
  const auto is_at = [&](int centre) {
    return std::ranges::find(centres_, centre) != centres_.end();
  };
  if (is_at(track) || is_at(track - 1)) {
    return is_developed_ ? kNarrowFace : kFace;
  }
  if (is_at(track + 1)) {
    return 5.0;
  }
  for (std::size_t c = 0; c < centres_.size(); ++c) {
    if (track > centres_[c] + 1 && track <= centres_[c] + 1 + columns_.links[c]) {
      return kLinkTrack;
    }
  }
  return !is_used ? kUnusedTrack : is_developed_ ? kNarrowTrack : kTrack;
}

void SchemeGrid::close_up(const std::vector<bool>& is_used_track,
                          const std::vector<bool>& is_used_row) {
  double x = 0.0;
  for (int track = 0; track < track_count_; ++track) {
    x += track_width(track, is_used_track[at(track)]);
    x_.push_back(x);
  }
  if (is_developed_) {
    return;
  }
  for (int row = inner_rows_; row < row_count(); ++row) {
    heights_[at(row)] = heights_[at(row - 1)] + (is_used_row[at(row)] ? kTrack : 1.0);
  }
  heights_.back() += 6.0;
}

PixelPoint SchemeGrid::place(GridCell cell) const {
  const int column = std::clamp(cell.column, 0, track_count_ - 1);
  const int row = std::min(cell.row, row_count() - 1);
  PixelPoint p = {.x = x_[at(column)], .y = -base_ - heights_[at(row)]};
  p.x += kTrack * (cell.column - column);
  p.y -= kTrack * (cell.row - row);
  return p;
}

}  // namespace kinestat
