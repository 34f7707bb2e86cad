#include "math/elimination/elimination_tape.hpp"

#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "math/elimination/elimination.hpp"

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

// A matrix of which some entries are inputs of the tape, as are the known unknowns after them.
class Taped {
 public:
  Taped(const SparseMatrix& matrix,
        std::vector<bool> varies,
        const std::vector<int>& last,
        const std::vector<int>& wanted)
      : varies_(std::move(varies)), last_count_(last.size()) {
    LaneRecorder recorder;
    TapedMatrix taped{.rows = matrix.rows, .columns = matrix.columns, .entries = {}};
    for (std::size_t e = 0; e < matrix.entries.size(); ++e) {
      const SparseEntry& entry = matrix.entries[e];
      taped.entries.push_back(
          {.row = entry.row,
           .column = entry.column,
           .value = varies_[e] ? recorder.input(entry.value) : recorder.constant(entry.value)});
    }
    std::vector<TapedUnknown> known;
    for (const int column : last) {
      known.push_back({.column = column, .value = recorder.input(1.0)});
    }
    const auto unknowns = record_elimination(taped, known, wanted, recorder);
    if (unknowns) {
      tape_ = recorder.make_tape(*unknowns);
      workspace_ = tape_->make_workspace(1);
    }
  }

  bool is_recorded() const { return tape_.has_value(); }

  // Whether there is an answer for the entries that vary, taken from another matrix.
  bool play(const std::vector<double>& entries, const std::vector<double>& known) {
    std::size_t input = 0;
    for (std::size_t e = 0; e < varies_.size(); ++e) {
      if (varies_[e]) {
        tape_->set_input(workspace_, input++, 0, entries[e]);
      }
    }
    for (std::size_t i = 0; i < last_count_; ++i) {
      tape_->set_input(workspace_, input++, 0, known[i]);
    }
    tape_->play(workspace_);
    return tape_->is_met(workspace_, 0);
  }

  double unknown(std::size_t i) const { return tape_->output(workspace_, i, 0); }

 private:
  std::vector<bool> varies_;
  std::size_t last_count_;
  std::optional<LaneTape> tape_;
  LaneTape::Workspace workspace_;
};

std::vector<double> values_of(const SparseMatrix& matrix) {
  std::vector<double> values;
  for (const SparseEntry& entry : matrix.entries) {
    values.push_back(entry.value);
  }
  return values;
}

TEST(TapedElimination, FindsWhatEliminationFinds) {
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
    Taped taped(first, varies, kLast, kAll);
    ASSERT_TRUE(taped.is_recorded());
    for (int k = 0; k < 20; ++k) {
      SparseMatrix second = random_matrix(random, &first);
      for (std::size_t e = 0; e < varies.size(); ++e) {
        second.entries[e].value = varies[e] ? second.entries[e].value : first.entries[e].value;
      }
      const std::vector<double> known = {0.75, -1.5};
      if (!taped.play(values_of(second), known)) {
        continue;
      }
      ++played;
      const Elimination elimination(second, kLast);
      const VecX x = elimination.solve(known, {}).x;
      for (const int c : kAll) {
        // Pivots of at least 1e-3 leave at least eight digits.
        EXPECT_NEAR(
            taped.unknown(static_cast<std::size_t>(c)), x[c], 1e-8 * x.cwiseAbs().maxCoeff());
      }
    }
  }
  EXPECT_GT(played, 300);
}

TEST(TapedElimination, HasNoAnswerWhereAPivotVanishes) {
  SparseMatrix matrix{.rows = 2, .columns = 3, .entries = {}};
  matrix.add(0, 0, 1.0);
  matrix.add(0, 1, 1.0);
  matrix.add(0, 2, 1.0);
  matrix.add(1, 0, 1.0);
  matrix.add(1, 1, 2.0);
  Taped taped(matrix, {false, true, false, false, false}, {2}, {0, 1});
  ASSERT_TRUE(taped.is_recorded());

  // With 2 in place of 1 the first two columns depend on each other.
  for (const double value : {1.0, 3.0, 2.0, 2.0001, 1.0}) {
    SCOPED_TRACE(value);
    EXPECT_EQ(taped.play({0.0, value, 0.0, 0.0, 0.0}, {1.0}), std::abs(value - 2.0) > 0.01);
  }
}

TEST(TapedElimination, IsNotRecordedWhereUnknownsStayOpenOrKnownOnesDepend) {
  SparseMatrix matrix{.rows = 2, .columns = 3, .entries = {}};
  matrix.add(0, 0, 1.0);
  matrix.add(1, 2, 1.0);

  EXPECT_FALSE(Taped(matrix, {true, true}, {2}, {0}).is_recorded());
}

TEST(TapedElimination, TakesSurplusEquationsThatFollowFromOthers) {
  // The second row is twice the first.
  SparseMatrix matrix{.rows = 2, .columns = 2, .entries = {}};
  matrix.add(0, 0, 1.0);
  matrix.add(0, 1, 3.0);
  matrix.add(1, 0, 2.0);
  matrix.add(1, 1, 6.0);
  Taped taped(matrix, {false, true, false, true}, {1}, {0});
  ASSERT_TRUE(taped.is_recorded());

  ASSERT_TRUE(taped.play({1.0, 5.0, 2.0, 10.0}, {2.0}));
  EXPECT_EQ(taped.unknown(0), -10.0);
  EXPECT_FALSE(taped.play({1.0, 5.0, 2.0, 10.5}, {2.0}));
}

TEST(TapedElimination, DemandsGoodPivotsAlsoWhereNothingWantedDependsOnThem) {
  // Two equations of their own, of which the second has an answer for x unlike 0.
  SparseMatrix matrix{.rows = 2, .columns = 3, .entries = {}};
  matrix.add(0, 0, 1.0);
  matrix.add(0, 2, 1.0);
  matrix.add(1, 1, 1.0);
  Taped taped(matrix, {false, false, true}, {2}, {0});
  ASSERT_TRUE(taped.is_recorded());

  EXPECT_TRUE(taped.play({0.0, 0.0, 0.5}, {1.0}));
  EXPECT_FALSE(taped.play({0.0, 0.0, 0.0}, {1.0}));
}

}  // namespace

}  // namespace kinestat
