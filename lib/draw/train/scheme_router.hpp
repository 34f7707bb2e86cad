// Finds ways for shafts through a half section: lines along a grid that cross as little as
// possible.
#pragma once

#include <optional>
#include <vector>

namespace kinestat {

/// A place of the grid: column along the axis, row outwards.
struct GridCell {
  int column = 0;
  int row = 0;

  friend bool operator==(const GridCell&, const GridCell&) = default;
};

/// Lines of several nets on one grid. A net grows from what has been given to it; its lines turn
/// freely on free cells and cross those of others at right angles only, at a price. The same in
/// every run.
class SchemeRouter {
 public:
  SchemeRouter(int columns, int rows);

  int columns() const { return columns_; }

  int rows() const { return rows_; }

  /// Nothing passes there any more.
  void block(GridCell cell);

  /// Keeps a cell for a net; one that is kept `along` the axis can be crossed.
  void keep(GridCell cell, int net);
  void keep_along(GridCell cell, int net);

  /// A broken line outwards passes there, which is no shaft: lines along the axis cross it freely.
  void keep_aside(GridCell cell);

  /// The net grows from this cell, which has been kept for it.
  void start(GridCell cell) { is_tree_[index(cell)] = true; }

  /// Whether a net has grown to the cell.
  bool is_reached(GridCell cell) const { return is_tree_[index(cell)]; }

  bool is_free(GridCell cell) const;

  /// False also outside of the grid.
  bool is_free_within(GridCell cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < columns_ && cell.row < rows_ &&
           is_free(cell);
  }

  /// Of all cells, row by row: the price of a way from the net there; infinite where none is.
  std::vector<double> prices(int net) const;

  /// An end for a net, and what it costs beside the way to it, not less than nothing.
  struct End {
    GridCell cell;
    double price = 0.0;
  };

  /// Joins the cheapest of the ends to the net, and says which; empty if there is no way to any.
  std::optional<GridCell> connect(int net, const std::vector<End>& ends);

  std::size_t index(GridCell cell) const {
    return static_cast<std::size_t>(cell.row * columns_ + cell.column);
  }

  /// Straight lines between neighbouring cells that belong to the net.
  struct Step {
    GridCell from;
    GridCell to;
    int net = 0;
  };

  const std::vector<Step>& steps() const { return steps_; }

  int crossings() const { return crossings_; }

  /// The price of all lines so far.
  double price() const { return price_; }

 private:
  static constexpr int kFree = -1;
  static constexpr int kBlocked = -2;
  static constexpr int kAside = -3;

  struct Search;

  Search search(int net, const std::vector<End>& ends) const;

  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> along_;   // of each cell: the net whose line along the axis passes
  std::vector<int> across_;  // likewise of lines outwards
  std::vector<bool> is_tree_;
  std::vector<Step> steps_;
  int crossings_ = 0;
  double price_ = 0.0;
};

/// Room for a clutch: four cells along the axis, with nothing beside the two in the middle. Where
/// it stands over a shaft, nothing on the far side.
struct RouterGap {
  GridCell left;           ///< the first of the four
  bool is_turned = false;  ///< the first net is to come to the last one
};

/// Where the ways to both nets are shortest together; empty if there is no room.
std::optional<RouterGap> find_gap(const SchemeRouter& router,
                                  int net,
                                  int other,
                                  bool is_over_shaft);

}  // namespace kinestat
