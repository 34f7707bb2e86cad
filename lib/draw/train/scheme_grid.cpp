#include "draw/train/scheme_grid.hpp"

#include <algorithm>
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

}  // namespace

SchemeGrid::SchemeGrid(const SchemeTrain& train,
                       const SchemeRadii& radii,
                       const SchemeColumns& columns)
    : train_(train), radii_(radii), columns_(columns) {
  make_tracks();
  make_rows();
}

void SchemeGrid::make_tracks() {
  int track = kEndTracks;
  for (int c = 0; c < columns_.count; ++c) {
    if (c > 0) {
      const bool is_same = columns_.set_of[at(c)] == columns_.set_of[at(c - 1)];
      track += is_same ? kColumnTracks : kSetTracks;
    }
    centres_.push_back(track + 1);
    track += 3;
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
  find_scale();
  std::vector<double> fixed;
  for (int w = 0; w < static_cast<int>(train_.wheels.size()); ++w) {
    fixed.push_back(high(w));
    if (train_.wheels[at(w)].planet >= 0) {
      fixed.push_back(low(w));
      fixed.push_back(pin(train_.wheels[at(w)].planet));
    }
  }
  std::ranges::sort(fixed);
  heights_.push_back(0.0);
  for (const double height : fixed) {
    add_rows_up_to(height);
  }
  inner_rows_ = row_count();
  for (int i = 0; i < kOuterRows; ++i) {
    heights_.push_back(heights_.back() + kTrack);
  }
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
  return columns_.last[at(wheel)] >= 0;
}

int SchemeGrid::left_face(int wheel) const {
  return centre(columns_.first[at(wheel)]) - 1;
}

int SchemeGrid::right_face(int wheel) const {
  return centre(columns_.last[at(wheel)]) + 1;
}

void SchemeGrid::close_up(const std::vector<bool>& is_used_track,
                          const std::vector<bool>& is_used_row) {
  double x = 0.0;
  for (int track = 0; track < track_count_; ++track) {
    const bool is_centre = std::ranges::find(centres_, track) != centres_.end();
    const bool is_after = std::ranges::find(centres_, track - 1) != centres_.end();
    const bool is_before = std::ranges::find(centres_, track + 1) != centres_.end();
    x += is_centre || is_after      ? kFace
         : is_before                ? 5.0
         : is_used_track[at(track)] ? kTrack
                                    : kUnusedTrack;
    x_.push_back(x);
  }
  for (int row = inner_rows_; row < row_count(); ++row) {
    heights_[at(row)] = heights_[at(row - 1)] + (is_used_row[at(row)] ? kTrack : 1.0);
  }
  heights_.back() += 6.0;
}

PixelPoint SchemeGrid::place(GridCell cell) const {
  const int column = std::clamp(cell.column, 0, track_count_ - 1);
  const int row = std::min(cell.row, row_count() - 1);
  PixelPoint p = {.x = x_[at(column)], .y = -heights_[at(row)]};
  p.x += kTrack * (cell.column - column);
  p.y -= kTrack * (cell.row - row);
  return p;
}

}  // namespace kinestat
