#include "math/elimination/internal/row_eliminator.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "math/elimination/internal/modular_field.hpp"

namespace kinestat {
namespace {

struct Entry {
  int row = 0;
  int column = 0;
  PrimeField::Value value = 0;
};

FieldElimination<ModularField> load(int rows, const std::vector<Entry>& entries) {
  FieldElimination<ModularField> result{.field = {.prime = PrimeField(1, 1)}};
  result.load(rows, entries, [](PrimeField::Value value) { return value; });
  return result;
}

// The differences between neighbours of a chain whose ends are held: of n unknowns, n + 1 rows.
TEST(RowEliminator, KeepsTheRowsOfALongChainShort) {
  constexpr int kUnknowns = 5000;
  std::vector<Entry> entries;
  for (int i = 0; i < kUnknowns; ++i) {
    entries.push_back({.row = i, .column = i, .value = 3});
    entries.push_back({.row = i + 1, .column = i, .value = 5});
  }
  FieldElimination<ModularField> chain = load(kUnknowns + 1, entries);

  RowEliminator(chain, kUnknowns).run();

  EXPECT_EQ(chain.rank(), kUnknowns);
  EXPECT_TRUE(chain.free_columns.empty());
  EXPECT_LE(chain.products, 2 * kUnknowns);
}

TEST(RowEliminator, NamesTheColumnsWithoutAPivot) {
  FieldElimination<ModularField> matrix =
      load(3, {{0, 0, 1}, {0, 1, 2}, {1, 0, 2}, {1, 1, 4}, {2, 3, 1}});

  RowEliminator(matrix, 4).run();

  EXPECT_EQ(matrix.rank(), 2);
  ASSERT_EQ(matrix.free_columns.size(), 2U);
  EXPECT_EQ(matrix.free_columns[1], 2);
}

}  // namespace
}  // namespace kinestat
