// The rows of a sweep, by its tape and by whole analyses.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/tolerance.hpp"
#include "studies/sweep/task/state_solver.hpp"

namespace kinestat {

struct Row {
  std::uint64_t state = 0;
  std::string status;
  std::vector<double> values;
};

inline std::vector<Row> rows_of(const SweepTask& task, std::size_t lanes, std::uint64_t begin = 0) {
  StateSolver solver(task, lanes);
  StateWalk walk(task.plan, begin, task.plan.state_count());
  std::vector<Row> rows;
  for (auto states = solver.solve_next(walk); !states.empty(); states = solver.solve_next(walk)) {
    for (const SolvedState& state : states) {
      for (const SweepRow& row : state.rows) {
        rows.push_back(
            {.state = state.number, .status = std::string(row.status), .values = row.values});
      }
    }
  }
  return rows;
}

inline std::vector<Row> analysed_rows(SweepTask& task) {
  const auto tapes = std::exchange(task.tapes, std::nullopt);
  std::vector<Row> rows = rows_of(task, 1);
  task.tapes = tapes;
  return rows;
}

inline void expect_same_bits(const std::vector<Row>& a, const std::vector<Row>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t r = 0; r < a.size(); ++r) {
    EXPECT_EQ(a[r].state, b[r].state);
    EXPECT_EQ(a[r].status, b[r].status);
    EXPECT_TRUE(std::ranges::equal(a[r].values, b[r].values, [](double x, double y) {
      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) ||
             (std::isnan(x) && std::isnan(y));
    })) << a[r].state;
  }
}

// By the largest of the row that is of the same kind at most.
inline void expect_near(const std::vector<Row>& a, const std::vector<Row>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t r = 0; r < a.size(); ++r) {
    SCOPED_TRACE(a[r].state);
    EXPECT_EQ(a[r].status, b[r].status);
    double largest = 0.0;
    for (const double value : b[r].values) {
      largest = std::isnan(value) ? largest : std::max(largest, std::abs(value));
    }
    for (std::size_t q = 0; q < a[r].values.size(); ++q) {
      const double x = a[r].values[q];
      const double y = b[r].values[q];
      EXPECT_TRUE(std::isnan(x) == std::isnan(y) &&
                  (std::isnan(x) || std::abs(x - y) <= kReportsAgree * largest))
          << q << ": " << x << " " << y;
    }
  }
}

/// How many states the tape itself answers.
inline std::size_t taped_states(const SweepTask& task) {
  TapeSolver taped(task, *task.tapes, 1);
  std::vector<SweepRow> rows(task.cases.size(),
                             {.values = std::vector<double>(task.columns.size())});
  StateWalk walk(task.plan, 0, task.plan.state_count());
  std::size_t count = 0;
  while (walk.next()) {
    if (!walk.is_undefined()) {
      taped.load(walk, 0);
      taped.play();
      taped.fill(1, rows);
      count += taped.has_answer(0) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace kinestat
