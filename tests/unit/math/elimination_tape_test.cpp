#include "math/elimination_tape.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "math/elimination.hpp"

namespace kinestat {

namespace {

// 6 x 8 with about half of its entries, the rest for the two columns that are known.
SparseMatrix random_matrix(std::mt19937& random, const SparseMatrix* pattern) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  SparseMatrix matrix{.rows = 6, .columns = 8, .entries = {}};
  if (pattern != nullptr) {
    matrix.entries = pattern->entries;
    for (SparseEntry& entry : matrix.entries) {
      entry.value = number(random);
    }
    return matrix;
  }
  for (int r = 0; r < matrix.rows; ++r) {
    for (int c = 0; c < matrix.columns; ++c) {
      if (c == r || number(random) > 0.0) {
        matrix.add(r, c, number(random) + (c == r ? 2.0 : 0.0));
      }
    }
  }
  return matrix;
}

const std::vector<int> kLast = {6, 7};
const std::vector<int> kAll = {0, 1, 2, 3, 4, 5};

TEST(EliminationTape, FindsWhatEliminationFinds) {
  constexpr unsigned kSeed = 20261121;
  std::mt19937 random(kSeed);
  int played = 0;
  for (int i = 0; i < 50; ++i) {
    SCOPED_TRACE(i);
    const SparseMatrix first = random_matrix(random, nullptr);
    std::vector<bool> varies(first.entries.size());
    for (std::size_t e = 0; e < varies.size(); ++e) {
      varies[e] = random() % 2 == 0;
    }
    const auto tape = EliminationTape::record(first, varies, kLast, kAll);
    ASSERT_TRUE(tape.has_value());
    EliminationTape::Workspace workspace = tape->make_workspace();
    for (int k = 0; k < 20; ++k) {
      SparseMatrix second = random_matrix(random, &first);
      tape->reset(workspace);
      for (std::size_t e = 0; e < varies.size(); ++e) {
        if (varies[e]) {
          tape->set(workspace, e, second.entries[e].value);
        } else {
          second.entries[e].value = first.entries[e].value;
        }
      }
      if (!tape->eliminate(workspace)) {
        continue;
      }
      ++played;
      const std::vector<double> known = {0.75, -1.5};
      tape->solve(workspace, known);
      const Elimination elimination(second, kLast);
      const VecX x = elimination.solve(known, {}).x;
      for (const int c : kAll) {
        // Pivots of at least 1e-3 leave at least eight digits.
        EXPECT_NEAR(tape->unknown(workspace, c), x[c], 1e-8 * x.cwiseAbs().maxCoeff());
      }
    }
  }
  EXPECT_GT(played, 300);
}

TEST(EliminationTape, HasNoAnswerWhereAPivotVanishes) {
  SparseMatrix matrix{.rows = 2, .columns = 3, .entries = {}};
  matrix.add(0, 0, 1.0);
  matrix.add(0, 1, 1.0);
  matrix.add(0, 2, 1.0);
  matrix.add(1, 0, 1.0);
  matrix.add(1, 1, 2.0);
  const std::vector<int> last = {2};
  const std::vector<int> wanted = {0, 1};
  const auto tape =
      EliminationTape::record(matrix, {false, true, false, false, false}, last, wanted);
  ASSERT_TRUE(tape.has_value());
  EliminationTape::Workspace workspace = tape->make_workspace();

  // With 2 in place of 1 the first two columns depend on each other.
  for (const double value : {1.0, 3.0, 2.0, 2.0001, 1.0}) {
    SCOPED_TRACE(value);
    tape->reset(workspace);
    tape->set(workspace, 1, value);
    EXPECT_EQ(tape->eliminate(workspace), std::abs(value - 2.0) > 0.01);
  }
}

TEST(EliminationTape, IsNotRecordedWhereUnknownsStayOpenOrKnownOnesDepend) {
  SparseMatrix matrix{.rows = 2, .columns = 3, .entries = {}};
  matrix.add(0, 0, 1.0);
  matrix.add(1, 2, 1.0);
  const std::vector<int> last = {2};
  const std::vector<int> wanted = {0};

  EXPECT_FALSE(EliminationTape::record(matrix, {true, true}, last, wanted).has_value());
}

TEST(EliminationTape, TakesSurplusEquationsThatFollowFromOthers) {
  // The second row is twice the first.
  SparseMatrix matrix{.rows = 2, .columns = 2, .entries = {}};
  matrix.add(0, 0, 1.0);
  matrix.add(0, 1, 3.0);
  matrix.add(1, 0, 2.0);
  matrix.add(1, 1, 6.0);
  const std::vector<int> last = {1};
  const std::vector<int> wanted = {0};
  const auto tape = EliminationTape::record(matrix, {false, true, false, true}, last, wanted);
  ASSERT_TRUE(tape.has_value());
  EliminationTape::Workspace workspace = tape->make_workspace();

  tape->set(workspace, 1, 5.0);
  tape->set(workspace, 3, 10.0);
  ASSERT_TRUE(tape->eliminate(workspace));
  tape->solve(workspace, std::vector<double>{2.0});
  EXPECT_EQ(tape->unknown(workspace, 0), -10.0);

  tape->reset(workspace);
  tape->set(workspace, 1, 5.0);
  tape->set(workspace, 3, 10.5);
  EXPECT_FALSE(tape->eliminate(workspace));
}

}  // namespace

}  // namespace kinestat
