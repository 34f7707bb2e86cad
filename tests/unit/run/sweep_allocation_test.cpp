// How often a state of a sweep allocates memory. In a program of its own, whose operator new
// counts.
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "studies/sweep/report/sweep_row_writer.hpp"
#include "unit/run/swept_file.hpp"

namespace {

long allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* const place = std::aligned_alloc(alignment, (size / alignment + 1) * alignment);
  if (place == nullptr) {
    throw std::bad_alloc();
  }
  return place;
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}

void* operator new(std::size_t size, const std::nothrow_t& /*nothrow*/) noexcept {
  try {
    return counted(size, alignof(std::max_align_t));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void operator delete(void* place, const std::nothrow_t& /*nothrow*/) noexcept {
  std::free(place);
}

// Inlined, g++ takes them for a mismatch with the operator new of the library.
[[gnu::noinline]] void operator delete(void* place) noexcept {
  std::free(place);
}

[[gnu::noinline]] void operator delete(void* place, std::size_t /*size*/) noexcept {
  std::free(place);
}

void operator delete(void* place, std::align_val_t /*alignment*/) noexcept {
  std::free(place);
}

void operator delete(void* place, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  std::free(place);
}

namespace kinestat {
namespace {

// Of the states after the first group, which is compared with an analysis.
long allocations_in(SweepTask& task, std::size_t lanes, RowFormat format = RowFormat::csv) {
  StateSolver solver(task, lanes);
  SweepRowWriter text(task.plan, task.cases, task.columns, format);
  StateWalk walk(task.plan, 0, task.plan.state_count());
  std::string rows;
  rows.reserve(1 << 20U);
  text.enter(solver.solve_next(walk).front().places);
  const long before = allocations;
  std::size_t count = 0;
  for (auto states = solver.solve_next(walk); !states.empty(); states = solver.solve_next(walk)) {
    for (const SolvedState& state : states) {
      ++count;
      rows.clear();
      text.enter(state.places);
      for (const SweepRow& row : state.rows) {
        EXPECT_EQ(row.status, "solved");
        text.append(row, rows);
      }
    }
  }
  EXPECT_GT(count, 300U);
  return allocations - before;
}

TEST(Sweep, AllocatesNothingForAState) {
  const long before = allocations;
  SweptFile file(kTrain,
                 "{vary: {S: {from: 15, to: 30, step: 1}, P: {from: 20, to: 40, step: 1}, "
                 "torque: [1 N*m, 3 N*m]}}");
  ASSERT_TRUE(file.task().tapes.has_value());
  ASSERT_GT(allocations, before);

  EXPECT_EQ(allocations_in(file.task(), kLanes), 0);
  EXPECT_EQ(allocations_in(file.task(), 1), 0);
  EXPECT_EQ(allocations_in(file.task(), kLanes, RowFormat::json), 0);
  EXPECT_EQ(allocations_in(file.task(), kLanes, RowFormat::npy), 0);
}

TEST(Sweep, AllocatesNothingWherePointsAreBoundForEachState) {
  const std::string text = kFourBar;
  const std::size_t at = text.find("at: [2, y]");
  SweptFile file(text.substr(0, at) + "at: [2, sqrt(y)*sqrt(y)]" + text.substr(at + 10),
                 "{vary: {y: {from: 1.5, to: 2, step: 0.001}}}");
  ASSERT_TRUE(file.task().tapes.has_value());
  ASSERT_TRUE(file.task().tapes->needs_geometry);

  EXPECT_EQ(allocations_in(file.task(), kLanes), 0);
}

}  // namespace
}  // namespace kinestat
