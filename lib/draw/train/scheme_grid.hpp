// The grid of a section: tracks along an axis, rows outwards, and where wheels stand in it.
#pragma once

#include <vector>

#include "draw/svg.hpp"
#include "draw/train/scheme_radii.hpp"
#include "draw/train/scheme_router.hpp"

namespace kinestat {

/// One axis of a developed section; those of one section have the same tracks.
struct SchemeAxisView {
  int axis = 0;
  double scale = 1.0;  ///< [px] per unit of radius
};

/// Wheels are given by their index in the train, heights in pixels above the axis. The train and
/// the rest must outlive it.
class SchemeGrid {
 public:
  SchemeGrid(const SchemeTrain& train, const SchemeRadii& radii, const SchemeColumns& columns);

  /// Of a developed section, with rows near the axis for shafts round each other.
  SchemeGrid(const SchemeTrain& train,
             const SchemeRadii& radii,
             const SchemeColumns& columns,
             const SchemeAxisView& view);

  bool is_developed() const { return is_developed_; }

  int axis() const { return axis_; }

  /// The height of its axis above the main axis [px].
  double base() const { return base_; }

  int track_count() const { return track_count_; }

  int row_count() const { return static_cast<int>(heights_.size()); }

  /// Those up to the outermost wheel; their heights are to scale.
  int inner_row_count() const { return inner_rows_; }

  /// Of a planet, where it begins.
  double low(int wheel) const;

  /// Where a planet ends; of a wheel on the main axis its radius.
  double high(int wheel) const;

  /// Of the pin of a planet.
  double pin(int planet) const;

  /// The row that is nearest to a height.
  int row_at(double height) const;

  /// On this axis, or that of a planet that goes round it.
  bool is_placed(int wheel) const;

  /// Tracks of the ends of a wheel, one beside its discs.
  int left_face(int wheel) const;
  int right_face(int wheel) const;

  /// The track of a column.
  int centre(int column) const { return centres_[static_cast<std::size_t>(column)]; }

  const SchemeColumns& columns() const { return columns_; }

  /// Tracks and outer rows in which nothing stands or turns come together; from here on there are
  /// places.
  void close_up(const std::vector<bool>& is_used_track, const std::vector<bool>& is_used_row);

  double x(int track) const { return x_[static_cast<std::size_t>(track)]; }

  /// Of the broken line beside a column, counted from its wheels.
  int link_track(int column, int link) const { return centre(column) + 2 + link; }

  double height(int row) const { return heights_[static_cast<std::size_t>(row)]; }

  /// Of a cell that may lie one beside the grid; y downwards, 0 at the main axis.
  PixelPoint place(GridCell cell) const;

 private:
  void make_tracks();
  void make_rows();
  void add_near_rows(std::vector<double>& fixed) const;
  void find_scale();
  double track_width(int track, bool is_used) const;
  void add_rows_up_to(double height);

  const SchemeTrain& train_;
  const SchemeRadii& radii_;
  const SchemeColumns& columns_;
  bool is_developed_ = false;
  int axis_ = 0;
  double base_ = 0.0;
  int track_count_ = 0;
  std::vector<int> centres_;     // track of each column
  double scale_ = 1.0;           // [px] per unit of radius
  std::vector<double> heights_;  // of rows
  std::vector<double> x_;        // of tracks
  int inner_rows_ = 0;
};

}  // namespace kinestat
