// What the rows of a sweep ask of the motion of the file.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "mechanism/motion_figure.hpp"
#include "mechanism/motion_plan.hpp"
#include "studies/motion/task/motion_table_maker.hpp"
#include "studies/sweep/report/sweep_column.hpp"

namespace kinestat {

/// A figure of a column of the motion.
struct SweptFigure {
  std::string column;  ///< as the table of the motion names it, "d.wz/position"; of dead points the
                       ///< freedom, or empty: all
  MotionFigure figure = MotionFigure::range;
};

struct SweptMotion {
  std::vector<SweptFigure> figures;  ///< SweepColumn::index points here
  MotionReport report;               ///< what they need of every position
  MotionScope scope;                 ///< likewise, of the table
  bool is_of_case = false;           ///< the speeds or loads of a case decide some of them
  std::vector<int> cases;  ///< of each row of a state: index into Mechanism::cases, -1: none

  /// The case in which the mechanism of a row moves: empty for that of the file, where nothing that
  /// is asked for depends on it.
  std::optional<int> case_of(std::size_t row) const {
    return is_of_case && cases[row] >= 0 ? std::optional(cases[row]) : std::nullopt;
  }
};

/// Finds the columns of the motion that the names of a sweep stand for.
class MotionColumnSearch {
 public:
  /// `cases` are those of the rows, -1 for none. All must outlive it, and have a motion.
  MotionColumnSearch(const MechanismDescription& description,
                     const Mechanism& mechanism,
                     std::vector<int> cases,
                     Diagnostics& found);

  /// Empty iff an error was added: there is no such column, or a case does not say what it needs.
  std::optional<SweepColumn> find(const Name& name);

  /// What all that was found needs; empty iff an error was added, for a case does not say it.
  std::optional<SweptMotion> take();

 private:
  // One column that the table of the motion would have, and what asks for it.
  struct Candidate {
    std::string name;                 // "d.wz/position"
    std::string dotted;               // "d.wz.position"
    std::vector<std::string> others;  // "motor.position"
    std::string brief;                // "load" of "load/action"; may be empty
    std::string unit;
    MotionReport needs;
  };

  MotionPlan plan_of(int which) const;
  std::vector<Candidate> candidates_of(int which) const;
  void refuse_column(const Name& name, const std::string& column);
  bool lacks_case(const std::string& column);
  bool needs_case_of_its_own(const std::string& column);
  bool can_report(const MotionReport& report);
  std::optional<SweepColumn> find_dead_points(const Name& name, const MotionFigureName& asked);
  std::optional<SweepColumn> find_efficiency_of_whole(const Name& name);
  SweepColumn add(const Name& name, SweptFigure figure, std::string unit);

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  Diagnostics& found_;
  bool is_in_time_ = false;                         // in some case
  std::vector<std::optional<double>> positions_;    ///< of the freedoms, as drawn
  std::vector<int> watched_;                        ///< freedoms that have dead points
  std::vector<std::vector<Candidate>> candidates_;  ///< of each case
  SweptMotion asked_;
};

}  // namespace kinestat
