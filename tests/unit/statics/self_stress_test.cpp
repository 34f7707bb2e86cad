#include "statics/self_stress.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

using Terms = std::vector<std::pair<int, double>>;

Terms terms_of(const SelfStress& stress) {
  Terms terms;
  for (const DependenceTerm& term : stress.terms) {
    terms.emplace_back(term.index, term.coefficient);
  }
  return terms;
}

VecX vector_of(std::initializer_list<double> values) {
  return Eigen::Map<const VecX>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

TEST(SelfStress, BeginsWithOneAndLeavesZerosOut) {
  const std::vector<VecX> vectors = {vector_of({0.0, -4.0, 0.0, 2.0})};

  const auto list = list_self_stresses(vectors, VecX::Ones(4));

  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(terms_of(list[0]), (Terms{{1, 1.0}, {3, -0.5}}));
}

TEST(SelfStress, HasItsFirstActionForItselfAlone) {
  // Sums of the states (1, 0, -1, 0) and (0, 1, 0, 2).
  const std::vector<VecX> vectors = {vector_of({1.0, 1.0, -1.0, 2.0}),
                                     vector_of({2.0, -1.0, -2.0, -2.0})};

  const auto list = list_self_stresses(vectors, VecX::Ones(4));

  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(terms_of(list[0]), (Terms{{0, 1.0}, {2, -1.0}}));
  EXPECT_EQ(terms_of(list[1]), (Terms{{1, 1.0}, {3, 2.0}}));
}

TEST(SelfStress, KeepsSmallCouplesOfASmallMechanism) {
  // 1 N with couples of 1e-12 N·m, in a mechanism of 1e-12 m; and a couple that is rounding there.
  const std::vector<VecX> vectors = {vector_of({1.0, -1e-12, 1e-24})};

  const auto list = list_self_stresses(vectors, vector_of({1.0, 1e-12, 1e-12}));

  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(terms_of(list[0]), (Terms{{0, 1.0}, {1, -1e-12}}));
}

TEST(SelfStress, IsNotListedWhereThereAreTooManyToRead) {
  const std::vector<VecX> vectors(200, VecX::Ones(200));

  EXPECT_TRUE(list_self_stresses(vectors, VecX::Ones(200)).empty());
}

}  // namespace
}  // namespace kinestat
